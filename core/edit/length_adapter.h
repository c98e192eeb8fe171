#pragma once

#include <string>
#include <vector>

#include "edit/edit_state.h"
#include "edit/editor.h"
#include "solve/trace.h"

namespace chebnet {

/// How far a search for the smallest scale of all lengths has come.
struct AdaptReport {
    Status status = Status::running;
    double scale = 1;         ///< Options::length_scale: the smallest found so far, or else the one being tried
    int iterations = 0;       ///< since the beginning
    double milliseconds = 0;  ///< likewise
};

/// For handles beyond reach: the smallest scale of all rest lengths, from the present one on, with which a net meets
/// them, every edge exact and no corner sharper than Options::shear_limit. Li et al. 2022 propose it for large
/// deformations (section 5). Lengths that differ from edge to edge keep their ratios.
///
/// In the unit of a larger scale the net is the same and its handles are closer to each other: `equilibrium` takes them
/// there from net to net, beginning with the last net of the editor, and where it cannot, holds them back. By how much
/// they then are too close says which scale to try next. The first is max |t_i − t_j| / d_ij over pairs of handles (see
/// HandleGraph), since no net has a smaller one; where one of them slides, of the coordinates alone that both hold.
/// Between a scale that does and one that does not, intervals are halved.
class LengthAdapter {
public:
    /// The scale found is larger than the smallest by this part at most, as far as nets are found.
    static constexpr double k_precision = 1e-3;
    static constexpr double k_largest_scale = 4;

    /// `wanted`: where some of the editor's exact handles are to stand; the others at their targets. Soft handles pull.
    /// Keeps nothing of the arguments. Throws Error index_out_of_range for a vertex without such a handle, non_finite,
    /// and bad_option while a locality holds.
    LengthAdapter(const Editor& editor, const std::vector<Handle>& wanted);

    /// Goes on until it ends or the budget runs out (status `running`; call again to go on). Ends as
    ///
    ///   converged     the scale is found, and the net with it at rest, or as near to rest as was found
    ///   unreachable   none up to k_largest_scale does
    AdaptReport solve(const Budget& budget = {});

    /// What to set the editor to. The method is the editor's. Throws Error bad_option unless converged.
    EditState state() const;

private:
    enum class Trial {
        rise,  ///< no scale has been found yet
        walk,  ///< from the net found towards the smallest scale, until handles would be held back
        land,  ///< with the scale at which the handles of that walk stand where they are wanted
        dip,   ///< a scale a little smaller than the one found
        rest,  ///< the scale is found, and the net comes to rest
    };

    /// Two exact handles, by their places, and the length of the shortest path between them.
    struct Pair {
        int a, b;
        double reach;
    };

    void want(const std::vector<Handle>& wanted);
    void find_pairs();
    double distance(const Pair& pair, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
    bool is_pinned(const Pair& pair) const;
    void bound_scale();
    void begin(Trial trial, double scale, const EditState& from);
    void begin_dip();
    void begin_rest();
    void end_rest(Status status);
    void iterate();
    bool is_there() const;
    void end_well();
    void end_walk();
    void end_badly();
    double shortfall() const;

    Editor m_editor;               // tries: of the same net, by `equilibrium`
    std::string m_method;          // of the other editor
    Options m_options;             // likewise
    std::vector<Handle> m_wanted;  // all handles, where they are to stand
    std::vector<Pair> m_pairs;     // that bound each other directly
    Trial m_trial = Trial::rise;
    double m_scale = 1;                              // of the trial
    double m_smallest, m_largest = k_largest_scale;  // no other scale does
    EditState m_net;                                 // to begin with; once found, with the smallest scale that does
    bool m_is_found = false;
    int m_failures = 0;
    double m_dip = k_precision;  // the part by which the next scale is smaller
    Status m_status = Status::running;
    int m_iterations = 0;
    double m_elapsed_ms = 0;
};

}  // namespace chebnet
