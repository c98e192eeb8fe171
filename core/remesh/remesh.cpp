#include "remesh/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "drape/drape.h"
#include "net/measures.h"
#include "net/topology.h"
#include "remesh/border_distance.h"
#include "remesh/border_sides.h"
#include "remesh/cell_mesh.h"
#include "remesh/cells.h"
#include "remesh/connection.h"
#include "remesh/creases.h"
#include "remesh/direction_field.h"
#include "remesh/even_triangles.h"
#include "remesh/fewer_singular.h"
#include "remesh/fit.h"
#include "remesh/grid_map.h"
#include "remesh/one_piece.h"
#include "remesh/pinholes.h"
#include "remesh/rows.h"
#include "remesh/tilt.h"
#include "surface/smoothed_surface.h"

namespace chebnet {

namespace {

// Of the triangles' edges, in edge lengths of the net.
constexpr double k_triangle_length = 0.9;
// Edges of the net are longer than the cells of the grid by about this, for they are sheared.
constexpr double k_stretch = 1.05;
// One round of smoothing for so many vertices: so it reaches as far on the surface, however small the cells are.
constexpr double k_vertices_a_round = 600;
constexpr double k_most_smoothing = 100;
// Where a field leads to no net, others are tried, smoother and less smooth ones, then cells of other sizes.
constexpr std::array<double, 3> k_smoothings = {1, 0.3, 3};
constexpr std::array<double, 7> k_sizes = {1, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5};
constexpr double k_least_size_for_length = 0.9;
// So many nets with corners beyond the limit, or other singular vertices than those wished for, are enough.
constexpr int k_most_lesser_nets = 2, k_most_of_length = 4;
// A singular vertex farther from where one is wished for, in cells, is another one.
constexpr double k_near = 3;
// A singular vertex is drawn so far out of forbidden regions, in cells, as fitting may move it.
constexpr double k_clear = 0.5;
// By which one is drawn to its place, or out of such a region, beside edges that weigh 1 (see Pull).
constexpr double k_pull = 10, k_pull_clear = 30;
// Ways to end at the border are told apart by nets of so many cells, or of those asked for if they are no more.
constexpr int k_trial_cells = 1500;
// How many singular vertices a net can do without is tried with so many cells, and how far it may be away from the
// surface for it, in edges, on average.
constexpr int k_fewest_cells = 800;
constexpr double k_fewest_distance = 0.2, k_none_distance = 0.1;
// Nor may its cells be tilted more against the surface than this, in radians, or, where that surface is rough, by this
// factor more than those of such a net with the usual singular vertices: it would be crumpled.
constexpr double k_smooth_tilt = 10 * std::numbers::pi / 180, k_most_tilted = 1.1;
// A field that nothing holds is as smooth turned by any angle up to 90°. So many are tried, with k_fewest_cells.
constexpr int k_turns_tried = 4;
// Only what is clearly better is worth another angle or another net, and survives rounding.
constexpr double k_clearly_less = 0.95;
// What counts against a net, where a mean distance of one edge from the surface counts 1: area that is not covered, of
// all; the mean distance of the borders, in edges; what the smallest corner lacks of an open one, in radians; how much
// cells are tilted against the surface, in radians, on average; borders of gaps and crumpled edges, by their length,
// where that of a net line across all of the net counts 1. A net with less than k_good_cost in all needs no rival.
constexpr double k_gap_weight = 5, k_border_weight = 0.05, k_sharp_weight = 0.1, k_tilt_weight = 1;
constexpr double k_open_weight = 0.1, k_fold_weight = 1;
constexpr double k_good_cost = 0.08;
// A net of a given length may have too few cells for the surface, and shrinks within it then, or too many: where it is
// farther from it than this, in edges, on average, another number of cells may fit.
constexpr double k_good_distance = 0.15;
constexpr double k_open_angle = 40 * std::numbers::pi / 180;
// Of a cell, in the surface's unit, or its inverse: beyond it lengths are lost beside numbers that have no unit.
constexpr double k_largest_cell = 1e15;
// With more the grid takes too long, and would not be worth much.
constexpr int k_most_singular_vertices = 600;
// A surface whose triangles are inclined by more than this to those of the surface that is smoothed over a cell is
// rough, in radians, on average. What is larger than cells of so many is shape rather than noise.
constexpr double k_rough_tilt = 7 * std::numbers::pi / 180, k_fewest_smoothing_cells = 1500;
constexpr double k_farthest_smoothing = 5;  // in cells
constexpr int k_wish_digits = 4;            // of coordinates in messages
constexpr int k_sides = 4;                  // of a cell

int piece_count(const Surface& surface) {
    const std::vector<int> pieces = surface.components();
    return 1 + *std::max_element(pieces.begin(), pieces.end());
}

double cells_asked_for(const Surface& surface, const RemeshOptions& options) {
    return options.length > 0 ? surface.area() / options.length / options.length : options.cells;
}

bool has_border(const Surface& surface) {
    for (int s = 0; s < 3 * surface.face_count(); ++s)
        if (surface.opposite(s) < 0) return true;
    return false;
}

/// A net cannot follow what is smaller than its cells, and crumples where it is held near that: a rough surface is
/// smoothed over a cell, or farther, until that tilts it no more. Creases stay.
std::shared_ptr<const Guide> without_noise(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                                           const std::function<void()>& go_on) {
    if (options.crease > 0 || !options.marked_creases.empty()) return guide;
    const Surface& surface = guide->surface();
    const double cells = std::max(k_fewest_smoothing_cells, cells_asked_for(surface, options));
    const double cell = std::sqrt(surface.area() / cells);
    std::optional<Surface> smooth;
    try {
        for (double radius = cell; radius < k_farthest_smoothing * cell; radius *= 2) {
            Surface smoother = smoothed(surface, radius, go_on);
            if (mean_tilt(smooth ? *smooth : surface, smoother) < k_rough_tilt) break;
            smooth = std::move(smoother);
        }
    } catch (const Error&) {  // triangles that vanish
    }
    return smooth ? std::make_shared<const Guide>(*std::move(smooth)) : guide;
}

/// A hole that is smaller than a cell is none for a net.
std::shared_ptr<const Guide> without_small_holes(const std::shared_ptr<const Guide>& guide,
                                                 const RemeshOptions& options) {
    const Surface& surface = guide->surface();
    const double cell = std::sqrt(surface.area() / cells_asked_for(surface, options));
    std::optional<Surface> closed = without_pinholes(surface, k_sides * cell);
    return closed ? std::make_shared<const Guide>(*std::move(closed)) : guide;
}

using Border = RemeshOptions::Border;

/// By one way to end at the border.
class Remesher {
public:
    Remesher(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, const RemeshProgress& progress)
        : m_guide(guide), m_surface(guide->surface()), m_options(options), m_progress(progress) {
        m_cell = options.length > 0 ? options.length / k_stretch : std::sqrt(m_surface.area() / options.cells);
    }

    Remesh run() {
        begin(RemeshPhase::triangles);
        m_creases = find_creases(m_guide, m_options.crease, m_options.marked_creases);
        m_even.emplace(even_triangles(m_creases.guide->surface(), m_creases.guide->tree(), k_triangle_length * m_cell,
                                      m_creases.sides));
        if (!m_options.singular.is_empty()) m_wishes = placer().placed(m_options.singular, m_guide->tree());
        m_has_border = has_border(m_surface);
        if (std::optional<Found> found = find_with_fewer()) return result(*found);
        if (std::optional<Found> best = find_net()) return result(*best);
        if (m_too_many_lines) throw Error(*m_too_many_lines);
        throw Error(
            ErrorCode::bad_option,
            (m_wishes ? "no net was found with singular vertices as they are wished for; other wishes or smaller "
                        "cells may lead to one"
                      : "cells of this size do not cover the surface; smaller ones may") +
                (m_first_failure.empty() ? "" : ": " + m_first_failure));
    }

private:
    void begin(RemeshPhase phase) {
        if (m_is_trying) return;
        end_phase();
        m_phase = phase;
        tell(0);
    }
    void end_phase() {
        m_milliseconds[static_cast<int>(m_phase)] += m_watch.milliseconds();
        m_watch.restart();
    }
    void tell(double done) const {
        if (m_progress) m_progress(m_phase, m_is_trying ? m_tried : done);
    }

    struct Found {
        Net net;
        std::vector<SingularVertex> singular;
        KeptWishes kept;
        double distance;  // from the surface, in edges, on average
    };

    using Pins = std::vector<PlacedWishes::Pin>;

    const WishPlacer& placer() {
        if (!m_placer) m_placer.emplace(m_even->surface, m_cell);
        return *m_placer;
    }

    /// Nothing if none can be left out, or small nets promise what larger ones do not keep. Over a border that is one
    /// of the net's lines none goes: it would have a corner there.
    std::optional<Found> find_with_fewer() {
        const bool may_have_none =
            (m_has_border || m_surface.euler_characteristic() == 0) && m_options.singular.is_empty();
        if (!m_creases.sides.empty() || !(m_options.fewest || may_have_none)) return std::nullopt;
        begin(RemeshPhase::singular);
        const DirectionField field = field_along(m_options.smoothing);
        if (singular_count(field) > k_most_singular_vertices) return std::nullopt;
        const std::vector<Pins> wishes = fewer_and_fewer(m_even->surface, field, held_border(m_even->surface));
        if (wishes.size() == 1 || !(m_options.fewest || wishes.back().empty())) return std::nullopt;
        const std::optional<PlacedWishes> usual = m_wishes;
        std::optional<Found> found;
        for (int k = last_good(wishes); k > 0 && !found; k = m_options.fewest ? k / 2 : 0) {
            if (!place(wishes[k])) continue;
            found = find_good_net();
            m_found.clear();
            if (found && !is_smooth(found->net, usual)) found.reset();
        }
        m_first_failure.clear();
        m_wishes = usual;
        return found;
    }

    /// The last of the wishes for which a small net is good enough. With `fewest` it is found by halves, as if all
    /// before it were so, too; else it is the last of them or none.
    int last_good(const std::vector<Pins>& wishes) {
        m_is_trying = true;
        m_usual_tilt.reset();
        const std::optional<PlacedWishes> usual = m_wishes;
        int good = 0, bad = static_cast<int>(wishes.size());
        for (int k = bad - 1; good + 1 < bad; k = (good + bad) / 2) {
            m_tried = 1 - static_cast<double>(bad - good) / static_cast<double>(wishes.size() + 1);
            (is_good_enough(wishes[k], usual) ? good : bad) = k;
            if (!m_options.fewest) break;
        }
        m_is_trying = false;
        return good;
    }

    bool is_good_enough(const Pins& wishes, const std::optional<PlacedWishes>& usual) {
        if (!place(wishes)) return false;
        const std::optional<Net> net = small_net();
        if (!net) return false;
        const DrapeReport report = measure_drape(m_surface, m_guide->tree(), *net);
        const double farthest = m_options.fewest ? k_fewest_distance : k_none_distance;
        if (report.smallest_angle < m_options.smallest_angle - k_limit_tolerance ||
            report.mean_distance > farthest * report.length)
            return false;
        return is_smooth(*net, usual);
    }

    /// False where two of them have one place.
    bool place(const Pins& wishes) {
        try {
            m_wishes = placer().placed_alone(wishes, m_guide->tree());
        } catch (const Error&) {
            return false;
        }
        return true;
    }

    /// As `usual` is, wishes for a net that is found for it if need be.
    bool is_smooth(const Net& net, const std::optional<PlacedWishes>& usual) {
        const double tilt = mean_tilt(*m_guide, net);
        if (tilt <= k_smooth_tilt) return true;
        if (!m_usual_tilt) {  // which takes as long as all before
            const std::optional<PlacedWishes> present = std::exchange(m_wishes, usual);
            const std::optional<Net> other = small_net();
            m_wishes = present;
            m_usual_tilt = other ? mean_tilt(*m_guide, *other) : std::numeric_limits<double>::infinity();
        }
        return tilt <= k_most_tilted * *m_usual_tilt;
    }

    /// With the present wishes.
    std::optional<Net> small_net() {
        try {
            return fitted(mesh_along(small_size(), m_options.smoothing, false), 0, false).net;
        } catch (const Error& error) {
            if (error.code() == ErrorCode::too_large) throw;
            return std::nullopt;
        }
    }

    std::optional<Found> find_net() {
        if (std::optional<Found> good = find_good_net()) return good;
        const auto best = std::min_element(m_found.begin(), m_found.end(), [this](const Found& a, const Found& b) {
            return std::tuple(a.kept.missed(), !keeps_limit(a), a.distance) <
                   std::tuple(b.kept.missed(), !keeps_limit(b), b.distance);
        });
        if (best == m_found.end()) return std::nullopt;
        return std::move(*best);
    }

    std::optional<Found> find_good_net() {
        m_holds_lines = may_hold_border() || !m_creases.sides.empty();
        if (m_holds_lines && try_with_lines()) return std::move(m_found.back());
        m_holds_lines = false;
        if (m_found.empty() && try_all()) return std::move(m_found.back());
        return std::nullopt;
    }

    /// Lines can be too many for a grid, which has an end without them.
    bool try_with_lines() {
        try {
            return try_all();
        } catch (const Error& error) {
            if (error.code() != ErrorCode::too_large) throw;
            m_too_many_lines = error;
            return false;
        }
    }

    bool try_all() {
        if (may_turn() && try_once(1, m_options.smoothing, true)) return true;
        const auto try_field = [this](double size, double smoothing) {
            return try_once(size, smoothing * m_options.smoothing, false);
        };
        const auto try_sizes = [&](double smoothing) {
            return std::any_of(k_sizes.begin(), k_sizes.end(), [&](double size) { return try_field(size, smoothing); });
        };
        const auto try_smoothings = [&](double size) {
            return std::any_of(k_smoothings.begin(), k_smoothings.end(),
                               [&](double smoothing) { return try_field(size, smoothing); });
        };
        // What a given length lacks are cells, rather than smoothness.
        return m_options.length > 0 ? std::any_of(k_smoothings.begin(), k_smoothings.end(), try_sizes)
                                    : std::any_of(k_sizes.begin(), k_sizes.end(), try_smoothings);
    }

    bool keeps_limit(const Found& found) const {
        const double smallest = corner_angle_range(found.net, found.net.rest_positions()).smallest;
        return smallest >= m_options.smallest_angle - k_limit_tolerance;
    }

    /// Whether the last net found is as it should be.
    bool try_once(double size, double smoothing, bool turns) {
        if (std::ssize(m_found) == (m_options.length > 0 ? k_most_of_length : k_most_lesser_nets)) return false;
        if (m_options.length > 0 && size < k_least_size_for_length) return false;
        try {
            const Mesh mesh = mesh_along(size, smoothing, turns);
            Found found = fitted(mesh, m_options.length, false);
            if (std::optional<Found> other = following_creases(mesh, found)) found = std::move(*other);
            m_found.push_back(std::move(found));
            const Found& last = m_found.back();
            const bool fits = m_options.length == 0 || last.distance <= k_good_distance;
            return keeps_limit(last) && last.kept.missed() == 0 && fits;
        } catch (const Error& error) {
            if (error.code() == ErrorCode::too_large) throw;
            // What is said of a mesh on the way says nothing to who has never seen it.
            if (m_first_failure.empty() && error.code() == ErrorCode::bad_option) m_first_failure = error.what();
        }
        return false;
    }

    DirectionField field_along(double smoothing) const {
        const Surface& triangles = m_even->surface;
        const int rounds = static_cast<int>(smoothing * triangles.vertex_count() / k_vertices_a_round);
        return smoothest_field(triangles,
                               {rounds, m_wishes ? &*m_wishes : nullptr, m_even->creases, followed_border(triangles),
                                m_options.border == Border::across, [this] { tell(0); }});
    }

    /// `turns`: the field as a whole, if it pays.
    Mesh mesh_along(double size, double smoothing, bool turns) {
        begin(RemeshPhase::field);
        DirectionField field = field_along(smoothing);
        if (singular_count(field) > k_most_singular_vertices)
            throw Error(ErrorCode::bad_option, "the surface is so rough that directions on it have " +
                                                   std::to_string(singular_count(field)) + " singular vertices");
        if (turns && singular_count(field) > 0) field = well_turned(field);
        begin(RemeshPhase::grid);
        return checked_mesh(field, size);
    }

    Mesh checked_mesh(const DirectionField& field, double size) const {
        Mesh mesh = mesh_of(cells_of(m_even->surface, grid_along(field, size * m_cell)));
        check(mesh);
        return mesh;
    }

    /// Nothing of the field is along anything.
    bool may_turn() const { return !m_has_border && m_creases.sides.empty() && !(m_wishes && m_wishes->only); }

    /// How well edges can be evened out hangs on which net lines lead from one singular vertex to another, and so on
    /// how the field is turned: what is left is folded away in the end.
    DirectionField well_turned(const DirectionField& field) const {
        DirectionField best = field;
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < k_turns_tried; ++k) {
            tell(static_cast<double>(k + 1) / (k_turns_tried + 1));
            DirectionField other = turned(m_even->surface, field, k * std::numbers::pi / 2 / k_turns_tried);
            const double error = small_error(other);
            if (error < k_clearly_less * least) least = error, best = std::move(other);
        }
        return best;
    }

    /// Of edges that are evened out, in a small net; infinite if there is none.
    double small_error(const DirectionField& field) const {
        try {
            return evened_error(m_guide, checked_mesh(field, small_size()), m_options.smallest_angle);
        } catch (const Error&) {
            return std::numeric_limits<double>::infinity();
        }
    }

    double small_size() const {
        return std::max(1.0, std::sqrt(cells_asked_for(m_surface, m_options) / k_fewest_cells));
    }

    /// `length`: of all edges; 0: the one that fits.
    Found fitted(const Mesh& mesh, double length, bool suits_creases) {
        begin(RemeshPhase::fit);
        const FitOptions options{length,        m_options.smallest_angle, pulls(mesh), m_creases.segments(),
                                 suits_creases, held_border(m_surface)};
        Net net = fit_net(m_guide, mesh, options, [this](double done) { tell(done); });
        std::vector<SingularVertex> singular = singular_vertices(net);
        KeptWishes kept = kept_wishes(net, singular, m_options.singular);
        for (const Positions& way : m_creases.marked) kept.creases.push_back(distance_along(net, way));
        const double distance = distance_to(*m_guide, net, net.rest_positions()).mean / net.mean_length();
        return {std::move(net), std::move(singular), std::move(kept), distance};
    }

    /// Where marked creases are not followed, a net whose length suits them may do so.
    std::optional<Found> following_creases(const Mesh& mesh, const Found& found) {
        if (m_options.length > 0 || std::all_of(found.kept.creases.begin(), found.kept.creases.end(), is_followed))
            return std::nullopt;
        try {
            Found other = fitted(mesh, m_options.length, true);
            if (other.kept.missed() < found.kept.missed()) return other;
        } catch (const Error&) {  // that length fits nothing else
        }
        return std::nullopt;
    }

    bool may_hold_border() const {
        return m_has_border && (m_options.border == Border::always || m_options.border == Border::outer);
    }

    /// Of each side, whether the field follows the border there.
    std::vector<bool> followed_border(const Surface& surface) const {
        return m_options.border == Border::outer ? outer_border_sides(surface) : border_sides(surface);
    }

    /// Of each side, whether the border is one of the net's lines there; empty: nowhere.
    std::vector<bool> held_border(const Surface& surface) const {
        return m_holds_lines && may_hold_border() ? followed_border(surface) : std::vector<bool>();
    }

    /// Of each side, whether it is one of some; both may be empty, for none.
    static std::vector<bool> either(std::vector<bool> some, const std::vector<bool>& others) {
        some.resize(std::max(some.size(), others.size()), false);
        for (std::size_t s = 0; s < others.size(); ++s) some[s] = some[s] || others[s];
        return some;
    }

    GridMap grid_along(const DirectionField& field, double length) const {
        const Surface& triangles = m_even->surface;
        if (!m_holds_lines) return fit_grid(triangles, field, length);
        return fit_grid(triangles, field, length, either(m_even->creases, held_border(triangles)));
    }

    /// Of the singular vertices wished for, each towards its point; of others near a forbidden region, to where they
    /// are; of all clear of such regions.
    std::vector<Pull> pulls(const Mesh& mesh) const {
        const SingularWishes& wishes = m_options.singular;
        if (wishes.is_empty()) return {};
        const std::vector<SingularVertex> singular =
            singular_vertices(Net(mesh.positions, mesh.faces, RestLengths::own));
        const std::vector<int> stands = standing_for(wishes, singular, k_near * m_cell);
        std::vector<Pull> result;
        for (std::size_t k = 0; k < stands.size(); ++k)
            if (stands[k] >= 0)
                result.push_back(clear_of_forbidden(singular[stands[k]].vertex,
                                                    m_guide->tree().nearest(wishes.vertices[k].point).position));
        for (int k = 0; k < std::ssize(singular); ++k)
            if (std::find(stands.begin(), stands.end(), k) == stands.end() && is_near_forbidden(singular[k].position))
                result.push_back(clear_of_forbidden(singular[k].vertex, singular[k].position));
        return result;
    }

    bool is_near_forbidden(const Eigen::Vector3d& point) const {
        const std::vector<ForbiddenRegion>& regions = m_options.singular.forbidden;
        return std::any_of(regions.begin(), regions.end(), [&](const ForbiddenRegion& region) {
            return (point - region.centre).norm() < region.radius + 2 * k_near * m_cell;
        });
    }

    /// Towards a point of the surface, or the one beside it that is k_clear cells away from the regions.
    Pull clear_of_forbidden(int vertex, const Eigen::Vector3d& point) const {
        Pull pull{vertex, point, k_pull};
        for (const auto& [centre, radius] : m_options.singular.forbidden) {
            const Eigen::Vector3d away = pull.target - centre;
            const double distance = away.norm(), clear = radius + k_clear * m_cell;
            if (distance >= clear || distance == 0) continue;
            pull.target = m_guide->tree().nearest(centre + clear / distance * away).position;
            pull.weight = k_pull_clear;
        }
        return pull;
    }

    /// It has to be of one piece where the surface is, and have no other holes and handles.
    void check(const Mesh& mesh) const {
        if (mesh.faces.size() == 0) throw Error(ErrorCode::bad_option, "no cell fits on the surface");
        for (int f = 0; f < mesh.faces.size(); ++f) {
            const std::span<const int> face = mesh.faces[f];
            if (face[0] == face[2] || face[1] == face[3] || face[0] == face[1] || face[2] == face[3])
                throw Error(
                    ErrorCode::bad_option,
                    "the surface is thinner than a cell near " +
                        row_text(std::span(mesh.positions.col(face[0] == face[2] ? face[0] : face[1]).data(), 3),
                                 k_wish_digits));
        }
        const Net net(mesh.positions, mesh.faces, RestLengths::own);
        const int pieces = Topology(net).component_count();
        if (pieces != piece_count(m_surface))
            throw Error(ErrorCode::bad_option, "the net would have " + std::to_string(pieces) +
                                                   " pieces, the surface has " +
                                                   std::to_string(piece_count(m_surface)));
        const int characteristic = net.vertex_count() - net.edge_count() + net.face_count();
        if (characteristic != m_surface.euler_characteristic())
            throw Error(ErrorCode::bad_option,
                        "the surface is somewhere thinner or narrower than a cell, and the net would be "
                        "closed or torn there (its Euler characteristic would be " +
                            std::to_string(characteristic) + ", not " +
                            std::to_string(m_surface.euler_characteristic()) + ")");
    }

    Remesh result(Found& found) {
        end_phase();
        return {std::move(found.net), std::move(found.singular), std::move(found.kept), 0, m_milliseconds};
    }

    std::shared_ptr<const Guide> m_guide;
    const Surface& m_surface;
    RemeshOptions m_options;
    const RemeshProgress& m_progress;
    double m_cell;  // the length of the grid's cells
    Creases m_creases;
    bool m_has_border = false;
    bool m_holds_lines = true;  // of the grid on creases and border; where no net comes of it, the field alone is so
    std::optional<EvenTriangles> m_even;
    std::optional<WishPlacer> m_placer;  // on the even triangles, once it is needed
    std::optional<PlacedWishes> m_wishes;
    std::vector<Found> m_found;
    std::string m_first_failure;
    std::optional<Error> m_too_many_lines;
    bool m_is_trying = false;            // how many singular vertices can be left out
    double m_tried = 0;                  // part of it
    std::optional<double> m_usual_tilt;  // of a small net with all of them
    RemeshPhase m_phase = RemeshPhase::triangles;
    Stopwatch m_watch;
    std::array<double, k_remesh_phases> m_milliseconds{};
};

/// The ways to end at the border, and the net that grows from one place over all of a disc, tried with fewer cells one
/// after the other until one is good; and the best made as it is asked for, or the next, where that leads to no net.
class BorderTrials {
public:
    BorderTrials(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                 const RemeshProgress& progress)
        : m_guide(guide), m_options(options), m_progress(progress) {
        m_cells = cells_asked_for(guide->surface(), options);
    }

    Remesh run() {
        for (std::size_t k = 0; k < std::size(k_ways); ++k) {
            try_way(k);
            if (k + 1 < k_rivals || !best()->is_good()) continue;
            finish_best();
            if (m_finished.is_good()) return std::move(*m_finished.made);
        }
        while (!m_trials.empty() && (!m_finished.made || (m_finals < k_most_finals && promises_more(*best()))))
            finish_best();
        if (!m_finished.made) std::rethrow_exception(m_failure);
        return std::move(*m_finished.made);
    }

private:
    using Way = std::optional<Border>;  // none: in one piece
    static constexpr Way k_ways[] = {Border::always, std::nullopt, Border::outer, Border::across, Border::never};
    // So many are tried at least: each of them may be perfect where another is only good.
    static constexpr std::size_t k_rivals = 3;
    // Each takes its time.
    static constexpr int k_most_finals = 2;

    struct Trial {
        Way way = std::nullopt;
        std::optional<Remesh> made;
        int missed = std::numeric_limits<int>::max();
        double cost = std::numeric_limits<double>::infinity();
        std::exception_ptr failure{};  // why none was made

        bool is_good() const { return missed == 0 && cost <= k_good_cost; }
        auto rank() const { return std::pair(missed, cost); }
    };

    bool are_few() const { return m_cells <= k_trial_cells; }

    void try_way(std::size_t k) {
        const Surface& surface = m_guide->surface();
        if (k_ways[k] == Border::outer && outer_border_sides(surface) == border_sides(surface)) return;
        RemeshOptions options = m_options;
        options.fewest = false;
        if (!are_few()) {
            options.length = 0;
            options.cells = k_trial_cells;
        }
        const RemeshProgress progress = [&](RemeshPhase phase, double done) {
            const int first = static_cast<int>(RemeshPhase::triangles);
            const double part = (static_cast<int>(phase) - first + done) / (k_remesh_phases - first);
            if (m_progress) m_progress(RemeshPhase::border, (static_cast<double>(k) + part) / std::size(k_ways));
        };
        m_trials.push_back(made(k_ways[k], options, progress));
    }

    std::vector<Trial>::iterator best() {
        return std::min_element(m_trials.begin(), m_trials.end(),
                                [](const Trial& a, const Trial& b) { return a.rank() < b.rank(); });
    }

    /// More than came of another, whose trial had promised that: a larger net may crumple where a small one does not.
    bool promises_more(const Trial& trial) const {
        return trial.missed < m_finished.missed ||
               (trial.missed == m_finished.missed && trial.cost < k_clearly_less * m_finished.cost);
    }

    /// As it is asked for, unless one is finished that is better.
    void finish_best() {
        const auto place = best();
        Trial trial = std::move(*place);
        m_trials.erase(place);
        if (m_progress) m_progress(RemeshPhase::border, 1);
        const double milliseconds = m_watch.milliseconds();
        const bool is_done = are_few() && !m_options.fewest;
        if (!is_done)
            trial = made(trial.way, m_options, m_progress);
        else if (m_progress)
            m_progress(RemeshPhase::fit, 1);
        if (!trial.made) {
            if (!m_failure) m_failure = trial.failure;
            return;
        }
        ++m_finals;
        std::array<double, k_remesh_phases>& own = trial.made->milliseconds;
        own[static_cast<int>(RemeshPhase::border)] =
            is_done ? milliseconds - std::accumulate(own.begin(), own.end(), 0.0) : milliseconds;
        if (!m_finished.made || trial.rank() < m_finished.rank()) m_finished = std::move(trial);
    }

    /// Without a net where no such is found.
    Trial made(Way way, RemeshOptions options, const RemeshProgress& progress) {
        Trial trial;
        trial.way = way;
        if (way) {
            options.border = *way;
            try {
                trial.made = Remesher(m_guide, options, progress).run();
            } catch (const Error&) {
                trial.failure = std::current_exception();
            }
        } else {
            trial.made = made_in_one_piece(options, progress);
        }
        if (trial.made) {
            trial.missed = trial.made->kept.missed();
            trial.cost = cost(trial.made->net);
        }
        return trial;
    }

    /// Nothing where wishes ask for more than that.
    std::optional<Remesh> made_in_one_piece(const RemeshOptions& options, const RemeshProgress& progress) const {
        const bool is_free = options.singular.is_empty() && options.crease == 0 && options.marked_creases.empty();
        if (!is_free) return std::nullopt;
        if (progress) progress(RemeshPhase::fit, 0);
        Stopwatch watch;
        std::optional<Net> net =
            one_piece(m_guide->surface(), m_guide->tree(), cells_asked_for(m_guide->surface(), options), options.length,
                      options.smallest_angle);
        if (!net) return std::nullopt;
        Remesh result{std::move(*net), {}, {}, 0, {}};
        result.milliseconds[static_cast<int>(RemeshPhase::fit)] = watch.milliseconds();
        return result;
    }

    double cost(const Net& net) const {
        const DrapeReport report = measure_drape(m_guide->surface(), m_guide->tree(), net);
        const double distances = report.mean_distance + k_border_weight * border_distance(m_guide->surface(), net);
        const double lines =
            k_open_weight * report.open_border / report.length + k_fold_weight * crumpled_edges(*m_guide, net);
        return k_gap_weight * (1 - report.coverage) + distances / report.length +
               k_sharp_weight * std::max(0.0, k_open_angle - report.smallest_angle) +
               k_tilt_weight * mean_tilt(*m_guide, net) + lines / std::sqrt(net.face_count());
    }

    std::shared_ptr<const Guide> m_guide;
    RemeshOptions m_options;
    const RemeshProgress& m_progress;
    double m_cells;
    Stopwatch m_watch;
    std::vector<Trial> m_trials;
    int m_finals = 0;              // nets made as asked for
    Trial m_finished;              // the best of those made as asked for
    std::exception_ptr m_failure;  // of the first that did not come about as asked for
};

/** Refuses `number` unless it is from 0 to `most`, with the sentence that says so. */
void check_number(double number, double most, const char* refusal) {
    if (!std::isfinite(number)) throw Error(ErrorCode::non_finite, refusal);
    if (!(number >= 0 && number <= most)) throw Error(ErrorCode::bad_option, refusal);
}

}  // namespace

const char* to_string(RemeshPhase phase) {
    constexpr const char* k_names[] = {"border", "triangles", "singular", "field", "grid", "fit"};
    return k_names[static_cast<int>(phase)];
}

void check_remesh(const Guide& guide, const RemeshOptions& options) {
    const Surface& surface = guide.surface();
    check_number(options.length, std::numeric_limits<double>::max(),
                 "the length of the edges must be finite, and positive");
    check_number(options.smoothing, k_most_smoothing, "the smoothing must be from 0 to 100");
    check_number(options.smallest_angle, std::numbers::pi / 3, "the shear limit must be from 0 to 60 degrees");
    check_number(options.crease, std::numbers::pi, "the angle of creases must be from 0 to 180 degrees");
    if (!(surface.area() > 0)) throw Error(ErrorCode::bad_option, "the surface has no area");
    const double cells = cells_asked_for(surface, options);
    if (!(cells >= k_least_remeshed_cells))
        throw Error(ErrorCode::bad_option, "a net of a whole surface has at least " +
                                               std::to_string(k_least_remeshed_cells) + " cells" +
                                               (options.length > 0 ? "; the edges are too long for this surface" : ""));
    if (!(cells <= k_most_remeshed_cells))
        throw Error(ErrorCode::too_large, "the net would have about " + number_text(cells, 3) + " cells; more than " +
                                              std::to_string(k_most_remeshed_cells) +
                                              " are not made of a whole surface");
    const double cell = std::sqrt(surface.area() / cells);
    if (!(cell <= k_largest_cell && cell >= 1 / k_largest_cell))
        throw Error(ErrorCode::bad_scale,
                    "the surface is too large or too small for a net over the whole of it: scale it");
    check_wishes(guide, options.singular);
    if (options.fewest && (options.singular.only || !options.singular.vertices.empty()))
        throw Error(ErrorCode::bad_option, "either as few singular vertices as can be, or those that are wished for");
    check_marked(guide, options.marked_creases);
}

Remesh remesh(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, const RemeshProgress& progress) {
    check_remesh(*guide, options);
    const Stopwatch watch;
    const std::shared_ptr<const Guide> closed = without_small_holes(guide, options);
    const bool tries_ways = options.border == RemeshOptions::Border::fitting && has_border(closed->surface());
    const RemeshPhase first = tries_ways ? RemeshPhase::border : RemeshPhase::triangles;
    const std::shared_ptr<const Guide> surface = without_noise(closed, options, [&] {
        if (progress) progress(first, 0);
    });
    const double milliseconds = watch.milliseconds();
    Remesh made =
        tries_ways ? BorderTrials(surface, options, progress).run() : Remesher(surface, options, progress).run();
    made.milliseconds[static_cast<int>(first)] += milliseconds;
    Mesh rows = in_rows({made.net.rest_positions(), made.net.faces()});
    made.net = Net(std::move(rows.positions), std::move(rows.faces), RestLengths::equal);
    made.singular = singular_vertices(made.net);
    made.sharp_quads = sharp_quads(made.net, made.net.rest_positions(), options.smallest_angle - k_limit_tolerance);
    return made;
}

}  // namespace chebnet
