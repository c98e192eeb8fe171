#include "remesh/net_trials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "drape/tilt.h"
#include "net/measures.h"
#include "remesh/border_distance.h"
#include "remesh/fit.h"
#include "remesh/wish_pulls.h"

namespace chebnet {

namespace {

// Where a field leads to no net, others are tried, smoother and less smooth ones, then cells of other sizes.
constexpr std::array<double, 3> k_smoothings = {1, 0.3, 3};
constexpr std::array<double, 7> k_sizes = {1, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5};
constexpr double k_least_size_for_length = 0.9;
// So many nets with corners beyond the limit, or other singular vertices than those wished for, are enough.
constexpr int k_most_lesser_nets = 2, k_most_of_length = 4;
// A net of a given length may have too few cells for the surface, and shrinks within it then, or too many: where it is
// farther from it than this, in edges, on average, another number of cells may fit.
constexpr double k_good_distance = 0.15;
// Where a net is crumpled whose border is held, one is better that has fewer folds by this factor, if its border is no
// farther off, in edges, on average.
constexpr int k_far_fewer_folds = 3;
constexpr double k_loose_border = 0.5;

}  // namespace

std::optional<TriedNet> NetTrials::best() {
    if (find_good()) return std::move(m_tried.back());
    const auto best = std::min_element(m_tried.begin(), m_tried.end(), [this](const TriedNet& a, const TriedNet& b) {
        return std::tuple(a.kept.missed(), !keeps_limit(a), a.distance) <
               std::tuple(b.kept.missed(), !keeps_limit(b), b.distance);
    });
    if (best == m_tried.end()) return std::nullopt;
    return std::move(*best);
}

std::optional<TriedNet> NetTrials::good() {
    std::optional<TriedNet> found;
    if (find_good()) found = std::move(m_tried.back());
    m_tried.clear();
    m_first_failure.clear();
    return found;
}

std::optional<Net> NetTrials::small() {
    try {
        return fitted(m_mesher.small_mesh(), 0, {}).net;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::too_large) throw;
        return std::nullopt;
    }
}

void NetTrials::refuse() const {
    if (m_too_many_lines) throw Error(*m_too_many_lines);
    throw Error(ErrorCode::bad_option,
                (m_mesher.wishes() ? "no net was found with singular vertices as they are wished for; other wishes or "
                                     "smaller cells may lead to one"
                                   : "cells of this size do not cover the surface; smaller ones may") +
                    (m_first_failure.empty() ? "" : ": " + m_first_failure));
}

/// The last of those tried, then.
bool NetTrials::find_good() {
    m_mesher.hold_lines(m_mesher.has_lines());
    if (m_mesher.has_lines() && try_with_lines()) return true;
    m_mesher.hold_lines(false);
    return m_tried.empty() && try_all();
}

/// Lines can be too many for a grid, which has an end without them.
bool NetTrials::try_with_lines() {
    try {
        return try_all();
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        m_too_many_lines = error;
        return false;
    }
}

bool NetTrials::try_all() {
    m_is_uneven = false;
    if (m_mesher.may_turn() && try_once(1, m_options.smoothing, true)) return true;
    const auto try_field = [this](double size, double smoothing) {
        return try_once(size, smoothing * m_options.smoothing, false);
    };
    const auto try_sizes = [&](double smoothing) {
        return std::any_of(k_sizes.begin(), k_sizes.end(), [&](double size) { return try_field(size, smoothing); });
    };
    // Where the singular vertices are given, so is the field.
    const bool is_given = m_mesher.wishes() && m_mesher.wishes()->only;
    const std::span<const double> smoothings(k_smoothings.data(), is_given ? 1 : k_smoothings.size());
    const auto try_smoothings = [&](double size) {
        return std::any_of(smoothings.begin(), smoothings.end(),
                           [&](double smoothing) { return try_field(size, smoothing); });
    };
    // What a given length lacks are cells, rather than smoothness.
    return m_options.length > 0 ? std::any_of(smoothings.begin(), smoothings.end(), try_sizes)
                                : std::any_of(k_sizes.begin(), k_sizes.end(), try_smoothings);
}

/// Whether the last net found is as it should be.
bool NetTrials::try_once(double size, double smoothing, bool turns) {
    if (m_is_uneven || std::ssize(m_tried) == (m_options.length > 0 ? k_most_of_length : k_most_lesser_nets))
        return false;
    if (m_options.length > 0 && size < k_least_size_for_length) return false;
    try {
        const Mesh mesh = m_mesher.mesh_along(size, smoothing, turns);
        m_is_uneven = is_uneven(mesh);
        if (m_is_uneven) return false;
        TriedNet found = fitted(mesh, m_options.length, {});
        if (std::optional<TriedNet> other = with_loose_border(mesh, found)) found = std::move(*other);
        if (std::optional<TriedNet> other = following_creases(mesh, found)) found = std::move(*other);
        m_tried.push_back(std::move(found));
        const TriedNet& last = m_tried.back();
        const bool fits = m_options.length == 0 || last.distance <= k_good_distance;
        return keeps_limit(last) && last.kept.missed() == 0 && fits;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::too_large) throw;
        // What is said of a mesh on the way says nothing to who has never seen it.
        if (m_first_failure.empty() && error.code() == ErrorCode::bad_option) m_first_failure = error.what();
    }
    return false;
}

/// `length`: of all edges; 0: the one that fits.
TriedNet NetTrials::fitted(const Mesh& mesh, double length, Lines lines) {
    m_clock.begin(RemeshPhase::fit);
    const FitOptions options{length,
                             m_options.smallest_angle,
                             wish_pulls(mesh, m_options.singular, m_guide->tree(), m_mesher.cell()),
                             m_mesher.creases().segments(),
                             lines.suits_creases,
                             lines.lets_border_go ? std::vector<bool>() : m_mesher.held_border(m_guide->surface())};
    Net net = fit_net(m_guide, mesh, options, [this](double done) { m_clock.tell(done); });
    std::vector<SingularVertex> singular = singular_vertices(net);
    KeptWishes kept = kept_wishes(net, singular, m_options.singular);
    for (const Positions& way : m_mesher.creases().marked) kept.creases.push_back(distance_along(net, way));
    const double distance = distance_to(*m_guide, net, net.rest_positions()).mean / net.mean_length();
    return {std::move(net), std::move(singular), std::move(kept), distance};
}

/// A border with steps about as large as a cell may be longer or shorter than as many edges, and crumples the net where
/// each of its corners is held. One whose border may stand off from it a little is taken if it has far fewer folds.
std::optional<TriedNet> NetTrials::with_loose_border(const Mesh& mesh, const TriedNet& found) {
    if (m_mesher.held_border(m_guide->surface()).empty()) return std::nullopt;
    const int folds = crumpled_edges(*m_guide, found.net);
    if (folds == 0) return std::nullopt;
    try {
        TriedNet other = fitted(mesh, m_options.length, {.lets_border_go = true});
        const bool is_smooth = k_far_fewer_folds * crumpled_edges(*m_guide, other.net) <= folds;
        const bool is_near = border_distance(m_guide->surface(), other.net) <= k_loose_border * other.net.mean_length();
        const bool keeps_as_much =
            other.kept.missed() <= found.kept.missed() && keeps_limit(other) >= keeps_limit(found);
        if (is_smooth && is_near && keeps_as_much) return other;
    } catch (const Error&) {  // that mesh fits no other way
    }
    return std::nullopt;
}

/// Where marked creases are not followed, a net whose length suits them may do so.
std::optional<TriedNet> NetTrials::following_creases(const Mesh& mesh, const TriedNet& found) {
    if (m_options.length > 0 || std::all_of(found.kept.creases.begin(), found.kept.creases.end(), is_followed))
        return std::nullopt;
    try {
        TriedNet other = fitted(mesh, m_options.length, {.suits_creases = true});
        if (other.kept.missed() < found.kept.missed()) return other;
    } catch (const Error&) {  // that length fits nothing else
    }
    return std::nullopt;
}

bool NetTrials::is_uneven(const Mesh& mesh) const {
    return std::isfinite(m_most_error) && evened_error(m_guide, mesh, m_options.smallest_angle) > m_most_error;
}

bool NetTrials::keeps_limit(const TriedNet& found) const {
    const double smallest = corner_angle_range(found.net, found.net.rest_positions()).smallest;
    return smallest >= m_options.smallest_angle - k_limit_tolerance;
}

}  // namespace chebnet
