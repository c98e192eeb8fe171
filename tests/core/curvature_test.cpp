#include "surface/curvature.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "constants.h"
#include "drape/drape.h"
#include "drape/surface_report.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "surface/smoothed_surface.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

double saddle(double x, double y) { return x * y; }

/// Without its tip.
Mesh cone(double slope) {
    return samples::quads(40, 10, true, false, [&](int i, int j) {
        const double u = 2 * samples::k_pi * i / 40, r = 0.2 + 0.1 * j;
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), -slope * r);
    });
}

Mesh hyperboloid(double height) {
    return samples::quads(60, 40, true, false, [&](int i, int j) {
        const double u = 2 * samples::k_pi * i / 60, z = height * (j / 20. - 1), r = std::sqrt(1 + z * z);
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), z);
    });
}

/// Three valleys, beyond what the directions of a net can turn.
Mesh monkey_saddle() {
    return samples::graph(41, 1, [](double x, double y) { return 0.6 * (x * x * x - 3 * x * y * y); });
}

/// Side by side and up and down, so that their curvature of 15 pi of both signs together cancels along net lines.
Mesh bumps(double height) {
    return samples::graph(61, 1, [height](double x, double y) {
        return height * std::sin(3 * samples::k_pi * x) * std::sin(3 * samples::k_pi * y);
    });
}

Mesh noisy(Mesh mesh, double amount) {
    std::mt19937 random(5);
    mesh.positions = samples::shaken(mesh.positions, amount, random);
    return mesh;
}

}  // namespace

TEST_CASE("All angle defects together are 2 pi times the Euler characteristic") {
    struct Case {
        Mesh mesh;
        int characteristic, genus, loops;
    };
    const Case cases[] = {{samples::sphere(7), 2, 0, 0},
                          {samples::sphere(7, true), 1, 0, 1},
                          {samples::torus(20, 11, 3, 1), 0, 1, 0},
                          {samples::cylinder(12, 5, 1), 0, 0, 2},
                          {cone(1), 0, 0, 2},
                          {samples::graph(8, 1, saddle), 1, 0, 1}};
    for (const auto& [mesh, characteristic, genus, loops] : cases) {
        const Surface surface(noisy(mesh, 0.01));
        CHECK(angle_defects(surface).sum() == Approx(2 * samples::k_pi * characteristic).margin(1e-9));
        const SurfaceReport report = describe(surface);
        CHECK(report.genus == genus);
        CHECK(report.boundary_loops == loops);
        CHECK(report.components == 1);
    }
}

TEST_CASE("Total curvature by sign is that of the smooth surface") {
    const TotalCurvature sphere = total_curvature(inner_defects(Surface(samples::sphere(12))));
    CHECK(sphere.positive == Approx(4 * samples::k_pi));
    CHECK(sphere.negative == 0);

    const TotalCurvature torus = total_curvature(inner_defects(Surface(samples::torus(90, 60, 3, 1))));
    CHECK(torus.positive == Approx(4 * samples::k_pi).epsilon(2e-3));
    CHECK(torus.negative == Approx(-4 * samples::k_pi).epsilon(2e-3));

    for (const Mesh& mesh : {samples::cylinder(24, 9, 1), cone(1.5), samples::plane(9, 1)}) {
        const TotalCurvature flat = total_curvature(inner_defects(Surface(mesh)));
        CHECK(flat.positive < 1e-9);
        CHECK(flat.negative > -1e-9);
    }
    // Of z = x y over [−1, 1]²: −∫∫ (1 + x² + y²)^−3/2 = −4 atan(1 / √3) = −2π / 3.
    const TotalCurvature hypar = total_curvature(inner_defects(Surface(samples::graph(101, 1, saddle))));
    CHECK(hypar.positive < 1e-6);
    CHECK(hypar.negative == Approx(-2 * samples::k_pi / 3).epsilon(0.03));  // vertices of the boundary do not count
}

TEST_CASE("Smoothing keeps the sum and takes the noise away") {
    const Mesh mesh = samples::sphere(40);
    const Surface surface(noisy(mesh, 0.002));
    const TotalCurvature raw = total_curvature(inner_defects(surface));
    const TotalCurvature smooth = total_curvature(smoothed_angle_defects(surface, 0.2));
    CHECK(raw.positive > 6 * samples::k_pi);
    CHECK(smooth.positive + smooth.negative == Approx(4 * samples::k_pi).epsilon(1e-4));
    CHECK(smooth.positive == Approx(4 * samples::k_pi).epsilon(0.02));
}

TEST_CASE("Noise of a quarter of an edge leaves what is known of the shape, its border and its hole") {
    constexpr double edge = 1. / 40, noise = edge / 4;
    const Mesh hypar = samples::graph(81, 1, saddle);
    const SurfaceReport smooth = describe(Surface(hypar)), rough = describe(Surface(noisy(hypar, noise)));
    CHECK(rough.curvature.positive > 50 * samples::k_pi);
    CHECK(rough.smoothed_curvature.positive < 0.1 * samples::k_pi);
    CHECK(rough.smoothed_curvature.negative == Approx(smooth.smoothed_curvature.negative).epsilon(0.15));
    CHECK(rough.sentence == smooth.sentence);

    const Mesh plate = samples::quads(160, 20, true, false, [&](int i, int j) {
        const double u = 2 * samples::k_pi * i / 160, r = 0.5 + edge * j;
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), 0);
    });
    CHECK(describe(Surface(noisy(plate, noise / 4))).prospect != Prospect::a_seam);
}

TEST_CASE("A sentence says what one net can do") {
    const auto sentence = [](const Mesh& mesh) { return describe(Surface(mesh)).sentence; };
    CHECK(sentence(samples::graph(30, 1, saddle)) == "One uncut piece will cover it.");
    CHECK(sentence(samples::plane(5, 1)) == "One uncut piece will cover it.");
    CHECK_THAT(sentence(samples::cylinder(24, 9, 1)), Contains("seam"));
    CHECK_THAT(sentence(monkey_saddle()), Contains("More curvature than one net can take") && Contains("gaps"));
    CHECK_THAT(sentence(bumps(0.15)), Contains("may cover it") && Contains("30"));
    CHECK_THAT(sentence(hyperboloid(1.2)), Contains("on the way round") && !Contains("curvature"));
    CHECK(describe(Surface(noisy(samples::plane(40, 1), 0.002))).prospect == Prospect::one_piece);
}

TEST_CASE("What is promised of one net comes true, and is not promised where nets lock") {
    const auto dish = [](double depth) {
        return samples::graph(41, 1, [depth](double x, double y) { return depth * (x * x + y * y); });
    };
    const auto waves = samples::graph(41, 1, [](double x, double) { return 0.2 * std::sin(6 * x); });
    const auto pleats = samples::graph(61, 1, [](double x, double y) {
        return 0.16 * std::abs(std::fmod(6 * x + 0.8 * std::abs(std::fmod(4 * y + 8, 1) - 0.5) + 12, 1) - 0.5);
    });
    for (const Mesh& mesh :
         {dish(0.3), dish(0.6), waves, pleats, bumps(0.05), bumps(0.15), monkey_saddle(), hyperboloid(1.2),
          noisy(dish(0.3), 0.01), noisy(samples::plane(40, 1), 0.01), samples::sphere(12, true)}) {
        const auto guide = std::make_shared<const Guide>(Surface(mesh));
        const SurfaceReport report = describe(guide);
        CAPTURE(report.sentence);
        const DrapeOptions options = suggested_drape(guide->surface(), guide->tree(), 1000);
        const auto laid_on = without_roughness(guide, options.length);
        const Drape laid = drape(laid_on->surface(), laid_on->tree(), options);
        const double coverage = measure_drape(guide->surface(), guide->tree(), laid.net, options.length).coverage;
        if (report.sentence == "One uncut piece will cover it.") CHECK(coverage > 0.97);
        if (report.prospect == Prospect::too_curved) CHECK(coverage < 0.98);
        CHECK((coverage > 0.6));
    }
}

TEST_CASE("Round a hole a net meets itself only where curvature is missing in it") {
    // A ring, flat or a part of a cone.
    const auto ring = [](double slope) {
        return Surface(samples::quads(40, 9, true, false, [&](int i, int j) {
            const double u = 2 * samples::k_pi * i / 40, r = 0.3 + 0.1 * j;
            return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), slope * r);
        }));
    };
    CHECK(describe(ring(0)).prospect == Prospect::one_piece);
    CHECK(describe(ring(0.05)).prospect == Prospect::tight);  // with a slit
    CHECK(describe(ring(0.5)).prospect == Prospect::a_seam);

    // The hole is the shorter of both borders, wherever it lies; a bent plate is flat within.
    const auto bent_plate = [](int from, int to) {
        Mesh mesh{Positions(3, 0), {}};
        std::map<std::pair<int, int>, int> numbers;
        const auto vertex = [&](int i, int j) {
            const auto [found, is_new] = numbers.try_emplace({i, j}, static_cast<int>(numbers.size()));
            if (is_new) {
                mesh.positions.conservativeResize(3, found->second + 1);
                mesh.positions.rightCols(1) << std::sin(0.1 * (i - 10)), 0.1 * j, std::cos(0.1 * (i - 10));
            }
            return found->second;
        };
        for (int j = 0; j < 20; ++j)
            for (int i = 0; i < 20; ++i)
                if (i < from || i >= to || j < 5 || j >= 9)
                    mesh.faces.add({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        return describe(Surface(mesh)).prospect;
    };
    CHECK(bent_plate(4, 9) != Prospect::a_seam);
    CHECK(bent_plate(12, 17) != Prospect::a_seam);
}

TEST_CASE("Each of several pieces is judged by itself") {
    Mesh two = samples::graph(20, 1, [](double x, double y) { return 1 - 0.4 * (x * x + y * y); });
    const int count = static_cast<int>(two.positions.cols());
    const int faces = two.faces.size();
    two.positions.conservativeResize(3, 2 * count);
    two.positions.rightCols(count) = two.positions.leftCols(count).colwise() + Eigen::Vector3d(5, 0, 0);
    for (int f = 0; f < faces; ++f) {
        std::vector<int> face(two.faces[f].begin(), two.faces[f].end());
        for (int& v : face) v += count;
        two.faces.add(face);
    }
    const SurfaceReport report = describe(Surface(two));
    CHECK(report.components == 2);
    CHECK(report.prospect == Prospect::one_piece);
    CHECK_THAT(report.sentence, Contains("2 pieces"));
}
