#include "solve/parts/net_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "net/measures.h"

namespace chebnet {

namespace {

// Nets are projected until no length errs by more than this part, dL < 1e-10, or by less if the threshold asks for it.
constexpr double k_exact_error = 1e-5;
constexpr int k_most_projections = 15, k_patience = 4;  // in all, and without coming closer
// The same where lengths are come to however slowly.
constexpr int k_most_patient_projections = 60, k_long_patience = 20;
// How often corners may join those that are held in one projection.
constexpr int k_most_openings = 6;

}  // namespace

NetConstraints::NetConstraints(const Net& net, const Topology& topology, CornerLimit limit,
                               const std::vector<bool>& is_free, std::span<const Slide> slides,
                               std::span<const Pull> pulls, const Positions& positions)
    : m_net(net),
      m_topology(topology),
      m_limit(std::move(limit)),
      m_is_free(is_free),
      m_slides(slides.begin(), slides.end()),
      m_pulls(pulls.begin(), pulls.end()) {
    watch(positions);
}

void NetConstraints::set_free(const std::vector<bool>& is_free, std::span<const Slide> slides,
                              std::span<const Pull> pulls) {
    m_is_free = is_free;
    m_slides.assign(slides.begin(), slides.end());
    m_pulls.assign(pulls.begin(), pulls.end());
    set_free();
}

void NetConstraints::set_free() {
    m_lengths->system().set_free(m_is_free, m_slides);
    for (const Pull& pull : m_pulls)
        if (std::isinf(pull.yields)) m_lengths->set_mobility(pull.vertex, 1 / (1 + pull.weight));
}

/// A system with rows for the corners that are sharp now.
void NetConstraints::watch(const Positions& positions) {
    m_limit.watch(positions);
    m_lengths = std::make_unique<LengthProjection>(m_net, m_topology, m_limit.watched());
    set_free();
    m_limit.apply(m_lengths->system());
    m_lengths->system().assemble(positions);
}

bool NetConstraints::project(Positions& positions, double threshold) {
    for (int round = 0; round < k_most_openings; ++round) {
        if (!project_lengths(positions, threshold)) return false;
        if (m_limit.needs_more_rows(positions)) watch(positions);
        if (m_limit.hold_short_ones(positions) == 0) break;
        m_limit.apply(m_lengths->system());
    }
    return max_deviation(m_net, positions) < threshold || project_lengths(positions, threshold);
}

bool NetConstraints::project_lengths(Positions& positions, double threshold) {
    const double exact_error = std::min(k_exact_error, std::sqrt(threshold) / 2);
    double best = std::numeric_limits<double>::infinity();
    const int most = m_is_patient ? k_most_patient_projections : k_most_projections;
    const int most_idle = m_is_patient ? k_long_patience : k_patience;
    m_lengths->system().assemble(positions);
    for (int k = 0, patience = most_idle; k < most && patience > 0; ++k, --patience) {
        if (!m_lengths->project_assembled(positions)) return false;
        m_lengths->system().assemble(positions);
        const double error = m_lengths->system().errors().lpNorm<Eigen::Infinity>();
        if (error < exact_error) break;
        if (error < best / 2) patience = most_idle;
        best = std::min(best, error);
    }
    return max_deviation(m_net, positions) < threshold;
}

void NetConstraints::hold(const std::vector<double>& held) {
    m_limit.set_held(held);
    m_limit.apply(m_lengths->system());
}

void NetConstraints::hold_closer(const std::vector<double>& held, double part) {
    m_limit.set_held(held);
    m_limit.approach(held, part);
    m_limit.apply(m_lengths->system());
}

bool NetConstraints::hold_blocking_ones(const Positions& positions, const Eigen::Matrix3Xd& move) {
    if (m_limit.is_blocked_by_unwatched(positions, move)) watch(positions);
    if (m_limit.hold_blocking_ones(positions, move) == 0) return false;
    m_limit.apply(m_lengths->system());
    return true;
}

bool NetConstraints::release(const Eigen::VectorXd& multipliers, bool one_only) {
    if ((one_only ? m_limit.release_one(multipliers) : m_limit.release(multipliers)) == 0) return false;
    m_limit.apply(m_lengths->system());
    return true;
}

void NetConstraints::release_early_ones() {
    if (m_limit.release_early_ones() > 0) m_limit.apply(m_lengths->system());
}

}  // namespace chebnet
