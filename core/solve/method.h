#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/hold.h"
#include "solve/options.h"
#include "solve/trace.h"

namespace chebnet {

/// A way to find positions in which every edge has its length and handles stay where they are. Methods are stateful:
/// prepare() once for a set of handles, start() once for a solve, iterate() until the status is not `running`.
class Method {
public:
    virtual ~Method() = default;

    /// Does the symbolic work for a set of vertices that stay where they are: exact handles, and what lies outside the
    /// region that may move (distinct, in range). Net and topology must outlive the method. Throws Error too_large
    /// where a system of the method would take more memory than is allowed, as does iterate() for one that is made
    /// late.
    virtual void prepare(const Net& net, const Topology& topology, std::span<const int> handle_vertices) = 0;

    /// Whether set_holds() is heeded.
    virtual bool knows_holds() const { return false; }
    /// Free vertices that the next solves pull (distinct), in place of those before. Edges come first: holds give way.
    virtual void set_holds(std::span<const Hold>) {}

    /// Begins a solve at `positions` (3×V), with the handles already at their targets. May move free vertices off
    /// degenerate places. Returns `running`, or `converged` if nothing is to be done. `reachable` = false says that no
    /// net exists: find the most even shape and end with `unreachable`.
    virtual Status start(Positions& positions, const Options& options, bool reachable) = 0;

    /// One iteration: moves free vertices only and fills `row` (all but iteration and total_ms).
    virtual Status iterate(Positions& positions, TraceRow& row) = 0;

    /// E, what holds each edge at its length, where the method finds that: the energy gained for a part of the length
    /// that the edge would give way. Positive where it pulls its ends together, negative where it pushes them apart;
    /// over L_e it is a force. Empty if the method does not know. Valid until the next call.
    virtual std::span<const double> edge_forces() const { return {}; }
};

using MakeMethod = std::unique_ptr<Method> (*)();

/// One line of the table by which the command line, the page and the tests find a method.
struct MethodInfo {
    const char* name;
    const char* sentence;
    const char* citation;
    MakeMethod make;  ///< null in a build that has the method's words only
};
std::span<const MethodInfo> method_table();
/// The name of the method used unless another is asked for.
inline constexpr std::string_view k_default_method = "projection";
/// Throws Error bad_option, naming the known methods, or left_out for one that this build only has the words of.
std::unique_ptr<Method> make_method(std::string_view name);

}  // namespace chebnet
