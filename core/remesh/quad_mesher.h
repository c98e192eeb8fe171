#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "net/mesh.h"
#include "remesh/direction_field.h"
#include "remesh/even_triangles.h"
#include "remesh/grid_map.h"
#include "remesh/marked_creases.h"
#include "remesh/phase_clock.h"
#include "remesh/remesh.h"
#include "remesh/wish_placer.h"
#include "surface/guide.h"

namespace chebnet {

/// Makes meshes of quads on a surface, of cells larger or smaller, along fields smoother or less smooth: even triangles
/// once, and for each mesh a field of directions on them, a grid along that and the cells between its lines. Edges have
/// no one length yet.
class QuadMesher {
public:
    /// Throws Error as find_creases(), even_triangles() and WishPlacer::placed() do. `options` and `clock` have to
    /// outlive it.
    QuadMesher(std::shared_ptr<const Guide> guide, const RemeshOptions& options, PhaseClock& clock);

    double cell() const { return m_cell; }  ///< the length of the grid's cells, where their size is 1
    bool has_border() const { return m_has_border; }
    const Creases& creases() const { return m_creases; }
    const Surface& triangles() const { return m_even.surface; }

    /// Of singular vertices, on the even triangles: those of the options to begin with.
    const std::optional<PlacedWishes>& wishes() const { return m_wishes; }
    void set_wishes(std::optional<PlacedWishes> wishes) { m_wishes = std::move(wishes); }
    /// From now on these singular vertices are wished for and no others. False where two of them have one place.
    bool wish_alone(const std::vector<PlacedWishes::Pin>& pins);

    /// Whether there are creases, or a border that can be one of the net's lines.
    bool has_lines() const;
    /// Whether the grid is held on them, as it is to begin with, or the field alone follows them.
    void hold_lines(bool on) { m_holds_lines = on; }
    /// Of each side of a surface, whether the border is one of the net's lines there; empty: nowhere.
    std::vector<bool> held_border(const Surface& surface) const;

    /// On the even triangles. `smoothing`: as RemeshOptions::smoothing.
    DirectionField field_along(double smoothing) const;
    /// Of cells of this size, 1 for as many as are asked for. `turns`: the field as a whole, to where edges can be
    /// evened out best, and lets cells shear or the field be rougher if that helps; only if may_turn(). Throws Error
    /// bad_option where no mesh comes of it that has the surface's topology, too_large where lines leave too much to
    /// choose, and as Net does.
    Mesh mesh_along(double size, double smoothing, bool turns) const;
    /// The same of few cells, to try something.
    Mesh small_mesh() const { return mesh_along(small_size(), m_options.smoothing, false); }
    /// Whether a field is as good turned by any angle: nothing of it is along anything.
    bool may_turn() const;

private:
    bool may_hold_border() const;
    std::vector<bool> followed_border(const Surface& surface) const;
    /// A field, and whether cells along it may shear before whole numbers of them are chosen.
    struct Course {
        DirectionField field;
        GridFitter grids = nullptr;  ///< of this field and those turned, if several are tried
        bool shears = false;
        double small_error = std::numeric_limits<double>::infinity();  ///< see small_error()
    };

    Course best_course(Course usual, double smoothing) const;
    Course best_turn(Course course) const;
    DirectionField checked_field(double smoothing) const;
    double small_error(const Course& course) const;
    double small_size() const;
    Mesh checked_mesh(const Course& course, double size) const;
    GridMap grid_along(const Course& course, double length) const;
    const WishPlacer& placer();

    std::shared_ptr<const Guide> m_guide;
    const RemeshOptions& m_options;
    PhaseClock& m_clock;
    double m_cell;
    bool m_has_border;
    bool m_holds_lines = true;
    Creases m_creases;
    EvenTriangles m_even;
    std::optional<WishPlacer> m_placer;  // once it is needed
    std::optional<PlacedWishes> m_wishes;
};

inline constexpr int k_most_singular_vertices = 600;  ///< with more the grid takes too long, and is not worth much

}  // namespace chebnet
