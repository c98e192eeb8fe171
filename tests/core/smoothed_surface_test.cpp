#include "surface/smoothed_surface.h"

#include <catch2/catch.hpp>

#include "constants.h"
#include "sample_nets.h"
#include "sample_surfaces.h"

using namespace chebnet;

namespace {

double mean_error_of_radius(const Surface& surface) {
    return (surface.positions().colwise().norm().array() - 1).abs().mean();
}

}  // namespace

TEST_CASE("Smoothing a surface takes its noise away") {
    const Surface rough(samples::rough_sphere(24, 0.03)), calm = smoothed(rough, 0.2);
    CHECK(mean_error_of_radius(calm) < mean_error_of_radius(rough) / 3);
    CHECK(mean_tilt(rough, calm) > 10 * samples::k_degree);
    CHECK(mean_tilt(calm, smoothed(calm, 0.2)) < mean_tilt(rough, calm) / 4);
}

TEST_CASE("A smooth surface shrinks by the fourth power of how far it is smoothed") {
    const Surface sphere(samples::sphere(24));
    const double near = mean_error_of_radius(smoothed(sphere, 0.1)), far = mean_error_of_radius(smoothed(sphere, 0.2));
    CHECK(far < 0.01);
    CHECK(far / near == Approx(16).epsilon(0.2));
}

TEST_CASE("What is flat stays where it is, and so does a boundary") {
    const Surface plane(samples::plane(12, 1));
    CHECK(samples::largest_move(plane.positions(), smoothed(plane, 0.3).positions()) < 1e-12);
    CHECK(mean_tilt(plane, smoothed(plane, 0.3)) < 1e-12);

    const Surface saddle(samples::graph(12, 1, [](double x, double y) { return x * x * x - y; }));
    const Surface calm = smoothed(saddle, 0.3);
    for (int v = 0; v < saddle.vertex_count(); ++v)
        if (saddle.is_boundary(v)) CHECK(calm.positions().col(v) == saddle.positions().col(v));
}
