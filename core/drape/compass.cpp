#include "drape/compass.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "surface/geodesics.h"

namespace chebnet {

namespace {

/// Around a circle in search of the surface, with a sine and a cosine that are numbers everywhere the same.
struct Steps {
    double cosine, sine;
    int most;
    double least_cosine;  // between the normals across a cell
};
// Of 16°. They pass unseen through a body that is thinner than they are long; where they find nothing, steps of 1.6°
// do, if only on this side of it.
constexpr Steps k_round_steps = {24. / 25, 7. / 25, 5, -1}, k_fine_steps = {4899. / 4901, 140. / 4901, 25, 0.5};
constexpr int k_most_iterations = 60;
// In edge lengths: how near a vertex comes to the surface at the least, and at the most where the surface is rough.
constexpr double k_near = 1e-14, k_near_enough = 1e-9;
// Likewise of one that lies straight on beyond the border, where the surface goes on as flat as it is there: on a
// rough one that is no way to go.
constexpr double k_near_beyond = 0.5;
// A geodesic this many edges long that has not come one edge far is going round in a fold.
constexpr double k_longest_way = 3;
// So is one that has crossed so many triangles, of a body that is thin as a thread beside the edge.
constexpr int k_most_crossed = 20'000;
// Of its largest size: below it a circle is a point, and the net locked.
constexpr double k_least_radius = 1e-6;

}  // namespace

DrapedVertex Compass::vertex_at(const Eigen::Vector3d& position, int guess) const {
    const Height here = height(position, guess);
    return {position, here.at, here.normal, here.overhang};
}

/// Where a way has left the surface over its border; nullopt where that is too far above it.
std::optional<DrapedVertex> Compass::vertex_beyond(const Eigen::Vector3d& position, int guess) const {
    if (!position.allFinite()) return std::nullopt;
    const Height here = height(position, guess);
    if (!(std::abs(here.height) <= k_near_beyond * m_length)) return std::nullopt;
    return DrapedVertex{position, here.at, here.normal, here.overhang};
}

Height Compass::height(const Eigen::Vector3d& point, int from) const {
    if (m_slits == nullptr) return height_of(m_surface, m_tree, point, from);
    return height_at(m_surface, m_slits->nearest(point, from), point);
}

std::optional<DrapedVertex> Compass::straight_on(const DrapedVertex& from, Eigen::Vector3d& direction) const {
    // How far to go from q along u until it is one edge from `from`.
    const auto rest_of_way = [&](const Eigen::Vector3d& q, const Eigen::Vector3d& u) {
        const Eigen::Vector3d gone = q - from.position;
        const double along = gone.dot(u);
        return -along + std::sqrt(along * along + m_length * m_length - gone.squaredNorm());
    };
    try {
        GeodesicWalk walk(m_surface, from.at, direction);
        Eigen::Vector3d here = from.position;
        double way = 0;
        int crossed = 0;
        while (!walk.is_at_boundary()) {
            const int face = walk.point().face;
            const Eigen::Vector3d heading = walk.direction();
            const double rest = rest_of_way(here, heading);
            if (!(rest >= 0)) return std::nullopt;
            const double step = walk.advance(rest);
            way += step;
            if (step >= rest) {
                direction = heading;
                return vertex_at(here + rest * heading, face);
            }
            if (way > k_longest_way * m_length || ++crossed > k_most_crossed) return std::nullopt;
            here = walk.position();
        }
        direction = walk.direction();
        return vertex_beyond(here + rest_of_way(here, direction) * direction, walk.point().face);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// The points one edge away from two vertices, seen by their heights over the surface.
class Compass::Circle {
public:
    /// A point of it, by its direction from the centre.
    struct Point {
        Eigen::Vector3d direction, position;
        Height height;
    };

    Circle(const Compass& compass, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius, int guess)
        : m_compass(compass), m_centre(centre), m_axis(axis), m_radius(radius), m_guess(guess) {}

    Point at(const Eigen::Vector3d& direction) const {
        const Eigen::Vector3d position = m_centre + m_radius * direction;
        return {direction, position, m_compass.height(position, m_guess)};
    }

    /// A step round, forwards or backwards.
    Point after(const Point& point, const Steps& steps, bool forwards) const {
        const Eigen::Vector3d sideways = m_axis.cross(point.direction);
        return at((steps.cosine * point.direction + (forwards ? steps.sine : -steps.sine) * sideways).normalized());
    }

    /// Where the height is 0 between two points with heights of different signs (regula falsi with the weights of
    /// Illinois, Dowell & Jarratt 1971).
    Point zero_between(Point a, Point b) const {
        double height_a = a.height.height, height_b = b.height.height;
        Point middle = std::abs(height_a) < std::abs(height_b) ? a : b;
        for (int k = 0; k < k_most_iterations; ++k) {
            const double fraction = height_a / (height_a - height_b);
            middle = at(((1 - fraction) * a.direction + fraction * b.direction).normalized());
            const double height = middle.height.height;
            if (std::abs(height) <= k_near * m_compass.m_length) break;
            if ((height > 0) == (height_b > 0)) {
                height_a /= 2;
            } else {
                a = b;
                height_a = height_b;
            }
            b = middle;
            height_b = height;
        }
        return middle;
    }

private:
    const Compass& m_compass;
    Eigen::Vector3d m_centre, m_axis;
    double m_radius;
    int m_guess;
};

std::optional<DrapedVertex> Compass::across(const DrapedVertex& d, const DrapedVertex& a, const DrapedVertex& b) const {
    const Eigen::Vector3d centre = (a.position + b.position) / 2, half = b.position - centre,
                          away = centre - d.position;
    const double squared_radius = m_length * m_length - half.squaredNorm();
    const double least = k_least_radius * m_length;
    if (!(squared_radius > least * least && half.norm() > least && away.norm() > least)) return std::nullopt;
    const Circle circle(*this, centre, half.normalized(), std::sqrt(squared_radius), a.at.face);

    const Circle::Point start = circle.at(away.normalized());
    const bool is_above = start.height.height > 0;
    const bool is_downwards = half.cross(start.direction).dot(start.height.normal) < 0;
    for (const Steps& steps : {k_round_steps, k_fine_steps}) {
        Circle::Point forwards = start, backwards = start;
        for (int k = 0; k < steps.most; ++k)
            for (const bool forward : {is_above == is_downwards, is_above != is_downwards}) {
                Circle::Point& last = forward ? forwards : backwards;
                const Circle::Point next = circle.after(last, steps, forward);
                const Circle::Point previous = std::exchange(last, next);
                if ((next.height.height > 0) == (previous.height.height > 0)) continue;
                const Circle::Point zero = circle.zero_between(previous, next);
                if (!(std::abs(zero.height.height) <= k_near_enough * m_length + m_rounding)) continue;
                if (zero.height.normal.dot(d.normal) < steps.least_cosine) continue;
                return DrapedVertex{zero.position, zero.height.at, zero.height.normal, zero.height.overhang};
            }
    }
    return std::nullopt;
}

}  // namespace chebnet
