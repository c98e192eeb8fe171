#include "remesh/quad_mesher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "net/net.h"
#include "net/topology.h"
#include "remesh/border_sides.h"
#include "remesh/cell_mesh.h"
#include "remesh/cells.h"
#include "remesh/fit.h"
#include "remesh/prepared_surface.h"

namespace chebnet {

namespace {

// Edges of the net are longer than the cells of the grid by about this, for they are sheared.
constexpr double k_stretch = 1.05;
// By so much of it cells may be longer or shorter where whole numbers of them fit better between lines that are held,
// unless their length is given.
constexpr double k_slack = 0.03;
// Of the triangles' edges, in edge lengths of the net.
constexpr double k_triangle_length = 0.9;
// One round of smoothing for so many vertices: so it reaches as far on the surface, however small the cells are.
constexpr double k_vertices_a_round = 600;
// Of cells of the grid, where they may shear. About singular vertices they shear more once edges are evened out.
constexpr double k_least_grid_angle = std::numbers::pi / 6, k_singular_grid_angle = 50 * std::numbers::pi / 180;
// What is tried first is so with so many cells.
constexpr int k_fewest_cells = 800;
// A field that nothing holds is as smooth turned by any angle up to 90°. So many are tried, and one that leaves clearly
// less error is worth it, and survives rounding.
constexpr int k_turns_tried = 4;
constexpr double k_clearly_smaller = 0.95;
// What leaves less needs no other whole numbers; and between more singular vertices, as of a rough surface, they take
// long to choose.
constexpr double k_small_error = 0.015;
constexpr int k_few_singular_vertices = 100;
// Of its smoothing, that of a field which is tried where the usual one leaves more: it has singular vertices at smaller
// bumps, too.
constexpr double k_rougher = 0.3;
constexpr int k_mesh_digits = 4;  // of coordinates in messages

using Border = RemeshOptions::Border;

double cell_for(const Surface& surface, const RemeshOptions& options) {
    return options.length > 0 ? options.length / k_stretch : std::sqrt(surface.area() / options.cells);
}

EvenTriangles triangles_of(const Creases& creases, double cell) {
    return even_triangles(creases.guide->surface(), creases.guide->tree(), k_triangle_length * cell, creases.sides);
}

int piece_count(const Surface& surface) {
    const std::vector<int> pieces = surface.components();
    return 1 + *std::max_element(pieces.begin(), pieces.end());
}

/// Of each side, whether it is one of some; both may be empty, for none.
std::vector<bool> either(std::vector<bool> some, const std::vector<bool>& others) {
    some.resize(std::max(some.size(), others.size()), false);
    for (std::size_t s = 0; s < others.size(); ++s) some[s] = some[s] || others[s];
    return some;
}

void check_quads(const Mesh& mesh) {
    if (mesh.faces.size() == 0) throw Error(ErrorCode::bad_option, "no cell fits on the surface");
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::span<const int> face = mesh.faces[f];
        if (face[0] == face[2] || face[1] == face[3] || face[0] == face[1] || face[2] == face[3])
            throw Error(ErrorCode::bad_option,
                        "the surface is thinner than a cell near " +
                            row_text(std::span(mesh.positions.col(face[0] == face[2] ? face[0] : face[1]).data(), 3),
                                     k_mesh_digits));
    }
}

/// It has to be of one piece where the surface is, and have no other holes and handles.
void check_topology(const Mesh& mesh, const Surface& surface) {
    const Net net(mesh.positions, mesh.faces, RestLengths::own);
    const int pieces = Topology(net).component_count();
    if (pieces != piece_count(surface))
        throw Error(ErrorCode::bad_option, "the net would have " + std::to_string(pieces) +
                                               " pieces, the surface has " + std::to_string(piece_count(surface)));
    const int characteristic = net.vertex_count() - net.edge_count() + net.face_count();
    if (characteristic != surface.euler_characteristic())
        throw Error(ErrorCode::bad_option,
                    "the surface is somewhere thinner or narrower than a cell, and the net would be "
                    "closed or torn there (its Euler characteristic would be " +
                        std::to_string(characteristic) + ", not " + std::to_string(surface.euler_characteristic()) +
                        ")");
}

}  // namespace

QuadMesher::QuadMesher(std::shared_ptr<const Guide> guide, const RemeshOptions& options, PhaseClock& clock)
    : m_guide(std::move(guide)),
      m_options(options),
      m_clock(clock),
      m_cell(cell_for(m_guide->surface(), options)),
      m_has_border(chebnet::has_border(m_guide->surface())),
      m_creases(find_creases(m_guide, options.crease, options.marked_creases)),
      m_even(triangles_of(m_creases, m_cell)) {
    if (!options.singular.is_empty()) m_wishes = placer().placed(options.singular, m_guide->tree());
}

const WishPlacer& QuadMesher::placer() {
    if (!m_placer) m_placer.emplace(m_even.surface, m_cell);
    return *m_placer;
}

bool QuadMesher::wish_alone(const std::vector<PlacedWishes::Pin>& pins) {
    try {
        m_wishes = placer().placed_alone(pins, m_guide->tree());
    } catch (const Error&) {
        return false;
    }
    return true;
}

bool QuadMesher::has_lines() const { return may_hold_border() || !m_creases.sides.empty(); }

bool QuadMesher::may_hold_border() const {
    return m_has_border && (m_options.border == Border::always || m_options.border == Border::outer);
}

std::vector<bool> QuadMesher::held_border(const Surface& surface) const {
    return m_holds_lines && may_hold_border() ? followed_border(surface) : std::vector<bool>();
}

/// Of each side, whether the field follows the border there.
std::vector<bool> QuadMesher::followed_border(const Surface& surface) const {
    return m_options.border == Border::outer ? outer_border_sides(surface) : border_sides(surface);
}

Mesh QuadMesher::mesh_along(double size, double smoothing, bool turns) const {
    m_clock.begin(RemeshPhase::field);
    Course course{checked_field(smoothing)};
    if (turns && singular_count(course.field) > 0) course = best_course(std::move(course), smoothing);
    m_clock.begin(RemeshPhase::grid);
    return checked_mesh(course, size);
}

DirectionField QuadMesher::checked_field(double smoothing) const {
    DirectionField field = field_along(smoothing);
    const int singular = singular_count(field);
    if (singular > k_most_singular_vertices)
        throw Error(ErrorCode::bad_option, "the surface is so rough that directions on it have " +
                                               std::to_string(singular) + " singular vertices");
    return field;
}

DirectionField QuadMesher::field_along(double smoothing) const {
    const Surface& triangles = m_even.surface;
    const int rounds = static_cast<int>(smoothing * triangles.vertex_count() / k_vertices_a_round);
    return smoothest_field(triangles,
                           {rounds, m_wishes ? &*m_wishes : nullptr, m_even.creases, followed_border(triangles),
                            m_options.border == Border::across, [this] { m_clock.tell(0); }});
}

bool QuadMesher::may_turn() const { return !m_has_border && m_creases.sides.empty() && !(m_wishes && m_wishes->only); }

/// About bumps without singular vertices cells shear, and crumple where they can shear no more. Where much is left to
/// be folded away, a field that has some at smaller bumps is tried, too.
QuadMesher::Course QuadMesher::best_course(Course usual, double smoothing) const {
    Course best = best_turn(std::move(usual));
    const bool may_be_rougher = smoothing > 0 && smoothing <= 1 && !m_options.fewest;
    if (best.small_error <= k_small_error || !may_be_rougher) return best;
    m_clock.stand_at(static_cast<double>(k_turns_tried) / (k_turns_tried + 2));
    Course rougher{field_along(k_rougher * smoothing)};
    const int singular = singular_count(rougher.field);
    if (singular > 0 && singular <= k_few_singular_vertices) rougher = best_turn(std::move(rougher));
    m_clock.go_on();
    return rougher.small_error < k_clearly_smaller * best.small_error ? rougher : best;
}

/// How well edges can be evened out hangs on which net lines lead from one singular vertex to another, and so on how
/// the field is turned: what is left is folded away in the end. Where much is left, other whole numbers of cells
/// between them may fit edges of one length better than they fit squares.
QuadMesher::Course QuadMesher::best_turn(Course course) const {
    course.grids = grid_fitter(m_even.surface, course.field);
    Course best = course;
    for (int k = 0; k < k_turns_tried; ++k) {
        m_clock.tell(static_cast<double>(k + 1) / (k_turns_tried + 2));
        Course other = course;
        other.field = turned(m_even.surface, course.field, k * std::numbers::pi / 2 / k_turns_tried);
        other.small_error = small_error(other);
        if (other.small_error < k_clearly_smaller * best.small_error) best = std::move(other);
    }
    const bool may_shear = best.small_error > k_small_error && singular_count(best.field) <= k_few_singular_vertices;
    if (!may_shear) return best;
    Course sheared = best;
    sheared.shears = true;
    sheared.small_error = small_error(sheared);
    return sheared.small_error < k_clearly_smaller * best.small_error ? sheared : best;
}

/// Of edges that are evened out, in a small net; infinite if there is none.
double QuadMesher::small_error(const Course& course) const {
    try {
        return evened_error(m_guide, checked_mesh(course, small_size()), m_options.smallest_angle);
    } catch (const Error&) {
        return std::numeric_limits<double>::infinity();
    }
}

double QuadMesher::small_size() const {
    return std::max(1.0, std::sqrt(cells_asked_for(m_guide->surface(), m_options) / k_fewest_cells));
}

Mesh QuadMesher::checked_mesh(const Course& course, double size) const {
    Mesh mesh = mesh_of(cells_of(m_even.surface, grid_along(course, size * m_cell)));
    check_quads(mesh);
    check_topology(mesh, m_guide->surface());
    return mesh;
}

GridMap QuadMesher::grid_along(const Course& course, double length) const {
    const Surface& triangles = m_even.surface;
    const DirectionField& field = course.field;
    if (m_holds_lines)
        return fit_grid(triangles, field, length, m_options.length > 0 ? 0 : k_slack,
                        either(m_even.creases, held_border(triangles)));
    if (course.grids)
        return course.grids(
            field, length,
            course.shears ? std::max(k_singular_grid_angle, m_options.smallest_angle) : std::numbers::pi / 2);
    // At 45° to the border cells shear along diagonals, which follow it.
    const bool may_shear =
        m_options.border == Border::across && m_has_border && m_creases.sides.empty() && singular_count(field) == 0;
    if (!may_shear) return fit_grid(triangles, field, length);
    return fit_grid(triangles, field, length, 0, {}, std::max(k_least_grid_angle, m_options.smallest_angle),
                    [this] { m_clock.tell(0); });
}

}  // namespace chebnet
