#include "solve/parts/turned_handles.h"

#include <cmath>
#include <utility>

#include "solve/parts/rigid_motion.h"

namespace chebnet {

namespace {

// Radians: what turns less goes straight.
constexpr double k_least_turn = 1e-6;

/// Each group of these vertices that edges between them join, from its first on.
std::vector<std::vector<int>> joined_groups(const Topology& topology, std::vector<bool> is_left) {
    std::vector<std::vector<int>> groups;
    for (std::size_t first = 0; first < is_left.size(); ++first) {
        if (!is_left[first]) continue;
        std::vector<int> group{static_cast<int>(first)};
        is_left[first] = false;
        for (std::size_t i = 0; i < group.size(); ++i)
            for (int n : topology.neighbours(group[i])) {
                if (!is_left[n]) continue;
                is_left[n] = false;
                group.push_back(n);
            }
        groups.push_back(std::move(group));
    }
    return groups;
}

/// The shortest turn of a line of points, of which a fit leaves free how they turn about it.
Eigen::Quaterniond turn_of_line(const Positions& from, const Positions& to) {
    Eigen::Index far = 0;
    (from.colwise() - from.col(0)).colwise().squaredNorm().maxCoeff(&far);
    return Eigen::Quaterniond::FromTwoVectors(from.col(far) - from.col(0), to.col(far) - to.col(0));
}

}  // namespace

TurnedHandles::Group TurnedHandles::group_of(std::vector<int> vertices, const Positions& from, const Positions& to) {
    const Positions start = from(Eigen::all, vertices), end = to(Eigen::all, vertices);
    const RigidMotion motion = fit_rigid_motion(start, end, Eigen::VectorXd::Ones(start.cols()));
    const Eigen::AngleAxisd turn(motion.is_determined ? motion.rotation : turn_of_line(start, end));
    return {std::move(vertices), motion.from_centre, motion.to_centre, turn};
}

std::shared_ptr<const TurnedHandles> TurnedHandles::find(const Topology& topology, const HeldVertices& held,
                                                         const Positions& from, const Positions& to) {
    std::vector<bool> moves(static_cast<std::size_t>(from.cols()), false);
    for (int v : held.vertices()) moves[v] = held.is_fixed(v) && from.col(v) != to.col(v);
    auto turned = std::make_unique<TurnedHandles>();
    for (std::vector<int>& vertices : joined_groups(topology, std::move(moves))) {
        if (vertices.size() == 1) continue;
        Group group = group_of(std::move(vertices), from, to);
        if (std::abs(group.turn.angle()) > k_least_turn) turned->m_groups.push_back(std::move(group));
    }
    if (turned->m_groups.empty()) return nullptr;
    return turned;
}

void TurnedHandles::go(double part, const Positions& from, const Positions& to, const Positions& now,
                       Eigen::Matrix3Xd& moves) const {
    for (const auto& [vertices, from_middle, to_middle, turn] : m_groups) {
        const Eigen::Vector3d middle = from_middle + part * (to_middle - from_middle);
        const Eigen::AngleAxisd so_far(part * turn.angle(), turn.axis());
        for (int v : vertices) {
            const Eigen::Vector3d before = from.col(v) - from_middle, after = turn.inverse() * (to.col(v) - to_middle);
            moves.col(v) = middle + so_far * (before + part * (after - before)) - now.col(v);
        }
    }
}

}  // namespace chebnet
