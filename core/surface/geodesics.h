#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// A walk straight on over a surface: within a triangle along a line, over an edge so that both triangles unfolded see
/// one line, through a vertex with equal angles on both sides (Polthier & Schmies, Straightest geodesics on polyhedral
/// surfaces, 1998). Keeps a reference to the surface, which must outlive it.
class GeodesicWalk {
public:
    /// The direction (not 0) is laid into the surface; its length does not matter. Throws Error bad_option where it
    /// points straight off the surface, or nothing there has area.
    GeodesicWalk(const Surface& surface, const SurfacePoint& start, const Eigen::Vector3d& direction);

    /// Goes on within one triangle, no farther than `most`; returns how far. What ends at an edge has crossed it.
    double advance(double most);
    /// Whether it stands at the boundary and can go no farther.
    bool is_at_boundary() const { return m_is_at_boundary; }

    const SurfacePoint& point() const { return m_point; }
    Eigen::Vector3d position() const { return m_surface.position_at(m_point); }
    /// A unit vector in the plane of the triangle.
    const Eigen::Vector3d& direction() const { return m_direction; }

private:
    Eigen::Vector3d rates(int face, const Eigen::Vector3d& direction) const;
    void lay_into(int face, const Eigen::Vector3d& direction);
    bool choose_face_around(int corner_side, const Eigen::Vector3d& direction);
    void cross(int side);
    void enter(int side, double fraction, double along, double across);
    void pass_vertex(int corner);
    double corner_angle(int side) const;
    Eigen::Vector3d vector_of(int side) const;

    const Surface& m_surface;
    SurfacePoint m_point;
    Eigen::Vector3d m_direction;
    bool m_is_at_boundary = false;
};

/// A straightest geodesic.
struct Geodesic {
    Positions points;  ///< 3×N, from the start over every edge crossed to the end
    SurfacePoint end;  ///< where it ends
    Eigen::Vector3d end_direction;
    double length;  ///< less than asked for if it has met the boundary
    bool met_boundary;
};
/// From `start` along `direction` for `length` (≥ 0). Throws Error as GeodesicWalk does, and bad_option.
Geodesic trace_geodesic(const Surface& surface, const SurfacePoint& start, const Eigen::Vector3d& direction,
                        double length);

/// The distance at corner c of a triangle with the sides ab, bc, ca from a source in its plane on the other side of ab,
/// which is at the distances da, db from a and b. If the straight way from there does not pass between a and b, the
/// shorter way along an edge.
double distance_across(double da, double db, double ab, double bc, double ca);

/// V, the distance over the surface to the nearest of the `sources`; infinity where that is more than `most`, or in
/// components without one. By fast marching (Kimmel & Sethian 1998), where each triangle is unfolded with a source at
/// which its two known corners have their distances (Novotni & Klein 2002). In a plane it misses less than a tenth of a
/// triangle's side.
std::vector<double> geodesic_distances(const Surface& surface, std::span<const SurfacePoint> sources,
                                       double most = std::numeric_limits<double>::infinity());

/// The distances of vertices to the nearest of several sources, and which these are.
struct NearestSources {
    std::vector<double> distances;  ///< V, as geodesic_distances() gives
    std::vector<int> sources;       ///< V, numbers of sources: of two that are alike one; −1 at infinity
};
NearestSources nearest_sources(const Surface& surface, std::span<const SurfacePoint> sources);

}  // namespace chebnet
