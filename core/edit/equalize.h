#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/angle.h"
#include "base/enum_names.h"
#include "edit/editor.h"
#include "edit/fair_start.h"
#include "net/net.h"
#include "solve/trace.h"
#include "surface/guide.h"

namespace chebnet {

/// Which length all edges are to have.
enum class EqualLength {
    mean,     ///< the mean of the original's edges
    fitting,  ///< the one with which the result, seen as a shape of any size, lies nearest to the original; with a
              ///< guide, that which edges near it have on the average
    given,    ///< EqualizeOptions::length
};

inline constexpr EnumName<EqualLength> k_equal_lengths[] = {
    {"mean", EqualLength::mean}, {"fitting", EqualLength::fitting}, {"given", EqualLength::given}};

/// What is asked of the net beside edges of one length.
enum class EqualizeWay {
    usual,    ///< that for a net of this size: with a guide, and up to k_most_vertices_at_rest, at_rest
    at_rest,  ///< by `equilibrium`: near the surface of the original, fair, no corner too sharp
    lengths,  ///< by `projection`: nothing
};
/// The name of the method; empty for the usual one.
const char* to_string(EqualizeWay way);
/// Throws Error bad_option, naming the methods.
EqualizeWay equalize_way_named(std::string_view method);

struct EqualizeOptions {
    EqualLength choice = EqualLength::mean;
    double length = 0;           ///< with EqualLength::given: L
    std::vector<int> handles{};  ///< vertices that stay exactly where they are; none: the whole net is free
    EqualizeWay way = EqualizeWay::usual;
    double shear_limit = k_usual_shear_limit;  ///< at rest no corner of a quad is sharper, radians; 0: none
    /// At rest the net comes near this surface, where that is, and not near the original's own; null: near that.
    std::shared_ptr<const Guide> guide = nullptr;
};

/// How edge lengths differ, as parts of their mean.
struct LengthSpread {
    double shortest = 0, longest = 0;
    double standard_deviation = 0;
};

struct EqualizeReport {
    Status status = Status::running;
    double length = 0;         ///< L
    double max_deviation = 0;  ///< the largest dL of an edge against L
    int iterations = 0;        ///< since the beginning
    double milliseconds = 0;   ///< likewise
    EqualizeWay way{};         ///< that has made it: for lengths also where none was found at rest
    /// The length of EqualLength::fitting; without freedom, L. Much larger than L if many edges were too long beside
    /// others that were too short: the net then had to crumple, which makes it smaller.
    double fitting_length = 0;
    std::vector<UnreachablePair> unreachable_pairs;  ///< of handles, see Editor

    // Measured at the end alone: 0, or empty, while the status is `running`.
    LengthSpread before, after;
    /// From the guide or else the surface of the original, of vertices and middles of edges, in units of L; none if its
    /// triangles are no surface. A given length without handles scales that surface too, but no guide.
    std::optional<GuideDistance> distance;
    double smallest_angle = 0;           ///< of corners, radians
    int quads_beyond_limit = 0;          ///< that have a corner sharper than EqualizeOptions::shear_limit
    int folds_before = 0, folds = 0;     ///< edges at which the original and the net fold by more than k_fold
    double mean_move = 0, max_move = 0;  ///< distance of vertices from where they were in the original, in units of L
    std::vector<int> worst_edges;        ///< a few of those with dL ≥ k_equal_deviation, the worst first
};

/// Turns a mesh with unequal edges into a Chebyshev net near it: quad meshes as modellers and remeshers leave them,
/// open or closed, of any valences. In stages:
///
///   fair     near the surface of the original, or the guide, its lines bend least, while edges and corners are drawn
///            towards what they are to be (FairStart); then all lengths are exact;
///   rest     `equilibrium` with that surface as its guide, straight rods and the limit of corners;
///   lengths  where that is not asked for or finds no net, and beyond k_most_vertices_at_rest: `projection`, from the
///            original scaled so that its mean edge has the length L, about the centre of the handles if there are any.
///            A net, or a part of it, without handles is then put where it lies nearest to the original, by least
///            squares (Horn 1987);
///   shaken   where that fails too: the same from vertices shaken along their normals. Forces in a flat mesh keep it
///            flat, and most flat meshes become equal by leaving the plane only. Shaking by normals, the same for the
///            same mesh, keeps results repeatable, and the result of a moved mesh is the moved result.
class Equalizer {
public:
    /// Only positions and faces of the original count, not its rest lengths.
    /// Throws Error bad_option (a given length not within a factor 1e6 of the mean; fitting with handles;
    /// a limit out of range),
    /// index_out_of_range and repeated_vertex (handles), bad_scale (a guide much larger or smaller than the net).
    explicit Equalizer(Net original, EqualizeOptions options = {});

    const Net& original() const { return m_original; }

    /// Goes on until it ends or the budget runs out (status `running`; call again to go on, or leave it: what is held
    /// is finite at any time). Never throws over a hard problem. Ends as
    ///
    ///   converged                             max dL < k_equal_deviation, and with `equilibrium` asked for no corner
    ///                                         is sharper than the limit by more than a tenth of a degree
    ///   exact                                 max dL < k_equal_deviation, but no such net within the limit was found
    ///   stalled, max_iterations, non_finite   no such net was found: the best is held
    ///   unreachable                           no such net exists: handles stand too far apart
    EqualizeReport solve(const Budget& budget = {});
    /// Likewise, without a report: how it stands then.
    Status advance(const Budget& budget = {});
    /// Since the beginning.
    int iterations() const { return m_iterations; }

    /// 3×V, the positions held now. The original's, bit for bit, if that is a net with edges of length L already, has
    /// no guide to come near to, and with `equilibrium` no corner that is to be opened.
    const Positions& positions() const { return m_positions; }

    /// 3×V, where the vertices of the surface lie that the net is near: the original's own, or scaled as the net is by
    /// a given length. None if the faces are no surface, or the net is near a guide.
    std::optional<Positions> surface_positions() const;

private:
    enum class Stage { fair, rest, lengths, shaken };

    /// How a free piece is moved as a whole: `from` goes to `to`, and it turns about that.
    struct Placement {
        Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
        Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
        double overlap = 0, extent = 0;  // overlap / extent is the scale that would bring it nearest
    };

    void check_options() const;
    bool comes_near_guide() const { return m_options.guide && m_options.way == EqualizeWay::at_rest; }
    bool begin_fair();
    void begin_rest();
    void begin_lengths();
    FairStart::Size fitting_size() const;
    std::vector<Pull> anchors() const;
    void make_fair();
    void come_to_rest();
    void take_near_surface(const Positions& x);
    Eigen::Vector3d centre() const { return m_original.rest_positions().rowwise().mean(); }
    bool keeps_size() const {
        return m_options.choice != EqualLength::given || !m_options.handles.empty() || m_options.guide;
    }
    void hold_handles();
    void find_free_pieces();
    void iterate();
    void find_lengths();
    bool can_try_again(Status ended) const;
    void try_again();
    void place(const Positions& scaled);
    void choose_length(const std::vector<Placement>& placements);
    std::vector<Placement> nearest_placements(const Positions& x) const;
    static Placement nearest_placement(const std::vector<int>& piece, const Positions& x, const Positions& y);
    double deviation_from_length() const;
    int quads_beyond_limit() const;
    bool keeps_limit() const;
    EqualizeWay way() const;
    EqualizeReport report() const;
    void measure(EqualizeReport& report) const;
    GuideDistance distance_from_surface() const;
    std::vector<UnreachablePair> unreachable_pairs() const;

    Net m_original;
    EqualizeOptions m_options;
    double m_length;                         // L
    double m_fitting_length;                 // in any case
    Editor m_editor;                         // of the original scaled to mean edges of length 1
    std::shared_ptr<const Guide> m_surface;  // of the same, or the guide in its unit; null: it has none
    std::unique_ptr<FairStart> m_fair;
    std::unique_ptr<Editor> m_at_rest;
    double m_unit = 1;                                   // of the net near the surface, in mean edges
    Eigen::Vector3d m_centre = Eigen::Vector3d::Zero();  // of the handles, in the editor's unit
    std::vector<std::vector<int>> m_free_pieces;         // components without handles
    Status m_status = Status::running;
    Stage m_stage = Stage::lengths;
    int m_iterations = 0;
    double m_elapsed_ms = 0;
    Positions m_best;         // in the editor's unit, of all iterations
    double m_best_deviation;  // its max dL
    Positions m_positions;
};

}  // namespace chebnet
