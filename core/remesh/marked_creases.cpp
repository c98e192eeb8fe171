#include "remesh/marked_creases.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "remesh/creases.h"
#include "surface/segment_tree.h"
#include "surface/surface_cut.h"

namespace chebnet {

namespace {

const std::string k_name = "marked crease";

// Of the squared cosine of the angle between a crease and an edge that runs along it.
constexpr double k_along_crease = 0.75;
constexpr double k_samples = 4;  // of each edge length

/// Points of a way, and its direction there.
template <class Visit>
void walk(const Positions& way, double spacing, Visit visit) {
    double next = spacing / 2;  // from the segment's beginning
    for (Eigen::Index k = 0; k + 1 < way.cols(); ++k) {
        const Eigen::Vector3d from = way.col(k), segment = way.col(k + 1) - from;
        const double length = segment.norm();
        for (; next < length; next += spacing) visit(Eigen::Vector3d(from + next / length * segment), segment / length);
        next -= length;
    }
}

std::vector<CutLine> marked_lines(const Guide& guide, const std::vector<MarkedCrease>& creases) {
    if (std::ssize(creases) > k_most_marked_creases)
        throw Error(ErrorCode::too_large,
                    "no more than " + std::to_string(k_most_marked_creases) + " creases are marked");
    Eigen::Index points = 0;
    for (const MarkedCrease& crease : creases) points += crease.cols();
    if (points > k_most_marked_points)
        throw Error(ErrorCode::too_large,
                    "marked creases have no more than " + std::to_string(k_most_marked_points) + " points together");
    std::vector<CutLine> lines;
    for (std::size_t k = 0; k < creases.size(); ++k)
        lines.push_back(cut_line(guide.surface(), guide.tree(), creases[k], k_name + " " + std::to_string(k + 1)));
    return lines;
}

}  // namespace

void check_marked(const Guide& guide, const std::vector<MarkedCrease>& creases) { marked_lines(guide, creases); }

std::vector<Segment> Creases::segments() const {
    const Surface& surface = guide->surface();
    std::vector<Segment> segments;
    for (int s = 0; s < std::ssize(sides); ++s)
        if (sides[s] && surface.opposite(s) < s) segments.push_back(segment_of(surface, s));
    return segments;
}

Creases find_creases(const std::shared_ptr<const Guide>& guide, double angle, const std::vector<MarkedCrease>& marked) {
    Creases creases{guide, {}, {}};
    std::vector<bool> is_marked;
    if (!marked.empty()) {
        const std::vector<CutLine> lines = marked_lines(*guide, marked);
        for (std::size_t k = 0; k < lines.size(); ++k)
            creases.marked.push_back(cut_path(guide->surface(), lines[k], k_name + " " + std::to_string(k + 1)));
        SurfaceWithLines split = with_lines(guide->surface(), lines, k_name);
        creases.guide = std::make_shared<const Guide>(std::move(split.surface));
        is_marked = std::move(split.is_on_line);
    }
    if (angle > 0) creases.sides = creases_of(creases.guide->surface(), angle);
    creases.sides.resize(std::max(creases.sides.size(), is_marked.size()), false);
    for (std::size_t s = 0; s < is_marked.size(); ++s)
        if (is_marked[s]) creases.sides[s] = true;
    return creases;
}

double distance_along(const Net& net, const Positions& way) {
    const Positions& x = net.rest_positions();
    std::vector<Segment> all;
    for (const auto& edge : net.edges().colwise()) all.push_back({x.col(edge[0]), x.col(edge[1])});
    const SegmentTree edges(std::move(all));
    const double edge_length = net.mean_length();
    double sum = 0;
    int count = 0;
    walk(way, edge_length / k_samples, [&](const Eigen::Vector3d& point, const Eigen::Vector3d& along) {
        const auto runs_along = [&](const Segment& edge) {
            const double cosine = (edge.to - edge.from).dot(along);
            return cosine * cosine > k_along_crease * (edge.to - edge.from).squaredNorm();
        };
        sum += std::sqrt(edges.nearest(point, edge_length * edge_length, runs_along).squared_distance);
        ++count;
    });
    return count > 0 ? sum / count / edge_length : 0;
}

}  // namespace chebnet
