#include "surface/smoothed_surface.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <random>

#include "constants.h"
#include "drape/drape.h"
#include "sample_nets.h"
#include "sample_surfaces.h"

using namespace chebnet;

namespace {

double mean_error_of_radius(const Surface& surface) {
    return (surface.positions().colwise().norm().array() - 1).abs().mean();
}

/// With noise of so many of its edges, upright, root mean square.
std::shared_ptr<const Guide> dish_with_noise(double edges) {
    constexpr int n = 40;
    Mesh mesh = samples::graph(n + 1, 1, [](double x, double y) { return 0.3 * (x * x + y * y); });
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-std::sqrt(3), std::sqrt(3));
    for (double& z : mesh.positions.row(2)) z += edges * 2 / n * noise(random);
    return std::make_shared<const Guide>(Surface(mesh));
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

TEST_CASE("A scan is rough by its noise, a surface of few triangles, of folds or of bumps is not") {
    CHECK(is_rough(dish_with_noise(0.2)->surface()));
    CHECK(is_rough(Surface(samples::rough_sphere(24, 0.03))));
    CHECK_FALSE(is_rough(dish_with_noise(0.01)->surface()));
    CHECK_FALSE(is_rough(Surface(samples::sphere(3))));
    CHECK_FALSE(is_rough(Surface(samples::plane(6, 1))));
    const auto folds = [](double x, double y) { return 0.1 * std::abs(std::fmod(4 * x + 8, 1) - 0.5) + 0 * y; };
    CHECK_FALSE(is_rough(Surface(samples::graph(33, 1, folds))));
    const auto bumps = [](double x, double y) { return 0.15 * std::sin(9 * x) * std::sin(9 * y); };
    CHECK_FALSE(is_rough(Surface(samples::graph(41, 1, bumps))));
    CHECK_FALSE(is_rough(Surface(samples::graph(17, 1, bumps))));
}

TEST_CASE("A net laid on a noisy scan covers it, as it lies on what the noise leaves of it") {
    const std::shared_ptr<const Guide> smooth = dish_with_noise(0), rough = dish_with_noise(0.3);
    CHECK(without_roughness(smooth, 0.05) == smooth);
    const auto few = std::make_shared<const Guide>(Surface(samples::torus(8, 6, 3, 1)));
    CHECK(without_roughness(few, 0.3) == few);
    DrapeOptions options = suggested_drape(rough->surface(), rough->tree(), 2000);
    const auto lies = [&](const std::shared_ptr<const Guide>& on) {
        const Drape laid = drape(on->surface(), on->tree(), options);
        return measure_drape(rough->surface(), rough->tree(), laid.net, options.length);
    };
    const DrapeReport calm = lies(without_roughness(rough, options.length));
    CHECK(calm.coverage > lies(rough).coverage + 0.02);
    CHECK(calm.coverage > 0.97);
    CHECK(calm.mean_distance < 0.3 * calm.length);
    CHECK(calm.mean_distance > 0.02 * calm.length);
}
