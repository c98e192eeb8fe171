#include "edit/taut_lines.h"

#include <algorithm>
#include <utility>

#include "net/measures.h"

namespace chebnet {

namespace {

// Handles, the lines between them, and lines between those: more rounds find no more in most nets.
constexpr std::size_t k_most_rounds = 4;
// A line that turns by no more than this, as a cosine, stays nearly straight on a straight way of its ends.
constexpr double k_least_turn = 0.9;
// A line is torn if it is to be longer by more than this part: the usual threshold takes edges that are a thousandth
// too long for those of a net.
constexpr double k_tear = 2e-3;

}  // namespace

Eigen::Matrix3Xd places_of(std::span<const TautVertex> taut, const Eigen::Matrix3Xd& handles) {
    const auto count = static_cast<Eigen::Index>(taut.size());
    Eigen::Matrix3Xd ends(3, handles.cols() + count);
    ends.leftCols(handles.cols()) = handles;
    for (Eigen::Index i = 0; i < count; ++i) ends.col(handles.cols() + i) = taut[i].place(ends);
    return ends.rightCols(count);
}

std::vector<TautVertex> TautLines::find(const Net& net, const Topology& topology, const HandleGraph& graph,
                                        std::vector<int> vertices, const Eigen::Matrix3Xd& targets,
                                        std::vector<bool> avoided, const Positions& positions,
                                        const Positions& last_net, double nearness) {
    m_steps_left = k_most_steps;
    m_is_torn = false;
    const double longest = edge_ratios(net, last_net).maxCoeff();
    Eigen::Matrix3Xd ends = targets;
    std::vector<TautVertex> found;
    const auto was_straight = [&](const TautVertex& taut) {
        const Eigen::Vector3d a = last_net.col(vertices[taut.end_a]), b = last_net.col(vertices[taut.end_b]),
                              line = ends.col(taut.end_b) - ends.col(taut.end_a);
        return (last_net.col(taut.vertex) - (a + taut.part * (b - a))).norm() <= nearness &&
               line.dot(b - a) >= k_least_turn * line.norm() * (b - a).norm();
    };
    const auto is_clear = [&](const TautVertex& taut) {
        const bool is_there = (positions.col(taut.vertex) - taut.place(ends)).norm() <= nearness;
        return !avoided[taut.vertex] && (is_there || was_straight(taut));
    };
    for (std::size_t k = 0; k < k_most_rounds; ++k) {
        if (k == m_rounds.size()) m_rounds.emplace_back();
        Round& round = m_rounds[k];
        if (round.ends != vertices)
            round = {vertices, k == 0 ? HandleGraph() : HandleGraph(net, topology, vertices), {}};
        const HandleGraph& between = k == 0 ? graph : round.graph;
        const std::size_t known = found.size();
        for (int a = 0; a < between.size(); ++a)
            for (const auto& [b, length] : between.neighbours(a)) {
                if (b < a || vertices[a] < 0 || vertices[b] < 0) continue;
                const double distance = (ends.col(a) - ends.col(b)).norm();
                if (!(distance >= (1 - k_slack) * length)) continue;
                m_is_torn |= distance > (1 + k_tear) * length;
                const Line* found_line = line(net, topology, round, a, b, length, last_net, longest);
                if (found_line == nullptr) continue;
                const std::vector<TautVertex>& inside = found_line->inside;
                if (!std::all_of(inside.begin(), inside.end(), is_clear)) continue;
                found.insert(found.end(), inside.begin(), inside.end());
                for (const TautVertex& taut : inside) avoided[taut.vertex] = true;
            }
        if (found.size() == known) break;
        const Eigen::Matrix3Xd places = places_of(found, targets);
        ends.resize(3, targets.cols() + places.cols());
        ends << targets, places;
        for (std::size_t i = known; i < found.size(); ++i) vertices.push_back(found[i].vertex);
    }
    return found;
}

const TautLines::Line* TautLines::line(const Net& net, const Topology& topology, Round& round, int a, int b,
                                       double length, const Positions& last_net, double longest) {
    const auto place = std::lower_bound(
        round.lines.begin(), round.lines.end(), std::pair(a, b),
        [](const Line& line, const std::pair<int, int>& ends) { return std::pair(line.end_a, line.end_b) < ends; });
    if (place != round.lines.end() && place->end_a == a && place->end_b == b) return &*place;
    const auto path =
        inside_of_shortest_path(net, topology, round.ends[a], round.ends[b], length, last_net, longest, m_steps_left);
    if (!path) return nullptr;
    Line line{a, b, {}};
    for (const auto& [vertex, distance] : *path) line.inside.push_back({vertex, a, b, distance / length});
    return &*round.lines.insert(place, std::move(line));
}

}  // namespace chebnet
