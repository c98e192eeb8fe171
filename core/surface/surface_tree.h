#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surface/box.h"
#include "surface/surface.h"

namespace chebnet {

/// A tree of boxes around the triangles of a surface, in flat arrays: what is nearest to a point, what a ray meets.
/// Keeps a reference to the surface, which must outlive it. Building takes O(F log F) operations, a query about
/// O(log F); both compute with nothing but what IEEE 754 rounds exactly, so that they give the same bits natively and
/// in WebAssembly.
class SurfaceTree {
public:
    explicit SurfaceTree(const Surface& surface);

    const Surface& surface() const { return m_surface; }

    struct Nearest {
        SurfacePoint at;
        Eigen::Vector3d position;
        double distance;
    };
    /// The point of the surface nearest to `point` (finite). Of several equally near ones any, but always the same;
    /// from ten million sizes of the surface away the one that lies in the point's direction.
    Nearest nearest(const Eigen::Vector3d& point) const;
    /// The same point, found faster where it is close to the triangle `guess`.
    Nearest nearest(const Eigen::Vector3d& point, int guess) const;

    /// The nearest point of one triangle.
    Nearest nearest_in(int face, const Eigen::Vector3d& point) const;

    struct Hit {
        SurfacePoint at;
        Eigen::Vector3d position;
        double way;  ///< ≥ 0, in lengths of the direction
    };
    /// Where the ray from `origin` along `direction` (finite, not 0) first meets the surface, from either side.
    std::optional<Hit> hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

private:
    struct Ray;

    int build(int first, int last, const Positions& centres);
    int split(int first, int last, const Positions& centres);
    void visit_nearest(int number, const Eigen::Vector3d& point, double& least, Nearest& best) const;
    void visit_ray(int number, const Ray& ray, std::optional<Hit>& best) const;
    void consider(int face, const Eigen::Vector3d& point, double& least, Nearest& best) const;
    void consider(int face, const Ray& ray, std::optional<Hit>& best) const;

    bool is_far(const Eigen::Vector3d& point) const;
    Eigen::Vector3d drawn_near(const Eigen::Vector3d& point) const;

    const Surface& m_surface;
    std::vector<BoxNode> m_nodes;
    std::vector<int> m_faces;  // by leaves
    Eigen::Vector3d m_centre;  // of the surface's box
    double m_afar = 0;         // from there
};

}  // namespace chebnet
