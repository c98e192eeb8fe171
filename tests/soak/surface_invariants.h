#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "drape/drape.h"
#include "invariants.h"
#include "net/measures.h"
#include "surface/surface.h"

/// What must hold of every net that is made on a surface, judged from outside: from positions and faces alone, with
/// neither the core's trees nor its measures. Each function returns a sentence for every invariant that is violated.
namespace chebnet::invariants {

/// How far one edge is from another's length, as dL in extended precision.
inline double reckoned_spread(const Net& net) {
    long double shortest = std::numeric_limits<long double>::infinity(), longest = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto along = [&](int axis) {
            return static_cast<long double>(net.rest_positions()(axis, net.edges()(0, e))) -
                   net.rest_positions()(axis, net.edges()(1, e));
        };
        const long double length = std::hypot(std::hypot(along(0), along(1)), along(2));
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
    const long double ratio = longest / shortest;
    return static_cast<double>((ratio - 1) * (ratio - 1) / ratio);
}

/// Radians, of the corners of quads whose edges have one length.
inline double reckoned_smallest_corner(const Net& net, double length) {
    const Positions& x = net.rest_positions();
    double smallest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        if (face.size() != 4) continue;
        double sharpest = smallest;
        bool is_whole = true;
        for (std::size_t k = 0; k < 4; ++k) {
            const Eigen::Vector3d a = (x.col(face[(k + 1) % 4]) - x.col(face[k])) / length,
                                  b = (x.col(face[(k + 3) % 4]) - x.col(face[k])) / length;
            is_whole = is_whole && std::abs(a.norm() - 1) < k_whole_edge;
            sharpest = std::min(sharpest, std::atan2(a.cross(b).norm(), a.dot(b)));
        }
        if (is_whole) smallest = sharpest;
    }
    return smallest;
}

/// From a point to a triangle (Ericson, Real-Time Collision Detection, 2005, section 5.1.5, by its edges and its face).
inline double distance_to_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                   const Eigen::Vector3d& c) {
    const auto to_edge = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        const Eigen::Vector3d side = to - from;
        const double square = side.squaredNorm();
        const double part = square > 0 ? std::clamp((p - from).dot(side) / square, 0.0, 1.0) : 0;
        return (p - from - part * side).norm();
    };
    const double least = std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    if (!(normal.squaredNorm() > 0)) return least;
    const auto is_inside = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        return (to - from).cross(p - from).dot(normal) >= 0;
    };
    if (!(is_inside(a, b) && is_inside(b, c) && is_inside(c, a))) return least;
    return std::min(least, std::abs((p - a).dot(normal)) / normal.norm());
}

/// The part of some points, scattered evenly over the surface, that is within half an edge of the net.
inline double reckoned_coverage(const Surface& surface, const Net& net, double length, int samples) {
    std::mt19937 random(1);
    const std::vector<double> areas(surface.areas().begin(), surface.areas().end());
    std::discrete_distribution<int> face(areas.begin(), areas.end());
    std::uniform_real_distribution<double> unit(0, 1);
    const Positions& x = net.rest_positions();
    int covered = 0;
    for (int k = 0; k < samples; ++k) {
        const double root = std::sqrt(unit(random)), part = unit(random);
        const Eigen::Vector3d point = surface.position_at({face(random), {1 - root, root * (1 - part), root * part}});
        bool is_near = false;
        for (int f = 0; f < net.face_count() && !is_near; ++f) {
            const std::span<const int> corners = net.faces()[f];
            for (std::size_t i = 1; i + 1 < corners.size() && !is_near; ++i)
                is_near = distance_to_triangle(point, x.col(corners[0]), x.col(corners[i]), x.col(corners[i + 1])) <=
                          length / 2;
        }
        covered += is_near ? 1 : 0;
    }
    return static_cast<double>(covered) / samples;
}

/// Of the whole border of a net, its length.
inline double reckoned_border(const Net& net) {
    double sum = 0;
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 1)
            sum += (net.rest_positions().col(net.edges()(0, e)) - net.rest_positions().col(net.edges()(1, e))).norm();
    return sum;
}

/// What was asked of a net on a surface.
struct Asked {
    double smallest_angle;    ///< radians
    bool may_be_cut = false;  ///< at the surface's border: edges there have other lengths
    double most_dL = 1e-9;
    int samples = 400;  ///< by which coverage is judged; 0: it is not
};

/// Positions are finite, edges of one length, corners within the limit, and the report says what the net leaves open:
/// no hole is passed over in silence.
inline Violations of_net_on_surface(const Surface& surface, const Net& net, const DrapeReport& report,
                                    const Asked& asked) {
    Violations violations;
    const auto require = [&](bool holds, const char* otherwise, double is, double says) {
        if (holds) return;
        char numbers[80];
        std::snprintf(numbers, sizeof numbers, " (%.6g, reported %.6g)", is, says);
        violations.push_back(std::string(otherwise) + numbers);
    };
    if (!net.rest_positions().allFinite()) return {"a vertex is not finite"};
    if (!asked.may_be_cut) {
        const double spread = reckoned_spread(net);
        require(spread < asked.most_dL, "edges differ in length", spread, report.max_deviation);
    }
    require(report.max_deviation < asked.most_dL, "the largest dL is reported as too large", asked.most_dL,
            report.max_deviation);
    const double corner = reckoned_smallest_corner(net, report.length);
    require(corner >= asked.smallest_angle - 1e-6, "a corner is sharper than the limit", corner, report.smallest_angle);
    require(!std::isfinite(corner) || std::abs(corner - report.smallest_angle) < 1e-6,
            "the sharpest corner is not the one reported", corner, report.smallest_angle);
    require(report.coverage >= 0 && report.coverage <= 1 + 1e-9, "coverage is no part", report.coverage,
            report.coverage);
    require(report.mean_distance >= 0 && report.mean_distance <= report.largest_distance * (1 + 1e-12),
            "the mean distance is beyond the largest", report.mean_distance, report.largest_distance);
    if (surface.boundary_loops().empty()) {
        const double border = reckoned_border(net);
        require(std::abs(border - report.open_border) <= 1e-6 * (border + report.open_border),
                "on a closed surface all of the net's border is open", border, report.open_border);
    }
    if (asked.samples > 0) {
        const double covered = reckoned_coverage(surface, net, report.length, asked.samples);
        // Five times the deviation that so many samples have.
        const double slack = 2.5 / std::sqrt(asked.samples);
        require(std::abs(covered - report.coverage) < slack, "other than the part reported is covered", covered,
                report.coverage);
    }
    return violations;
}

}  // namespace chebnet::invariants
