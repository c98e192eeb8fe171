#include "surface/smoothed_surface.h"

#include <Eigen/Geometry>
#include <cmath>

#include "surface/heat_step.h"

namespace chebnet {

Surface smoothed(const Surface& surface, double radius, const std::function<void()>& go_on) {
    const HeatStep step(surface, radius * radius, HeatBoundary::held);
    Mesh mesh{surface.positions(), {}};
    for (int k = 0; k < 3; ++k) {
        const Eigen::VectorXd values = surface.positions().row(k).transpose();
        go_on();
        const Eigen::VectorXd change = step.change(values);
        go_on();
        mesh.positions.row(k) -= step.change(change).transpose();
    }
    for (const auto& triangle : surface.triangles().colwise()) mesh.faces.add({triangle[0], triangle[1], triangle[2]});
    return Surface(mesh);
}

double mean_tilt(const Surface& surface, const Surface& other) {
    double sum = 0;
    for (int f = 0; f < surface.face_count(); ++f) {
        const Eigen::Vector3d a = surface.face_normals().col(f), b = other.face_normals().col(f);
        sum += surface.areas()[f] * std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return surface.area() > 0 ? sum / surface.area() : 0;
}

}  // namespace chebnet
