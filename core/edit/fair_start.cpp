#include "edit/fair_start.h"

#include <cmath>
#include <utility>

#include "base/angle.h"
#include "net/measures.h"
#include "solve/parts/length_projection.h"
#include "solve/terms/bending_term.h"
#include "solve/terms/closeness_term.h"
#include "solve/terms/load_terms.h"
#include "solve/terms/penalty_term.h"
#include "solve/terms/tip_term.h"

namespace chebnet {

namespace {

// Beside bending: stiff enough for edges to come within some percent of their length.
constexpr double k_stiffness = 300;
// Of bending, that of rods as they are laid: with less there are tips at singular vertices, with more lines waver.
constexpr double k_laid = 0.5;
// The limit aims higher by so much, since corners give way.
constexpr double k_limit_margin = 2 * k_degree;
// In edge lengths: no vertex moves farther in a step; a step shorter than this is the last.
constexpr double k_most_move = 0.5, k_short_step = 0.03;
constexpr int k_most_steps = 40, k_most_projections = 25;
constexpr double k_much_growth = 1e-4;  // of the unit: terms, which depend on it, are made anew

}  // namespace

FairStart::FairStart(const Net& net, const Topology& topology, const Guide& guide, Positions positions, Options options)
    : m_net(net),
      m_topology(topology),
      m_guide(guide),
      m_options(std::move(options)),
      m_laid(m_options.unit * positions),
      m_positions(std::move(positions)),
      m_is_free(free_vertices(net.vertex_count(), m_options.fixed)),
      m_part(net, m_is_free),
      m_descent(net, topology, m_part) {
    choose_terms();
}

void FairStart::choose_terms() {
    m_terms.clear();
    const double unit = m_options.unit, laid = m_options.rods == Rods::as_laid ? k_laid : 0;
    const auto add_bending = [&](double weight, BendingTerm::Reference reference) {
        m_terms.push_back(std::make_unique<BendingTerm>(m_net, m_topology, m_laid / unit, weight, reference));
    };
    add_bending(1 - laid, BendingTerm::Reference::straight);
    if (laid > 0) add_bending(laid, BendingTerm::Reference::rest);
    if (m_options.tip_weight > 0) m_terms.push_back(std::make_unique<TipTerm>(m_net, m_topology, m_options.tip_weight));
    m_terms.push_back(make_closeness_term(m_net, m_guide, unit, closeness_for(m_options.rods, m_net.face_count()),
                                          ClosenessTerm::Side::both));
    m_terms.push_back(std::make_unique<PullTerm>(m_net, m_options.pulls));
    m_terms.push_back(std::make_unique<PenaltyTerm>(edge_lengths(m_net), k_stiffness));
    if (m_options.shear_limit > 0)
        m_terms.push_back(std::make_unique<PenaltyTerm>(
            chebnet::shear_limit(m_net, m_options.shear_limit + k_limit_margin), k_stiffness));
}

void FairStart::set_pulls(std::vector<Pull> pulls) {
    m_options.pulls = std::move(pulls);
    choose_terms();
}

bool FairStart::step() {
    const double L = m_net.mean_length();
    const double moved = m_descent.step(m_terms, k_most_move * L, m_positions);
    if (m_options.size == Size::by_lengths) fit_lengths();
    if (m_options.size == Size::by_places) fit_places();
    return ++m_steps < k_most_steps && moved > k_short_step * L;
}

/// All stays where it is.
void FairStart::set_unit(double unit) {
    const double ratio = unit / m_options.unit;
    m_positions /= ratio;
    for (Pull& pull : m_options.pulls) pull.target /= ratio;
    m_options.unit = unit;
    choose_terms();
}

void FairStart::fit_lengths() {
    const double ratio = edge_ratios(m_net, m_positions).mean();
    if (std::abs(ratio - 1) > k_much_growth) set_unit(ratio * m_options.unit);
}

/// By least squares over the vertices of all pieces, each of which grows about its centre, and its edges with it.
void FairStart::fit_places() {
    Positions centres(3, m_positions.cols());
    for (const std::vector<int>& piece : m_topology.components()) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const int v : piece) sum += m_positions.col(v);
        for (const int v : piece) centres.col(v) = sum / static_cast<double>(piece.size());
    }
    const Positions shape = m_positions - centres;
    const double ratio = shape.cwiseProduct(m_laid).sum() / (m_options.unit * shape.squaredNorm());
    if (!(ratio > 0) || std::abs(ratio - 1) <= k_much_growth) return;
    set_unit(ratio * m_options.unit);
    m_positions = shape + centres / ratio;
}

bool FairStart::make_exact(double threshold) {
    LengthProjection lengths(m_net, m_topology);
    lengths.set_free(m_is_free);
    Positions x = m_positions;
    bool is_net = false;
    double best = threshold;
    for (int k = 0; k < k_most_projections && lengths.project(x); ++k) {
        const double deviation = max_deviation(m_net, x);
        if (deviation < best) {
            m_positions = x;
            best = deviation;
            is_net = true;
        } else if (is_net) {
            break;
        }
    }
    return is_net;
}

}  // namespace chebnet
