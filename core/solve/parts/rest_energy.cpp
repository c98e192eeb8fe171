#include "solve/parts/rest_energy.h"

#include <algorithm>
#include <tuple>

#include "base/angle.h"
#include "net/families.h"
#include "solve/terms/bending_term.h"
#include "solve/terms/closeness_term.h"
#include "solve/terms/load_terms.h"
#include "solve/terms/penalty_term.h"
#include "solve/terms/shear_term.h"
#include "solve/terms/tip_term.h"

namespace chebnet {

namespace {

// Shear is reckoned from no corner sharper than this, even without a limit.
constexpr double k_least_open_angle = 15 * k_degree;
// A guide that holds, or keeps out, weighs so many times as much as one that draws.
constexpr double k_hold = 100;
// The weight of a limit that gives way: so much that corners share what it has to give.
constexpr double k_yielding_limit = 10;

BendingTerm::Reference bending_reference(const Options& options) {
    if (options.rod_curvature != 0) return BendingTerm::Reference::curved;
    return options.straight_rods ? BendingTerm::Reference::straight : BendingTerm::Reference::rest;
}

ShearTerm::Reference shear_reference(const Options& options) {
    return options.square_corners ? ShearTerm::Reference::right_angles : ShearTerm::Reference::rest;
}

/// E, or empty if all are alike. The weight of shear is one: the diagonals of a quad lie between both families.
std::vector<double> stiffness_of_edges(const Net& net, const Options& options) {
    if (options.warp_stiffness == 1 && options.weft_stiffness == 1) return {};
    std::vector<double> stiffness;
    for (const int family : edge_families(net).value_or(std::vector<int>()))
        stiffness.push_back(family == 0 ? options.warp_stiffness : options.weft_stiffness);
    return stiffness;
}

std::unique_ptr<Term> closeness(const Net& net, const Guide& guide, double unit, const Options& options) {
    const GuideMode mode = options.guide_mode;
    const double shared = mode == GuideMode::outside ? 1 : k_guided_vertices / net.vertex_count();
    const double weight = (mode == GuideMode::near ? 1 : k_hold) * shared * options.guide_weight;
    const auto side = mode == GuideMode::outside ? ClosenessTerm::Side::below : ClosenessTerm::Side::both;
    return make_closeness_term(net, guide, unit, weight, side);
}

}  // namespace

bool RestEnergy::is_the_same(const Options& a, const Options& b) {
    const auto asked = [](const Options& o) {
        return std::tuple(o.shear_limit, o.bending_weight, o.shear_weight, o.tip_weight, o.straight_rods,
                          o.rod_curvature, o.warp_stiffness, o.weft_stiffness, o.square_corners, o.gravity, o.y_up,
                          o.guide_mode, o.guide_weight);
    };
    return asked(a) == asked(b);
}

bool RestEnergy::is_guided(const Options& options, const Guide* guide) {
    return guide != nullptr && options.guide_mode != GuideMode::off;
}

bool RestEnergy::is_least_at_rest_shape(const Options& options, std::span<const Pull> pulls, const Guide* guide) {
    return pulls.empty() && !is_guided(options, guide) && options.gravity == 0 && options.tip_weight == 0 &&
           !options.straight_rods && options.rod_curvature == 0 && !options.square_corners;
}

void RestEnergy::choose(const Net& net, const Topology& topology, const Positions& rest_shape, const Options& options,
                        std::span<const Pull> pulls, const Guide* guide, double unit,
                        const std::vector<bool>& weightless, Limit limit) {
    const double open_angle = std::max(options.shear_limit, k_least_open_angle);
    m_terms.clear();
    m_terms.push_back(std::make_unique<BendingTerm>(net, topology, rest_shape, options.bending_weight,
                                                    bending_reference(options), stiffness_of_edges(net, options),
                                                    options.rod_curvature * unit));
    m_terms.push_back(
        std::make_unique<ShearTerm>(net, rest_shape, options.shear_weight, shear_reference(options), open_angle));
    if (options.tip_weight > 0) m_terms.push_back(std::make_unique<TipTerm>(net, topology, options.tip_weight));
    if (options.gravity > 0)
        m_terms.push_back(
            std::make_unique<GravityTerm>(net, options.gravity, -Eigen::Vector3d::Unit(up_axis(options)), weightless));
    if (is_guided(options, guide)) m_terms.push_back(closeness(net, *guide, unit, options));
    if (limit == Limit::gives_way) m_terms.push_back(make_yielding_limit(net, options.shear_limit, k_yielding_limit));
    if (!pulls.empty()) m_terms.push_back(std::make_unique<PullTerm>(net, pulls));
}

void RestEnergy::move_pulls(const Net& net, std::span<const Pull> pulls) {
    if (!pulls.empty()) m_terms.back() = std::make_unique<PullTerm>(net, pulls);
}

double RestEnergy::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    gradient.setZero(3, x.cols());
    m_values.clear();
    double energy = 0;
    for (const auto& term : m_terms) energy += m_values.emplace_back(term->evaluate(x, gradient));
    return energy;
}

}  // namespace chebnet
