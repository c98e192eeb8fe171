#include "surface/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace chebnet {

namespace {

constexpr int k_segments_in_leaf = 4;
// By rounding a segment may seem to be nearer than the box around it, by no more than this part of the coordinates.
constexpr double k_box_tolerance = 1e-12;

Eigen::Vector3d middle_of(const Segment& segment) { return (segment.from + segment.to) / 2; }

}  // namespace

SegmentTree::SegmentTree(std::vector<Segment> segments) : m_segments(std::move(segments)), m_order(m_segments.size()) {
    std::iota(m_order.begin(), m_order.end(), 0);
    for (const auto& [from, to] : m_segments)
        m_size = std::max({m_size, from.lpNorm<Eigen::Infinity>(), to.lpNorm<Eigen::Infinity>()});
    if (!empty()) build(0, static_cast<int>(m_order.size()));
}

/// The node around the segments at these places, and all below it; returns its number.
int SegmentTree::build(int first, int last) {
    const int number = static_cast<int>(m_nodes.size());
    BoxNode node{m_segments[m_order[first]].from, m_segments[m_order[first]].from, first, 0};
    for (int i = first; i < last; ++i) {
        const auto& [from, to] = m_segments[m_order[i]];
        node.low = node.low.cwiseMin(from).cwiseMin(to);
        node.high = node.high.cwiseMax(from).cwiseMax(to);
    }
    if (last - first <= k_segments_in_leaf) node.count = last - first;
    m_nodes.push_back(node);
    if (node.count > 0) return number;
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const int middle = first + (last - first) / 2;
    const auto place = [&](int k) { return std::pair(middle_of(m_segments[k])[axis], k); };
    std::nth_element(m_order.begin() + first, m_order.begin() + middle, m_order.begin() + last,
                     [&](int a, int b) { return place(a) < place(b); });
    build(first, middle);
    const int right = build(middle, last);
    m_nodes[number].first = right;
    return number;
}

struct SegmentTree::Search {
    const Eigen::Vector3d& point;
    const std::function<bool(const Segment&)>& counts;
    double tolerance;
    Nearest best;
    double farthest;  // of boxes that are looked into, squared

    Search(const Eigen::Vector3d& from, const std::function<bool(const Segment&)>& of, double size, double most)
        : point(from), counts(of), tolerance(k_box_tolerance * (size + from.lpNorm<Eigen::Infinity>())) {
        keep({-1, most});
    }

    void keep(const Nearest& nearest) {
        best = nearest;
        const double distance = std::sqrt(best.squared_distance) + tolerance;
        farthest = distance * distance;
    }

    void consider(int number, const Segment& segment) {
        if (counts && !counts(segment)) return;
        const double square = squared_distance(point, segment.from, segment.to);
        const bool is_first = square == best.squared_distance && number < best.segment;
        if (square < best.squared_distance || is_first) keep({number, square});
    }
};

SegmentTree::Nearest SegmentTree::nearest(const Eigen::Vector3d& point, double most,
                                          const std::function<bool(const Segment&)>& counts) const {
    Search search(point, counts, m_size, most);
    if (!empty()) visit(0, search);
    return search.best;
}

void SegmentTree::visit(int number, Search& search) const {
    const BoxNode& node = m_nodes[number];
    for (int i = node.first; i < node.first + node.count; ++i) search.consider(m_order[i], m_segments[m_order[i]]);
    if (node.count > 0) return;
    std::pair<double, int> near{squared_distance(m_nodes[number + 1], search.point), number + 1},
        far{squared_distance(m_nodes[node.first], search.point), node.first};
    if (far < near) std::swap(near, far);
    for (const auto& [distance, child] : {near, far})
        if (!(distance > search.farthest)) visit(child, search);
}

Segment segment_of(const Surface& surface, int side) {
    return {surface.positions().col(surface.from(side)), surface.positions().col(surface.to(side))};
}

SegmentTree border_of(const Surface& surface) {
    std::vector<Segment> border;
    for (int side = 0; side < 3 * surface.face_count(); ++side)
        if (surface.opposite(side) < 0) border.push_back(segment_of(surface, side));
    return SegmentTree(std::move(border));
}

}  // namespace chebnet
