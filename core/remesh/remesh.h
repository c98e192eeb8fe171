#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "base/angle.h"
#include "base/enum_names.h"
#include "net/net.h"
#include "remesh/marked_creases.h"
#include "remesh/singular_wishes.h"
#include "remesh/thin_limbs.h"
#include "surface/guide.h"

namespace chebnet {

/// How a whole surface is made a net.
struct RemeshOptions {
    /// Where the surface ends the net can end in a net line, with corners where the border has corners, or in steps, as
    /// cells fall; or its net lines run up to the border at 45°. Then the border may be longer or shorter than those
    /// beside it, for which cells shear: a ring is covered without singular vertices.
    enum class Border {
        fitting,  ///< as fits best: the others are tried with fewer cells, and unless vertices or lines are wished for
                  ///< the net that grows from one place (see one_piece), and nets that end in steps with singular
                  ///< vertices where curvature asks for them (see Cones); not all where one is good. Measured are what
                  ///< is covered, how far net and surface are apart, and their borders, how much cells are tilted
                  ///< against the surface, corners sharper than 40 degrees, folds, and gaps. So a net that would
                  ///< crumple is left open where it locks
        always,   ///< in a net line, along all of the border that the field follows
        outer,    ///< in a net line along the outer border, in steps around holes in what that bounds
        across,   ///< at 45°
        never     ///< in steps
    };

    int cells = 4000;                             ///< about so many, or more where the surface is too thin for
                                                  ///< them; not asked for if there is a length
    double length = 0;                            ///< L, of all edges; 0: the one that fits with so many cells
    double smallest_angle = k_usual_shear_limit;  ///< no corner is to be sharper, nor blunter than π less it; see
                                                  ///< Remesh::sharp_quads
    /// How large a bump may be that makes no singular vertices: 1 as usual, 0 for none, 10 for few singular vertices.
    /// Up to 1, smaller bumps make some on closed surfaces if edges can be evened out clearly better so, unless
    /// vertices are to be few.
    double smoothing = 1;
    /// As few singular vertices as a net can do with whose corners keep the limit, that is no more than 0.2 edges away
    /// from the surface on average and lies on it about as smoothly as the usual one: cells shear where others would
    /// have one. Takes longer, for it is tried with fewer cells. Not together with vertices wished for, nor where
    /// creases are followed. Otherwise only a net without any is tried, where there may be one, and taken if it is
    /// within 0.1 edges.
    bool fewest = false;
    SingularWishes singular = {};
    /// Net lines follow edges of the surface that are sharper than this, in radians between the triangles' normals; 0,
    /// or where none is as sharp: no edge is followed.
    double crease = 0;
    /// Where no angle is given, nets that follow edges sharper than 30 degrees are tried, too, and made if they lie
    /// better: on a box. Not together with `fewest`.
    bool tries_creases = false;
    /// And curves that are marked on the surface.
    std::vector<MarkedCrease> marked_creases = {};
    Border border = Border::fitting;
};

inline constexpr EnumName<RemeshOptions::Border> k_remesh_borders[] = {{"fitting", RemeshOptions::Border::fitting},
                                                                       {"always", RemeshOptions::Border::always},
                                                                       {"outer", RemeshOptions::Border::outer},
                                                                       {"across", RemeshOptions::Border::across},
                                                                       {"never", RemeshOptions::Border::never}};

/// What is done, in this order.
enum class RemeshPhase {
    border,     ///< the ways to end at it are tried, if there is one and no way is asked for, and along sharp edges
    triangles,  ///< the surface made anew of even triangles
    singular,   ///< how many singular vertices the net can do without is tried, if that is asked for or may be all
    field,      ///< the directions of the net lines
    grid,       ///< the map that has whole numbers of cells between singular vertices
    fit         ///< edges of one length, near the surface
};
inline constexpr int k_remesh_phases = 6;
/// The name of the enumerator.
const char* to_string(RemeshPhase phase);

/// Is told which phase has come how far (0 … 1), once more from the first where limbs are left off. Whoever wants an
/// end throws.
using RemeshProgress = std::function<void(RemeshPhase phase, double done)>;

/// A net on a whole surface, what its singular vertices are, and how long each phase took; of what was tried with limbs
/// that are left off, nothing.
struct Remesh {
    Net net;
    std::vector<SingularVertex> singular;
    KeptWishes kept;
    int sharp_quads = 0;  ///< with a corner sharper than the limit: no net was found that keeps it everywhere
    std::array<double, k_remesh_phases> milliseconds{};
    std::vector<ThinLimb> left_off = {};  ///< of the surface: the net covers it without them
};

/// A net of quads over a whole surface, of any genus and with any number of pieces and boundaries, with singular
/// vertices where its curvature asks for them: a smooth field of four directions, a grid that follows it with whole
/// numbers of cells between singular vertices, the cells between its lines, and all edges brought to exactly one
/// length, near the surface, with no corner sharper than the limit where such a net is found (see Remesh::sharp_quads).
/// Topology, pieces and boundaries are those of the surface, but for holes no longer around than a cell, which are
/// covered, and for gaps and slits that Border::fitting leaves where a net over all of it would crumple. Where no net
/// is found, or a crumpled one, it is tried once more without limbs too thin for cells of this size, unless anything is
/// wished for or creases are marked (see Remesh::left_off). The same input gives the same net. What is wished of its
/// singular vertices is not always kept, nor is each marked crease followed; of the nets that are tried the one that
/// keeps most of it is given, with what it keeps. Of a rough surface, such as a noisy scan, the net follows what it is
/// without what is smaller than its cells (smoothed()), unless creases are followed.
///
/// Throws Error bad_option (numbers out of range; fewest together with wishes for vertices; wishes as check_wishes
/// does; marked creases as cut_line and cut_open do; a surface that is too thin or too narrow somewhere for cells of
/// this size, with what and where; no such net found), non_finite, bad_scale, too_large (cells; a surface in scraps, as
/// check_scraps does), and as the constructor of Surface does.
Remesh remesh(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
              const RemeshProgress& progress = {});

/// Throws Error bad_option, non_finite, bad_scale or too_large where remesh() would for the numbers, wishes, points and
/// pieces alone.
void check_remesh(const Guide& guide, const RemeshOptions& options);

inline constexpr int k_least_remeshed_cells = 20, k_most_remeshed_cells = 100'000;

}  // namespace chebnet
