#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "surface/geodesics.h"

namespace chebnet {

namespace {

// A walk that comes closer to a vertex than this fraction of an edge goes through it.
constexpr double k_at_vertex = 1e-12;
// A direction that leaves a triangle's side no faster than this runs along it.
constexpr double k_along = 1e-13;
constexpr double k_no_limit = std::numeric_limits<double>::infinity();

int corner_of(const SurfacePoint& point) {
    for (int k = 0; k < 3; ++k)
        if (point.weights[k] >= 1 - k_at_vertex) return k;
    return -1;
}

SurfacePoint point_on_side(int side, double fraction) {
    SurfacePoint point{Surface::face_of(side), Eigen::Vector3d::Zero()};
    point.weights[side % 3] = 1 - fraction;
    point.weights[Surface::next(side) % 3] = fraction;
    return point;
}

}  // namespace

GeodesicWalk::GeodesicWalk(const Surface& surface, const SurfacePoint& start, const Eigen::Vector3d& direction)
    : m_surface(surface), m_point(start), m_direction(Eigen::Vector3d::Zero()) {
    const int corner = corner_of(start);
    if (corner < 0 || !choose_face_around(3 * start.face + corner, direction)) lay_into(start.face, direction);
    if (m_direction.isZero(0))
        throw Error(ErrorCode::bad_option, "a direction that stands upright on the surface leads nowhere on it");
}

/// How fast the barycentric coordinates change on the way.
Eigen::Vector3d GeodesicWalk::rates(int face, const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d sideways =
        direction.cross(m_surface.face_normals().col(face)) / (2 * m_surface.areas()[face]);
    const int side = 3 * face;
    return {sideways.dot(vector_of(side + 1)), sideways.dot(vector_of(side + 2)), sideways.dot(vector_of(side))};
}

void GeodesicWalk::lay_into(int face, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d normal = m_surface.face_normals().col(face);
    const Eigen::Vector3d laid = direction - direction.dot(normal) * normal;
    const bool is_upright = normal.isZero(0) || !(laid.norm() > 1e-9 * direction.norm());
    m_direction = is_upright ? Eigen::Vector3d::Zero() : Eigen::Vector3d(laid.normalized());
}

/// Of the triangles around the vertex at which a side begins, the one into which the direction leads most clearly.
bool GeodesicWalk::choose_face_around(int corner_side, const Eigen::Vector3d& direction) {
    double clearest = -k_no_limit;
    Eigen::Vector3d chosen = Eigen::Vector3d::Zero();
    for (const int side : m_surface.sides_around(m_surface.from(corner_side))) {
        lay_into(Surface::face_of(side), direction);
        if (!m_direction.isZero(0)) {
            const Eigen::Vector3d rate = rates(Surface::face_of(side), m_direction);
            const Eigen::Vector3d a = vector_of(side), b = -vector_of(Surface::previous(side));
            const double along_a = rate[Surface::next(side) % 3], along_b = rate[Surface::previous(side) % 3];
            const double inward = std::min(along_a * a.norm(), along_b * b.norm());
            if (inward > clearest) {
                clearest = inward;
                m_point = point_on_side(side, 0);
                // Laid into each triangle around a peak, a direction may lead into none of them: then along an edge.
                chosen = std::max(along_a, 0.0) * a + std::max(along_b, 0.0) * b;
            }
        }
    }
    if (chosen.isZero(0)) return false;
    m_direction = chosen.normalized();
    return true;
}

double GeodesicWalk::advance(double most) {
    if (m_is_at_boundary) return 0;
    const Eigen::Vector3d rate = rates(m_point.face, m_direction);
    double way = k_no_limit;
    int across = -1;  // the corner across from the side by which the triangle is left
    const double least_rate = k_along * rate.cwiseAbs().maxCoeff();
    for (int k = 0; k < 3; ++k)
        if (rate[k] < -least_rate && -m_point.weights[k] / rate[k] < way) {
            way = -m_point.weights[k] / rate[k];
            across = k;
        }
    if (way > most) {
        m_point.weights = (m_point.weights + most * rate).cwiseMax(0.0);
        m_point.weights /= m_point.weights.sum();
        return most;
    }
    m_point.weights = (m_point.weights + way * rate).cwiseMax(0.0);
    m_point.weights[across] = 0;
    m_point.weights /= m_point.weights.sum();
    const int corner = corner_of(m_point);
    if (corner >= 0)
        pass_vertex(corner);
    else
        cross(Surface::next(3 * m_point.face + across));
    return way;
}

void GeodesicWalk::cross(int side) {
    const Eigen::Vector3d edge = vector_of(side).normalized();
    const double along = m_direction.dot(edge);
    const double fraction = m_point.weights[Surface::next(side) % 3];
    const int other = m_surface.opposite(side);
    if (other < 0)
        m_is_at_boundary = true;
    else
        enter(other, 1 - fraction, -along, std::sqrt(std::max(0.0, 1 - along * along)));
}

/// Into the triangle of a side at a fraction of its length, with a direction along it and away from it.
void GeodesicWalk::enter(int side, double fraction, double along, double across) {
    m_point = point_on_side(side, fraction);
    const Eigen::Vector3d edge = vector_of(side).normalized();
    const Eigen::Vector3d normal = m_surface.face_normals().col(Surface::face_of(side));
    m_direction = (along * edge + across * normal.cross(edge)).normalized();
    if (!normal.isZero(0)) return;
    // A triangle without area has its third corner on the line of the side: it is left where it is entered.
    const double third = -vector_of(Surface::previous(side)).dot(edge), here = fraction * vector_of(side).norm();
    const int out = here < third ? Surface::previous(side) : Surface::next(side);
    const Eigen::Vector3d from_start = m_surface.position_at(m_point) - m_surface.positions().col(m_surface.from(out));
    const double out_part = std::clamp(from_start.norm() / vector_of(out).norm(), 0.0, 1.0);
    const int other = m_surface.opposite(out);
    m_point = point_on_side(out, out_part);
    if (other < 0)
        m_is_at_boundary = true;
    else
        enter(other, 1 - out_part, vector_of(other).dot(edge) > 0 ? along : -along, across);
}

/// Straight on through the vertex at a corner of the present triangle: half of all angle on each side.
void GeodesicWalk::pass_vertex(int corner) {
    const int arrival = 3 * m_point.face + corner;
    if (m_surface.is_boundary(m_surface.from(arrival))) {
        m_is_at_boundary = true;
        return;
    }
    double total = 0;
    for (const int side : m_surface.sides_from(arrival)) total += corner_angle(side);
    const Eigen::Vector3d edge = vector_of(arrival);
    double angle = std::atan2(edge.cross(-m_direction).norm(), edge.dot(-m_direction)) + total / 2;
    int side = arrival;
    while (angle > corner_angle(side)) {
        angle -= corner_angle(side);
        side = m_surface.around(side);
    }
    enter(side, 0, std::cos(angle), std::sin(angle));
}

/// At the vertex where a side begins.
double GeodesicWalk::corner_angle(int side) const {
    const Eigen::Vector3d a = vector_of(side), b = -vector_of(Surface::previous(side));
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Eigen::Vector3d GeodesicWalk::vector_of(int side) const {
    return m_surface.positions().col(m_surface.to(side)) - m_surface.positions().col(m_surface.from(side));
}

Geodesic trace_geodesic(const Surface& surface, const SurfacePoint& start, const Eigen::Vector3d& direction,
                        double length) {
    if (!(length >= 0 && std::isfinite(length)))
        throw Error(ErrorCode::bad_option, "the length of a geodesic must be a number of at least 0");
    GeodesicWalk walk(surface, start, direction);
    std::vector<Eigen::Vector3d> points{walk.position()};
    double gone = 0;
    while (gone < length && !walk.is_at_boundary()) {
        const double step = walk.advance(length - gone);
        gone += step;
        if (step > 0) points.push_back(walk.position());
    }
    Geodesic geodesic{Positions(3, points.size()), walk.point(), walk.direction(), gone, walk.is_at_boundary()};
    for (std::size_t i = 0; i < points.size(); ++i) geodesic.points.col(static_cast<Eigen::Index>(i)) = points[i];
    return geodesic;
}

}  // namespace chebnet
