#include "edit/holds.h"

#include <algorithm>

namespace chebnet {

namespace {

// A handle that is held back has the weight of so many edges: as hard as a pull can be without being stiff.
constexpr double k_weight_in_hand = 100;

}  // namespace

const Handle* Holds::handle(int vertex) const { return handle_at[vertex] < 0 ? nullptr : &handles[handle_at[vertex]]; }

bool Holds::is_held(const Handle& handle) const {
    return handle.is_exact() && !(hand.holds_back() && hand.holds(handle.vertex));
}

Axes Holds::axes(const Handle& handle) const {
    if (!handle.is_exact()) return k_all_axes;
    const Axes axes = is_held(handle) ? handle.slides : handle.slides | hand.along();
    if (is_part(axes) && !(can_slide && !is_outside(handle))) return is_held(handle) ? k_no_axes : k_all_axes;
    return axes;
}

std::vector<Slide> Holds::slides() const {
    std::vector<Slide> slides;
    for (const Handle& handle : handles)
        if (const Axes along = axes(handle); is_part(along)) slides.push_back({handle.vertex, along});
    return slides;
}

std::vector<int> Holds::fixed_vertices(std::span<const TautVertex> taut) const {
    std::vector<int> vertices;
    for (const TautVertex& vertex : taut) vertices.push_back(vertex.vertex);
    for (const Handle& handle : handles)
        if (axes(handle) == k_no_axes) vertices.push_back(handle.vertex);
    if (region == nullptr) return vertices;
    vertices.insert(vertices.end(), region->outside.begin(), region->outside.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

Pull Holds::pull_of(const Handle& handle, const Eigen::Vector3d& target, double mean_length) const {
    if (!handle.is_exact()) return {handle.vertex, target, handle.weight};
    // Beyond where it yields it pulls with a force of 2 k_nearly_there times this, see PullTerm.
    const double in_hand = k_weight_in_hand + weight / k_nearly_there;
    return {handle.vertex, target, in_hand, k_nearly_there * mean_length};
}

std::vector<Pull> Holds::pulls(double unit, double mean_length, const Eigen::Matrix3Xd& targets) const {
    std::vector<Pull> pulls;
    if (region != nullptr)
        for (const Pull& pull : region->pulls) {
            const Handle* there = handle(pull.vertex);
            if (there == nullptr || !is_held(*there)) pulls.push_back({pull.vertex, pull.target / unit, pull.weight});
        }
    const auto of_region = static_cast<std::ptrdiff_t>(pulls.size());  // ascending by vertex
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (is_held(handles[i]) || is_outside(handles[i])) continue;
        const Pull own = pull_of(handles[i], targets.col(static_cast<Eigen::Index>(i)), mean_length);
        const auto other = std::lower_bound(pulls.begin(), pulls.begin() + of_region, own.vertex,
                                            [](const Pull& pull, int vertex) { return pull.vertex < vertex; });
        if (other == pulls.begin() + of_region || other->vertex != own.vertex) {
            pulls.push_back(own);
            continue;
        }
        other->weight += own.weight;
        other->target += own.weight / other->weight * (own.target - other->target);
        other->yields = own.yields;
    }
    for (Pull& pull : pulls) pull.weight = std::min(pull.weight, k_most_pull);
    return pulls;
}

}  // namespace chebnet
