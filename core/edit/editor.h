#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/stopwatch.h"
#include "edit/edit_state.h"
#include "edit/hand.h"
#include "edit/handle_graph.h"
#include "edit/holds.h"
#include "edit/locality.h"
#include "edit/reach.h"
#include "edit/taut_lines.h"
#include "net/net.h"
#include "net/topology.h"
#include "solve/initialisation.h"
#include "solve/method.h"
#include "solve/options.h"
#include "solve/trace.h"

namespace chebnet {

/// How much one call of Editor::solve may do.
struct Budget {
    int iterations = std::numeric_limits<int>::max();
    double milliseconds = std::numeric_limits<double>::infinity();
};

/// A net being edited: net, handles, method and the positions of the moment. One call of solve() is one frame; the
/// last frame is the start of the next (Li et al. 2022, section 4). Symbolic work is done once for a set of handles and
/// survives moving them.
class Editor {
public:
    explicit Editor(Net net);

    /// With the lengths that its edges have now, see Options::length_scale.
    const Net& net() const { return *m_net; }
    /// As it came, whatever the scale of its lengths.
    const Net& original() const { return *m_original; }
    const Topology& topology() const { return *m_topology; }
    /// 3×V, the positions held now. Exact handles stand exactly at their targets, but for those in hand and while
    /// draws_handles(); the targets of those that slide follow them along their axes.
    const Positions& positions() const { return m_positions; }
    const std::vector<Handle>& handles() const { return m_handles; }
    /// 3×V, the last positions in which every edge had its length; the rest positions if there were none.
    const Positions& last_net() const { return m_last_net; }
    /// Whether a solve under way draws exact handles to their targets step by step: they are short of them meanwhile.
    bool draws_handles() const { return m_hand.owner() == Hand::Owner::solve; }
    /// handles(), but those in hand where they stand.
    std::vector<Handle> standing_handles() const;
    const Options& options() const { return m_options; }
    const std::string& method() const { return m_method_name; }
    /// Method::rest_state() of the last solve, in the solver's unit; see net_forces().
    std::optional<RestState> rest_state() const { return m_method->rest_state(); }
    /// E, chebnet::edge_forces() of the last solve; zeros where the method does not know them.
    Eigen::VectorXd edge_forces() const;
    const std::string& initialisation() const { return m_initialisation.name(); }
    /// Null: none.
    const std::shared_ptr<const Guide>& guide() const { return m_guide; }
    /// All of the above that can change, and the locality, as one value. Handles in hand are where they stand.
    EditState state() const;
    /// Goes to such a state, of this editor or of another of the same net; exact handles then snap to their targets. If
    /// it is the present one, nothing changes and a solve under way goes on. Symbolic work survives if method,
    /// initialisation, handles and what may move are as before. Throws as the functions below do, and then changes
    /// nothing.
    void set_state(EditState next);
    /// The same for the present state with some of it changed, as the functions below set it, all but move_handle():
    /// if the lengths change and the positions do not, these grow with them about the middle of the handles, and
    /// everything may move again.
    void change_state(EditState changed);

    /// Replaces the handles; everything may move again. What slides begins where its vertex is, whatever its target
    /// says along its axes. Throws Error index_out_of_range, repeated_vertex, non_finite, or bad_option for a weight
    /// out of range or one that the method does not know, for a handle that slides along all axes or is soft beside,
    /// and then changes nothing.
    void set_handles(std::vector<Handle> handles);
    /// Moves the handle at `vertex`, across its axes if it slides. Throws Error index_out_of_range if there is none,
    /// non_finite.
    void move_handle(int vertex, const Eigen::Vector3d& target);
    /// Takes the handle at `vertex` in hand, or moves it there, as who drags it does: with a method that goes from net
    /// to net (`equilibrium`) every frame is a net, and where none leads to the target the handle is held back, pulled
    /// towards it as far as the net goes. A hand that is kept to an axis or a plane, of all that is in it `along` these
    /// axes, leaves it neither when it is held back; where no net leads along them, it does. For other methods, and
    /// where no net is known, it is move_handle(). Throws as that does, and bad_option for no axes.
    void drag_handle(int vertex, const Eigen::Vector3d& target, Axes along = k_all_axes);
    /// Lets go of what is in hand: at the end of the solve under way, or of the next, handles that are held back take
    /// the place where they stand as their target. Where all handles are to be home, as the rest shape has them, that
    /// solve ends in the rest shape, unless a hand found the net in another one there. Any other change of the state
    /// lets go at once.
    void release_handles() { m_hand.release(); }
    /// Whether handles in hand are held back now.
    bool holds_back() const { return m_hand.holds_back() && !draws_handles(); }
    /// From now on only what lies within `radius` of the `origins` may move, in mean edge lengths along the net, and
    /// the harder the closer to that border (see Region; methods that know no pulls have the border only). All else
    /// stays exactly where it stands, until the next call, or until other handles are moved or all set, positions are
    /// replaced or reset. Infinity, or no origins: everything may move. Throws Error bad_option unless radius > 0,
    /// index_out_of_range.
    void set_locality(double radius, std::span<const int> origins);
    /// Where set_locality() lets vertices move, as long as it holds; none: everything may move.
    const std::optional<Region>& region() const { return m_region; }
    /// Chooses the method by its name in method_table(). Throws Error bad_option, also if there are soft handles and
    /// the method does not know any, and then changes nothing.
    void set_method(std::string_view name);
    /// Uses a method of one's own; `name` is what method() then says. Throws Error bad_option as above.
    void set_method(std::unique_ptr<Method> method, std::string name);
    /// Chooses what is done to the positions at the beginning of each solve, before the method starts: "naive",
    /// "arap:N" or "local_global:N" (see Initialisation). Throws Error bad_option and then changes nothing.
    void set_initialisation(std::string_view text);
    /// A surface that draws the net as Options::guide_mode says; null: none. Two guides are the same if they are one
    /// object.
    void set_guide(std::shared_ptr<const Guide> guide);
    /// Throws Error bad_option and then changes nothing.
    void set_option(std::string_view key, std::string_view value);
    /// Replaces the positions (3×V), e.g. by those of a shared scene; exact handles then snap to their targets, and
    /// everything may move again.
    /// Throws Error index_out_of_range for a wrong size, non_finite, bad_scale for one beyond k_largest_size.
    void set_positions(const Positions& positions);
    /// Back to the rest positions of net(); handles keep their vertices and take the rest positions as targets.
    /// Everything may move again.
    void reset();

    /// Goes on with the present solve until it ends or the budget runs out (status `running`; call again to go on).
    /// The first call after a solve has ended, or after a change of handles, targets, options or positions, starts a
    /// new solve from the present positions, initialised unless they are a solution already. At least one iteration is
    /// made unless there is nothing to do. Never throws over a hard problem: see Status. If handles are out of reach
    /// the net is stretched as evenly as the first stage can and the status is `unreachable`; towards targets that are
    /// very far it is stretched as towards nearer ones in their direction (see near_targets), and the handle alone
    /// stands at the target. With a method that goes from net to net, handles to which no way leads are drawn there as
    /// by a hand, as long as iterations are left for it; where that leads nowhere, or to a net that is crumpled, one is
    /// looked for by its lengths alone, and of two the one of less energy stays. A net that has its handles in place is
    /// not given up: where none is come to from it, it is taken back. Throws Error too_large if the method needs more
    /// memory for a net of this size than is allowed or there (see k_most_factor_bytes); then the positions stay, and
    /// another method may do.
    SolveReport solve(const Budget& budget = {});

    /// Pairs of exact handles that do not slide, farther apart than the net allows, worst first, and such a handle with
    /// the vertex outside the region that may move which holds one back most. Sufficient, not necessary, for no net to
    /// exist. Two handles joined by an edge whose targets are not exactly its length apart count too. A pair with
    /// another exact handle on a shortest path between the two is left out: it never is the worst (see HandleGraph).
    std::vector<UnreachablePair> unreachable_pairs() const;
    /// Where the handle at `vertex` may be moved as far as unreachable_pairs() tells: the points in all these balls,
    /// one for each other exact handle with no third one on a shortest path from there, which imply the balls of all
    /// others unless those are out of reach of each other, and one for each vertex of the border of the region that may
    /// move (see Region) to which this handle is the nearest origin; as wide as the net between them is long. None for
    /// a soft handle or one that slides, which bounds no other either. Throws Error index_out_of_range.
    std::vector<Ball> reach(int vertex) const;
    /// Which exact handles bound each other directly: places in handles(), where those that are soft or slide have no
    /// neighbours. Made
    /// when needed, once for a set of handles.
    const HandleGraph& handle_graph() const;
    /// What handles pull straight, and so hold, in the last solve; for methods that go from net to net.
    const std::vector<TautVertex>& taut_vertices() const { return m_taut; }
    /// V, how freely set_locality() would let each vertex move, 0 … 1; see chebnet::mobility(). Throws as it does.
    Eigen::VectorXf mobility(double radius, std::span<const int> origins) const;
    /// Largest distance of an exact handle that is not in hand from its target at the present positions: 0 by
    /// construction.
    double handle_error() const;

private:
    // What is in hand is in in_hand.cpp and by_hand.cpp, a run of the solver in editor_run.cpp, all else in editor.cpp.
    const Handle* find_handle(int vertex) const;
    std::size_t place_of_handle(int vertex) const;
    void replace_handles(std::vector<Handle> handles);
    void replace_region(std::optional<Region> region);
    std::optional<Region> region_of(const std::optional<Locality>& locality) const;
    void go_to(EditState next, bool lets_net_grow);
    void go_to_lengths(EditState& next, bool net_grows);
    void note_last_net(const Positions& given, bool or_one_before);
    void set_length_scale(double scale);
    Positions grown(const Positions& positions, double factor) const;
    Positions in_unit(const Positions& positions) const;
    void move(Handle& handle, const Eigen::Vector3d& target);
    Holds holds() const;
    Problem problem() const;
    void snap_held();
    bool is_nearly_there() const;
    void keep_hand_to(Axes axes);
    void hold_back(bool on);
    void hold_otherwise();
    bool goes_on_otherwise(Status status);
    bool goes_on_let_go();
    bool is_to_be_home() const;
    bool take_in_hand();
    bool take_in_hand(const Positions& from);
    void draw_a_step();
    Eigen::Vector3d goal(const Handle& handle) const;
    bool goes_on_by_hand(SolveReport& report);
    bool goes_on_without_hand(bool has_arrived, SolveReport& report);
    void give_up_by_hand();
    bool may_pass_limit() const;
    bool goes_on_past_limit(Status status);
    void stand_at(const Positions& positions);
    void show_found_net();
    void take_better_net(SolveReport& report);
    void take_back_net(SolveReport& report);
    double deviation_with_hand_at_targets() const;
    bool has_all_in_place() const;
    bool has_net_in_place() const;
    Status status_by_hand() const;
    double energy() const;
    void empty_hand();
    void let_go();
    void prepare();
    void draw_targets_near();
    bool draw_within_reach(Eigen::Matrix3Xd& targets) const;
    Eigen::Vector3d place_across_axes(const Handle& handle) const;
    bool find_taut_lines();
    void load_positions();
    void store_positions();
    SolveReport go_on(const Budget& budget);
    void begin_run(SolveReport& report);
    void run(const Budget& budget, const Stopwatch& watch, bool has_moved, SolveReport& report);
    bool begins_again(SolveReport& report);
    void make_iteration(const Stopwatch& watch, SolveReport& report);
    void end_run(SolveReport& report);
    [[noreturn]] void refuse_size(const std::string& reason);
    Status begin_solve(Trace& trace);
    Status iterate(TraceRow& row);

    // On the heap, so that references to them survive moving the editor.
    std::shared_ptr<const Net> m_original, m_net;
    double m_unit;  // of the solver: in it the mean edge is 1 … 2 long, whatever the net's size and scale
    std::unique_ptr<const Net> m_unit_net;       // the net in this unit
    std::unique_ptr<const Topology> m_topology;  // of the original: lengths in it are without the scale
    Positions m_positions;
    Positions m_last_net;  // the last positions in which every edge had its length
    std::vector<Handle> m_handles;
    std::vector<int> m_handle_at;  // V, the place of the handle that holds a vertex, −1 where there is none
    mutable std::optional<HandleGraph> m_handle_graph;  // made when needed
    std::optional<Region> m_region;                     // none: everything may move
    Hand m_hand;
    struct ByHand;
    // The solve under way, or the last one.
    struct Run {
        bool may_take_in_hand = false;    // whether it may take handles in hand itself
        std::shared_ptr<ByHand> by_hand;  // what it knows since it has; null: it has not
        bool limit_gives_way = false;     // to a walk: none within it has led to where handles are to be
        Positions net_before;             // the last net before it
        Positions begun_in_place;         // where it began with a net that had all handles in place; or empty
        bool stops_short = false;  // what is in hand walks as far as the handles' distances let it, not to the end
        bool reachable = true;     // as far as the handles' distances tell
        int iterations = 0;
        double elapsed_ms = 0;
    };
    Run m_run;
    // For the solve under way, in the solver's unit:
    Positions m_unit_positions, m_unit_last_net;
    Eigen::Matrix3Xd m_near_targets;  // of the handles, see near_targets()
    TautLines m_taut_lines;
    std::vector<TautVertex> m_taut;  // for methods that go from net to net
    std::vector<int> m_fixed;
    std::vector<Slide> m_slides;
    std::vector<Pull> m_pulls;  // of soft handles and of the region
    Options m_options;
    std::string m_method_name;
    std::unique_ptr<Method> m_method;
    Initialisation m_initialisation;
    std::shared_ptr<const Guide> m_guide;
    bool m_prepared = false;  // method and initialisation know which vertices are fixed
    bool m_running = false;   // a solve is under way
};

}  // namespace chebnet
