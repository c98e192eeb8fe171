#include "net/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "net/corner_edges.h"

namespace chebnet {

namespace {

bool is_in_range(double number) {
    return number >= std::numeric_limits<double>::min() && number <= std::numeric_limits<double>::max();
}

/// Also for a vector whose square would overflow or underflow.
double length(const Eigen::Vector3d& d) {
    const double square = d.squaredNorm();
    return is_in_range(square) ? std::sqrt(square) : d.stableNorm();
}

/// Also between vectors whose product would overflow or underflow; 0 if one has no length.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const auto angle = [](const auto& u, const auto& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); };
    return is_in_range(a.squaredNorm() * b.squaredNorm())
               ? angle(a, b)
               : angle(a.stableNormalized().eval(), b.stableNormalized().eval());
}

/// Calls visit(vertex, angle, face) for every corner of every face.
template <typename Visit>
void for_each_corner(const Net& net, const Positions& x, Visit visit) {
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k) {
            const int v = face[k];
            const Eigen::Vector3d to_next = x.col(face[(k + 1) % n]) - x.col(v);
            const Eigen::Vector3d to_previous = x.col(face[(k + n - 1) % n]) - x.col(v);
            visit(v, angle_between(to_next, to_previous), f);
        }
    }
}

}  // namespace

Eigen::VectorXd edge_ratios(const Net& net, const Positions& positions) {
    Eigen::VectorXd ratios(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e)
        ratios[e] = length(positions.col(net.edges()(0, e)) - positions.col(net.edges()(1, e))) / net.rest_lengths()[e];
    return ratios;
}

double max_deviation(const Eigen::VectorXd& ratios) {
    double largest = 0;
    for (double r : ratios) {
        const double dL = deviation(r);
        if (!std::isfinite(dL)) return std::numeric_limits<double>::infinity();
        largest = std::max(largest, dL);
    }
    return largest;
}

double max_deviation(const Net& net, const Positions& positions) {
    // dL grows with the distance of r from 1 on either side: one of the two extreme ratios has the largest.
    const auto vector = [&](int e) -> Eigen::Vector3d {
        return positions.col(net.edges()(0, e)) - positions.col(net.edges()(1, e));
    };
    double least = std::numeric_limits<double>::infinity(), most = 0, sum = 0;
    int shortest = 0, longest = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double squared_ratio = vector(e).squaredNorm() / (net.rest_lengths()[e] * net.rest_lengths()[e]);
        sum += squared_ratio;
        if (squared_ratio < least) least = squared_ratio, shortest = e;
        if (squared_ratio > most) most = squared_ratio, longest = e;
    }
    const bool in_range = std::isfinite(sum) && least >= std::numeric_limits<double>::min();
    if (!in_range) return max_deviation(edge_ratios(net, positions));
    const auto deviation_of = [&](int e) { return deviation(vector(e).norm() / net.rest_lengths()[e]); };
    return std::max(deviation_of(shortest), deviation_of(longest));
}

LengthRange edge_length_range(const Net& net, const Positions& positions) {
    LengthRange range{std::numeric_limits<double>::infinity(), 0};
    for (const auto& ends : net.edges().colwise()) {
        const double edge = length(positions.col(ends(0)) - positions.col(ends(1)));
        range = {std::min(range.shortest, edge), std::max(range.longest, edge)};
    }
    return range;
}

std::optional<double> shared_length(const Net& net) {
    if (net.is_chebyshev()) return net.mean_length();
    Eigen::VectorXd lengths = net.rest_lengths();
    const auto middle = lengths.begin() + lengths.size() / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    const double length = *middle;
    const auto count = std::count_if(lengths.begin(), lengths.end(),
                                     [&](double each) { return std::abs(each - length) < k_whole_edge * length; });
    if (2 * count <= lengths.size()) return std::nullopt;
    return length;
}

double max_deviation_from_mean(const Net& net) {
    // dL grows away from the mean on both sides.
    const auto [shortest, longest] = edge_length_range(net, net.rest_positions());
    return std::max(deviation(shortest / net.mean_length()), deviation(longest / net.mean_length()));
}

std::map<int, int> faces_by_arity(const Faces& faces) {
    std::map<int, int> counts;
    for (int f = 0; f < faces.size(); ++f) ++counts[static_cast<int>(faces[f].size())];
    return counts;
}

AngleRange corner_angle_range(const Net& net, const Positions& positions) {
    AngleRange range{std::numbers::pi, 0};
    for_each_corner(net, positions, [&](int, double angle, int) {
        range.smallest = std::min(range.smallest, angle);
        range.largest = std::max(range.largest, angle);
    });
    return range;
}

int sharp_quads(const Net& net, const Positions& positions, double angle) {
    std::vector<bool> is_sharp(static_cast<std::size_t>(net.face_count()), false);
    for_each_corner(net, positions, [&](int, double corner, int f) {
        if (net.faces()[f].size() == 4 && corner < angle) is_sharp[f] = true;
    });
    return static_cast<int>(std::count(is_sharp.begin(), is_sharp.end(), true));
}

int sharp_folds(const Net& net, const Positions& positions, double angle) {
    const std::vector<double> folds = fold_angles(net, positions);
    return static_cast<int>(
        std::count_if(folds.begin(), folds.end(), [&](double fold) { return fold > angle + k_limit_tolerance; }));
}

std::vector<double> fold_angles(const Net& net, const Positions& positions) {
    struct Side {
        Eigen::Vector3d normal;
        bool is_forward;
    };
    const std::vector<int> edges = corner_edges(net, Topology(net));
    std::vector<std::optional<Side>> firsts(static_cast<std::size_t>(net.edge_count()));
    std::vector<double> folds;
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        // Newell's sum: faces need not be plane.
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            normal += (positions.col(face[k]) - positions.col(face[0]))
                          .cross(positions.col(face[k + 1]) - positions.col(face[0]));
        for (std::size_t k = 0; k < face.size(); ++k) {
            const int edge = edges[net.faces().start[f] + static_cast<int>(k)];
            const bool is_forward = face[k] == net.edges()(0, edge);
            std::optional<Side>& first = firsts[edge];
            if (!first) {
                first = {normal, is_forward};
                continue;
            }
            // Neighbours that are wound alike run along an edge both ways.
            const Eigen::Vector3d other = first->is_forward == is_forward ? -first->normal : first->normal;
            folds.push_back(std::atan2(normal.cross(other).norm(), normal.dot(other)));
        }
    }
    return folds;
}

int new_folds(const Net& net, const Positions& before, const Positions& now) {
    const std::vector<double> old_folds = fold_angles(net, before), folds = fold_angles(net, now);
    int count = 0;
    for (std::size_t k = 0; k < folds.size(); ++k) count += folds[k] > old_folds[k] + k_fold ? 1 : 0;
    return count;
}

Positions vertex_normals(const Net& net, const Positions& x) {
    Positions normals = Positions::Zero(3, x.cols());
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        Eigen::Vector3d area = Eigen::Vector3d::Zero();
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            area += (x.col(face[k]) - x.col(face[0])).cross(Eigen::Vector3d(x.col(face[k + 1]) - x.col(face[0])));
        for (int v : face) normals.col(v) += area;
    }
    for (int v = 0; v < normals.cols(); ++v) normals.col(v).stableNormalize();
    return normals;
}

Eigen::VectorXd vertex_corner_angles(const Net& net, const Positions& positions) {
    const double right = std::numbers::pi / 2;
    Eigen::VectorXd farthest = Eigen::VectorXd::Constant(net.vertex_count(), right);
    const auto is_quad = [&](int f) { return net.faces()[f].size() == 4; };
    bool has_quads = false;
    for (int f = 0; f < net.face_count(); ++f) has_quads = has_quads || is_quad(f);
    for_each_corner(net, positions, [&](int v, double angle, int f) {
        if (has_quads && !is_quad(f)) return;
        if (std::abs(angle - right) > std::abs(farthest[v] - right)) farthest[v] = angle;
    });
    return farthest;
}

double bend(const Net& net, const Topology& topology, const Positions& positions) {
    const std::vector<int> straight_on = topology.straight_on(InwardCorners::pass);
    const Positions& rest = net.rest_positions();
    double sum = 0;
    long pairs = 0;
    for (int v = 0, first = 0; v < net.vertex_count(); first += topology.valence(v++)) {
        const std::span<const int> neighbours = topology.neighbours(v), edges = topology.incident_edges(v);
        for (int i = 0; i < topology.valence(v); ++i) {
            const int j = straight_on[first + i] - first;
            if (j <= i) continue;
            const int a = neighbours[i], b = neighbours[j];
            const double length = (net.rest_lengths()[edges[i]] + net.rest_lengths()[edges[j]]) / 2;
            const auto curvature = [&](const Positions& x) {
                return (x.col(a) - 2 * x.col(v) + x.col(b)).norm() / length;
            };
            const double change = curvature(positions) - curvature(rest);
            sum += change * change;
            ++pairs;
        }
    }
    return pairs > 0 ? std::sqrt(sum / static_cast<double>(pairs)) : 0;
}

}  // namespace chebnet
