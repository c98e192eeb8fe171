#include "edit/edit_state.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "solve/method.h"

namespace chebnet {

namespace {

void check_vertex(const Net& net, int vertex, const char* what) {
    if (vertex < 0 || vertex >= net.vertex_count())
        throw Error(ErrorCode::index_out_of_range, std::string(what) + " names vertex " + std::to_string(vertex) +
                                                       ", but vertices go from 0 to " +
                                                       std::to_string(net.vertex_count() - 1));
}

void check_handles(const Net& net, const std::vector<Handle>& handles) {
    std::vector<bool> held(static_cast<std::size_t>(net.vertex_count()), false);
    for (const Handle& handle : handles) {
        check_vertex(net, handle.vertex, "a handle");
        if (held[handle.vertex])
            throw Error(ErrorCode::repeated_vertex, "two handles hold vertex " + std::to_string(handle.vertex));
        held[handle.vertex] = true;
        check_target(handle.vertex, handle.target);
        if (!(handle.weight > 0))
            throw Error(ErrorCode::bad_option,
                        "the weight of handle " + std::to_string(handle.vertex) + " must be a number above 0");
        if (handle.slides != k_no_axes) check_slide(handle.vertex, handle.slides, handle.is_exact());
    }
}

}  // namespace

void check_target(int vertex, const Eigen::Vector3d& target) {
    if (!target.allFinite())
        throw Error(ErrorCode::non_finite, "the target of handle " + std::to_string(vertex) + " is not finite");
}

void check_softness(const std::vector<Handle>& handles, const Method& method, const std::string& name) {
    const auto soft = std::find_if(handles.begin(), handles.end(), [](const Handle& h) { return !h.is_exact(); });
    if (soft == handles.end() || method.heeds().pulls) return;
    const auto pulls = [](const MethodInfo& info) { return info.heeds.pulls; };
    const auto other = std::find_if(method_table().begin(), method_table().end(), pulls);
    throw Error(ErrorCode::bad_option, "method " + name + " keeps every handle exactly, but handle " +
                                           std::to_string(soft->vertex) + " is soft; " + other->name + " can do that");
}

void check_positions(const Net& net, const Positions& positions) {
    if (positions.cols() != net.vertex_count())
        throw Error(ErrorCode::index_out_of_range, "positions of " + std::to_string(positions.cols()) +
                                                       " vertices do not fit a net of " +
                                                       std::to_string(net.vertex_count()));
    if (!positions.allFinite()) throw Error(ErrorCode::non_finite, "a position is not finite");
}

void check_locality(const Net& net, const Locality& locality) {
    if (!(locality.radius > 0))
        throw Error(ErrorCode::bad_option, "the locality must be a number of edge lengths above 0");
    for (int origin : locality.origins) check_vertex(net, origin, "the origin of a locality");
    if (locality.held_at.size() > 0) check_positions(net, locality.held_at);
}

void check_state(const Net& net, const EditState& state, const Method& method) {
    check_options(state.options);
    check_handles(net, state.handles);
    check_softness(state.handles, method, state.method);
    check_positions(net, state.positions);
    if (state.locality) check_locality(net, *state.locality);
}

void snap(std::vector<Handle>& handles, Positions& positions) {
    for (Handle& handle : handles)
        if (handle.is_exact()) handle.snap(positions.col(handle.vertex));
}

void normalise(EditState& state) {
    snap(state.handles, state.positions);
    if (!state.locality) return;
    auto& [radius, origins, held_at] = *state.locality;
    if (!std::isfinite(radius) || origins.empty())
        state.locality.reset();
    else if (held_at.size() == 0)
        held_at = state.positions;
}

}  // namespace chebnet
