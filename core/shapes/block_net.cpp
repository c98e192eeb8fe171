#include "shapes/block_net.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace chebnet {

namespace {

class Cutter {
public:
    Cutter(const BlockNet& from, int longest) : m_from(from), m_longest(longest) {}

    BlockNet cut() {
        for (int v = 0; v < m_from.positions.cols(); ++v)
            add_vertex(m_from.blocks.positions.col(v), m_from.positions.col(v));
        for (int f = 0; f < m_from.blocks.faces.size(); ++f) cut_face(m_from.blocks.faces[f]);
        const auto count = static_cast<Eigen::Index>(m_positions.size() / 3);
        return {{Eigen::Map<const Positions>(m_points.data(), 3, count), std::move(m_faces)},
                Eigen::Map<const Positions>(m_positions.data(), 3, count)};
    }

private:
    void cut_face(std::span<const int> q) {
        const int a = middle_of_side(q[0], q[1]), b = middle_of_side(q[1], q[2]), c = middle_of_side(q[2], q[3]),
                  d = middle_of_side(q[3], q[0]);
        if (a == k_none && b == k_none) {
            m_faces.add(q);
        } else if (b == k_none) {
            m_faces.add({q[0], a, c, q[3]});
            m_faces.add({a, q[1], q[2], c});
        } else if (a == k_none) {
            m_faces.add({q[0], q[1], b, d});
            m_faces.add({d, b, q[2], q[3]});
        } else {
            const int middle = add_between(a, c);
            m_faces.add({q[0], a, middle, d});
            m_faces.add({a, q[1], b, middle});
            m_faces.add({middle, b, q[2], c});
            m_faces.add({d, middle, c, q[3]});
        }
    }

    /// The new vertex in a side of a face, the same for both faces; k_none if the side is short enough.
    int middle_of_side(int a, int b) {
        const auto [place, is_new] = m_middles.try_emplace(std::minmax(a, b), k_none);
        if (is_new && (point(a) - point(b)).cwiseAbs().maxCoeff() > m_longest) place->second = add_between(a, b);
        return place->second;
    }

    /// In the middle of two vertices, or on the lattice point below: likewise in all sides between the same planes.
    int add_between(int a, int b) {
        int axis = 0;
        (point(b) - point(a)).cwiseAbs().maxCoeff(&axis);
        if (point(a)[axis] > point(b)[axis]) std::swap(a, b);
        const double length = point(b)[axis] - point(a)[axis], step = static_cast<int>(length / 2), t = step / length;
        return add_vertex(point(a) + step * Eigen::Vector3d::Unit(axis), (1 - t) * position(a) + t * position(b));
    }

    int add_vertex(const Eigen::Vector3d& point, const Eigen::Vector3d& position) {
        m_points.insert(m_points.end(), point.begin(), point.end());
        m_positions.insert(m_positions.end(), position.begin(), position.end());
        return static_cast<int>(m_points.size() / 3) - 1;
    }
    Eigen::Vector3d point(int v) const { return Eigen::Map<const Eigen::Vector3d>(&m_points[3 * v]); }
    Eigen::Vector3d position(int v) const { return Eigen::Map<const Eigen::Vector3d>(&m_positions[3 * v]); }

    static constexpr int k_none = -1;
    const BlockNet& m_from;
    const int m_longest;
    std::map<std::pair<int, int>, int> m_middles;
    std::vector<double> m_points, m_positions;
    Faces m_faces;
};

}  // namespace

BlockNet cut(const BlockNet& net, int longest) { return Cutter(net, longest).cut(); }

}  // namespace chebnet
