#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/initialisation.h"
#include "solve/method.h"
#include "solve/options.h"
#include "solve/trace.h"

namespace chebnet {

/// A vertex that is held exactly at a point.
struct Handle {
    int vertex;
    Eigen::Vector3d target;
};

/// Two handles that no net can hold: their targets are farther apart than the net between them is long.
struct UnreachablePair {
    int vertex_a, vertex_b;
    double distance;  ///< between the targets
    double reach;     ///< length of the shortest path along edges between the vertices
};

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

    const Net& net() const { return *m_net; }
    const Topology& topology() const { return *m_topology; }
    /// 3×V, the positions held now. Handles stand exactly at their targets.
    const Positions& positions() const { return m_positions; }
    const std::vector<Handle>& handles() const { return m_handles; }
    const Options& options() const { return m_options; }
    const std::string& method() const { return m_method_name; }
    const std::string& initialisation() const { return m_initialisation.name(); }

    /// Replaces the handles. Throws Error index_out_of_range, repeated_vertex or non_finite and then changes nothing.
    void set_handles(std::vector<Handle> handles);
    /// Moves the handle at `vertex`. Throws Error index_out_of_range if there is none, non_finite.
    void move_handle(int vertex, const Eigen::Vector3d& target);
    /// Chooses the method by its name in method_table(). Throws Error bad_option.
    void set_method(std::string_view name);
    /// Uses a method of one's own; `name` is what method() then says.
    void set_method(std::unique_ptr<Method> method, std::string name);
    /// Chooses what is done to the positions at the beginning of each solve, before the method starts: "naive",
    /// "arap:N" or "local_global:N" (see Initialisation). Throws Error bad_option and then changes nothing.
    void set_initialisation(std::string_view text);
    /// Throws Error bad_option and then changes nothing.
    void set_option(std::string_view key, std::string_view value);
    /// Replaces the positions (3×V), e.g. by those of a shared scene; handles then snap to their targets.
    /// Throws Error index_out_of_range for a wrong size, non_finite.
    void set_positions(const Positions& positions);
    /// Back to the rest positions; handles keep their vertices and take the rest positions as targets.
    void reset();

    /// Goes on with the present solve until it ends or the budget runs out (status `running`; call again to go on).
    /// The first call after a solve has ended, or after a change of handles, targets, options or positions, starts a
    /// new solve from the present positions, initialised unless they are a solution already. At least one iteration is
    /// made unless there is nothing to do. Never throws over a hard problem: see Status. If handles are out of reach
    /// the net is stretched as evenly as the first stage can and the status is `unreachable`.
    SolveReport solve(const Budget& budget = {});

    /// Pairs of handles farther apart than the net allows, worst first. Necessary, not sufficient, for a net to exist.
    /// Two handles joined by an edge whose targets are not exactly its length apart count too.
    std::vector<UnreachablePair> unreachable_pairs() const;
    /// Largest distance of a handle from its target at the present positions: 0 by construction.
    double handle_error() const;

private:
    void snap_handles();
    void restart() { m_running = false; }
    void prepare();
    Status begin_solve();
    void measure_handle_distances() const;
    bool are_joined(int a, int b) const;

    // On the heap, so that references to them survive moving the editor.
    std::unique_ptr<const Net> m_net;
    std::unique_ptr<const Topology> m_topology;
    Positions m_positions;
    std::vector<Handle> m_handles;
    mutable std::vector<std::vector<double>> m_handle_distances;  // handles × handles along the net, made when needed
    Options m_options;
    std::string m_method_name;
    std::unique_ptr<Method> m_method;
    Initialisation m_initialisation;
    bool m_prepared = false;  // method and initialisation know the present set of handles
    bool m_running = false;   // a solve is under way
    bool m_reachable = true;  // as far as the handles' distances tell, for the solve under way
    int m_iterations = 0;     // of the solve under way
    double m_elapsed_ms = 0;  // likewise
};

}  // namespace chebnet
