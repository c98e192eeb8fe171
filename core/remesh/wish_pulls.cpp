#include "remesh/wish_pulls.h"

#include <algorithm>

#include "net/net.h"

namespace chebnet {

namespace {

// A singular vertex farther from where one is wished for, in cells, is another one.
constexpr double k_near = 3;
// A singular vertex is drawn so far out of forbidden regions, in cells, as fitting may move it.
constexpr double k_clear = 0.5;
// By which one is drawn to its place, or out of such a region, beside edges that weigh 1 (see Pull).
constexpr double k_pull = 10, k_pull_clear = 30;

bool is_near_forbidden(const Eigen::Vector3d& point, const std::vector<ForbiddenRegion>& regions, double cell) {
    return std::any_of(regions.begin(), regions.end(), [&](const ForbiddenRegion& region) {
        return (point - region.centre).norm() < region.radius + 2 * k_near * cell;
    });
}

/// Towards a point of the surface, or the one beside it that is k_clear cells away from the regions.
Pull clear_of_forbidden(int vertex, const Eigen::Vector3d& point, const std::vector<ForbiddenRegion>& regions,
                        const SurfaceTree& tree, double cell) {
    Pull pull{vertex, point, k_pull};
    for (const auto& [centre, radius] : regions) {
        const Eigen::Vector3d away = pull.target - centre;
        const double distance = away.norm(), clear = radius + k_clear * cell;
        if (distance >= clear || distance == 0) continue;
        pull.target = tree.nearest(centre + clear / distance * away).position;
        pull.weight = k_pull_clear;
    }
    return pull;
}

}  // namespace

std::vector<Pull> wish_pulls(const Mesh& mesh, const SingularWishes& wishes, const SurfaceTree& tree, double cell) {
    if (wishes.is_empty()) return {};
    const std::vector<SingularVertex> singular = singular_vertices(Net(mesh.positions, mesh.faces, RestLengths::own));
    const std::vector<int> stands = standing_for(wishes, singular, k_near * cell);
    std::vector<Pull> pulls;
    const auto draw = [&](int vertex, const Eigen::Vector3d& point) {
        pulls.push_back(clear_of_forbidden(vertex, point, wishes.forbidden, tree, cell));
    };
    for (std::size_t k = 0; k < stands.size(); ++k)
        if (stands[k] >= 0) draw(singular[stands[k]].vertex, tree.nearest(wishes.vertices[k].point).position);
    for (int k = 0; k < std::ssize(singular); ++k)
        if (std::find(stands.begin(), stands.end(), k) == stands.end() &&
            is_near_forbidden(singular[k].position, wishes.forbidden, cell))
            draw(singular[k].vertex, singular[k].position);
    return pulls;
}

}  // namespace chebnet
