#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "surface/box.h"
#include "surface/segment.h"
#include "surface/surface.h"

namespace chebnet {

/// A tree of boxes around segments, in flat arrays: which is nearest to a point. Building takes O(N log² N) operations,
/// a query about O(log N).
class SegmentTree {
public:
    explicit SegmentTree(std::vector<Segment> segments = {});

    const std::vector<Segment>& segments() const { return m_segments; }
    bool empty() const { return m_segments.empty(); }

    struct Nearest {
        int segment;  ///< its place; −1: none
        double squared_distance;
    };
    /// Of the segments that count, all unless told otherwise, the one nearest to `point` by squared_distance(), the
    /// first of equally near ones: as from a look at each of them in turn, to the last bit. None, at `most`, if none is
    /// nearer than that, squared.
    Nearest nearest(const Eigen::Vector3d& point, double most = std::numeric_limits<double>::infinity(),
                    const std::function<bool(const Segment&)>& counts = nullptr) const;

private:
    struct Search;

    int build(int first, int last);
    void visit(int number, Search& search) const;

    std::vector<Segment> m_segments;
    std::vector<BoxNode> m_nodes;
    std::vector<int> m_order;  // by leaves
    double m_size = 0;         // the largest coordinate
};

Segment segment_of(const Surface& surface, int side);
/// The sides on the boundary.
SegmentTree border_of(const Surface& surface);

}  // namespace chebnet
