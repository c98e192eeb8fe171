#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/options.h"
#include "solve/problem.h"
#include "solve/rest_state.h"
#include "solve/trace.h"

namespace chebnet {

/// What a method heeds of a Problem beside its fixed vertices.
struct Heeds {
    bool pulls = false;      ///< edges come first: pulls give way
    bool slides = false;     ///< to other methods what slides has to be among the fixed vertices
    bool only_nets = false;  ///< and only_walks: it goes from net to net

    bool operator==(const Heeds&) const = default;
};

/// A way to find positions in which every edge has its length and handles stay where they are. Methods are stateful:
/// prepare() once for a set of fixed vertices, start() once for a solve, iterate() until the status is not `running`.
class Method {
public:
    virtual ~Method() = default;

    /// Does the symbolic work for a net and a set of fixed vertices. Net and topology must outlive the method. Throws
    /// Error too_large where a system of the method would take more memory than is allowed, as does iterate() for one
    /// that is made late.
    virtual void prepare(const Problem& problem) = 0;

    virtual Heeds heeds() const { return {}; }

    /// Begins a solve of the problem that was prepared, with the pulls of the moment, at `positions` (3×V), where the
    /// fixed vertices already stand. May move free vertices off degenerate places. Returns `running`, or `converged` if
    /// nothing is to be done. What is not reachable gets the most even shape and ends with `unreachable`. If only nets
    /// are asked for, fixed vertices stand where the net has come on the way to their places, and the solve ends with
    /// `unreachable` at the last net where none leads on, or before it begins where none is known. If only walks are
    /// asked for, a solve whose walks from net to net lead no farther ends with `unreachable` there.
    virtual Status start(const Problem& problem, Positions& positions, const Options& options) = 0;

    /// One iteration: moves free vertices only, or if only nets are asked for, all, and fills `row` (all but iteration
    /// and total_ms).
    virtual Status iterate(Positions& positions, TraceRow& row) = 0;

    /// How near the net is to rest and what holds it there, if the method brings nets to rest and has come so far.
    virtual std::optional<RestState> rest_state() const { return std::nullopt; }
};

using NameList = std::span<const char* const>;
using MakeMethod = std::unique_ptr<Method> (*)();

/// One line of the table by which the command line, the page and the tests find a method.
struct MethodInfo {
    const char* name = nullptr;
    const char* sentence = nullptr;
    const char* citation = nullptr;
    NameList stages = {};       ///< what the numbers of TraceRow::stage stand for, from 1
    NameList options = {};      ///< what it reads of Options beside what every solve does: see reads()
    MakeMethod make = nullptr;  ///< null in a build that has the method's words only
    Heeds heeds = {};           ///< heeds() of what is made
};
std::span<const MethodInfo> method_table();
/// Whether what a solve by this method does depends on an option.
bool reads(const MethodInfo& method, std::string_view option);
/// The name of the method used unless another is asked for.
inline constexpr std::string_view k_default_method = "equilibrium";
/// That which needs the least time and memory.
inline constexpr std::string_view k_light_method = "projection";
/// The default where a person or a script waits for the result: coming to rest takes minutes in large nets.
inline constexpr int k_most_vertices_at_rest = 12'000;
constexpr std::string_view usual_method(int vertex_count) {
    return vertex_count > k_most_vertices_at_rest ? k_light_method : k_default_method;
}
/// Throws Error bad_option, naming the known methods, or left_out for one that this build only has the words of.
std::unique_ptr<Method> make_method(std::string_view name);

}  // namespace chebnet
