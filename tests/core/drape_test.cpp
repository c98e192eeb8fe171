#include "drape/drape.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "constants.h"
#include "drape/bridged_drape.h"
#include "drape/opened_corners.h"
#include "drape/proposals.h"
#include "drape/surface_report.h"
#include "edit/editor.h"
#include "mesh_files.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "surface/gallery.h"
#include "surface/height.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

struct Draped {
    Drape drape;
    DrapeReport report;
};

Draped draped(const Mesh& mesh, const DrapeOptions& options) {
    const Surface surface(mesh);
    const SurfaceTree tree(surface);
    Drape result = drape(surface, tree, options);
    const DrapeReport report = measure_drape(surface, tree, result.net);
    return {std::move(result), report};
}

std::map<std::pair<int, int>, Eigen::Vector3d> positions_by_place(const Drape& drape) {
    std::map<std::pair<int, int>, Eigen::Vector3d> positions;
    for (int v = 0; v < drape.net.vertex_count(); ++v)
        positions[{drape.places(0, v), drape.places(1, v)}] = drape.net.rest_positions().col(v);
    return positions;
}

/// The angle ω between the families of a Chebyshev net on the unit sphere whose arms are great circles at right angles,
/// at the distances u and v along them: ω_uv = −sin ω with ω = π/2 on the arms. It depends on z = u v alone, by
/// z ω'' + ω' = −sin ω, which is integrated here from its series at 0.
double angle_on_sphere(double z) {
    double at = 1e-4, angle = samples::k_pi / 2 - at, slope = -1;
    const int steps = 20000;
    const double h = (z - at) / steps;
    for (int k = 0; k < steps; ++k) {  // midpoint rule
        const double half_angle = angle + h / 2 * slope, half_slope = slope + h / 2 * (-std::sin(angle) - slope) / at;
        angle += h * half_slope;
        slope += h * (-std::sin(half_angle) - half_slope) / (at + h / 2);
        at += h;
    }
    return angle;
}

/// By how much angles on the diagonal of a net on the unit hemisphere are off those, up to an arm's length of `reach`.
/// Between its edges a cell has the angle of its middle, but for terms of second order: ω_u is at right angles to x_u.
double error_of_angles(const Drape& drape, double length, double reach) {
    const auto at = positions_by_place(drape);
    const double arc = 2 * std::asin(length / 2);
    double largest = 0;
    for (int k = 0; (k + 1) * arc <= reach; ++k) {
        const Eigen::Vector3d x = at.at({k, k}), a = at.at({k + 1, k}) - x, b = at.at({k, k + 1}) - x;
        const double u = (k + 0.5) * arc;
        largest = std::max(largest, std::abs(std::acos(a.dot(b) / (length * length)) - angle_on_sphere(u * u)));
    }
    return largest;
}

}  // namespace

TEST_CASE("A plane is draped by an exact square grid, its border included") {
    DrapeOptions options;
    options.length = 0.1;
    options.seed = {0.013, -0.027, 0};
    options.direction = {3, 1, 0};
    const auto [drape, report] = draped(samples::plane(7, 1), options);
    const Eigen::Vector3d u = options.direction.normalized(), v(-u.y(), u.x(), 0);
    for (const auto& [place, position] : positions_by_place(drape))
        CHECK((position - (options.seed + 0.1 * (place.first * u + place.second * v))).norm() < 1e-9);
    CHECK(report.coverage == Approx(1));
    CHECK(report.largest_distance < 1e-9);
    CHECK(report.max_deviation < samples::k_exact);
    CHECK(report.smallest_angle == Approx(samples::k_pi / 2));
    CHECK(drape.locked == 0);
    CHECK(drape.met == 0);
}

TEST_CASE("Inside a plane no vertex stands beyond its border, and the reach is kept") {
    DrapeOptions options;
    options.length = 0.1;
    options.direction = {1, 0.2, 0};
    options.border = DrapeOptions::Border::inside;
    const auto inside = draped(samples::plane(7, 1), options);
    CHECK(inside.drape.net.rest_positions().cwiseAbs().maxCoeff() < 1 + 1e-9);
    CHECK(inside.report.coverage > 0.9);
    options.reach = 3;
    const auto near = draped(samples::plane(7, 1), options);
    CHECK(near.drape.net.face_count() == 36);
    CHECK(near.drape.places.cwiseAbs().maxCoeff() == 3);
}

TEST_CASE("Rods are cut where the surface ends, and all edges that are left whole have one length") {
    DrapeOptions options;
    options.length = 0.1;
    options.seed = {0.013, -0.027, 0};
    options.direction = {3, 1, 0};
    options.border = DrapeOptions::Border::cut;
    const auto [drape, report] = draped(samples::plane(7, 1), options);
    const Net& net = drape.net;
    const Positions& x = net.rest_positions();
    int on_border = 0;
    for (int v = 0; v < net.vertex_count(); ++v) on_border += std::abs(x.col(v).cwiseAbs().maxCoeff() - 1) < 1e-12;
    CHECK(on_border == drape.cut_ends);
    CHECK(drape.cut_ends > 60);
    CHECK(x.cwiseAbs().maxCoeff() < 1 + 0.05 * options.length);
    CHECK(report.coverage == Approx(1));
    CHECK(report.length == Approx(options.length).epsilon(1e-12));
    CHECK(report.max_deviation == 0);
    CHECK(report.smallest_angle == Approx(samples::k_pi / 2));
    // Two families of lines at this distance over a square of 2 by 2.
    CHECK(report.rod_length == Approx(2 * 4 / options.length).epsilon(0.02));
    CHECK(net.rest_lengths().minCoeff() > 0.02 * options.length);
    int whole = 0;
    for (int e = 0; e < net.edge_count(); ++e) whole += std::abs(net.rest_lengths()[e] - options.length) < 1e-12;
    CHECK(whole > 700);
}

TEST_CASE("A net that was cut keeps its lengths and its limit while it is edited") {
    DrapeOptions options;
    options.length = 0.25;
    options.seed = {0, 0, 1};
    options.border = DrapeOptions::Border::cut;
    const auto [drape, report] = draped(samples::sphere(40, true), options);
    CHECK(report.smallest_angle >= options.smallest_angle - 1e-9);
    const Positions& x = drape.net.rest_positions();
    for (int v = 0; v < drape.net.vertex_count(); ++v) CHECK(x(2, v) > -0.05 * options.length);

    int top = 0, first = 0, last = 0;
    x.row(2).maxCoeff(&top);
    x.row(0).minCoeff(&first);
    x.row(0).maxCoeff(&last);
    Editor editor(drape.net);
    editor.set_method("equilibrium");
    editor.set_handles({{first, x.col(first)}, {last, x.col(last)}, {top, x.col(top)}});
    CHECK(editor.solve({}).status == Status::converged);
    CHECK((editor.positions() - x).cwiseAbs().maxCoeff() < 1e-9);  // no corner of what was cut had to be opened
    editor.set_handles({{first, x.col(first)}, {last, x.col(last)}, {top, x.col(top) - Eigen::Vector3d(0, 0, 0.2)}});
    editor.solve({});
    CHECK(max_deviation(drape.net, editor.positions()) < 1e-9);
}

TEST_CASE("The families keep their angle in a plane") {
    DrapeOptions options;
    options.length = 0.1;
    options.angle = samples::k_pi / 3;
    const auto [drape, report] = draped(samples::plane(5, 1), options);
    CHECK(report.smallest_angle == Approx(samples::k_pi / 3));
    CHECK(report.largest_angle == Approx(2 * samples::k_pi / 3));
    CHECK(report.coverage == Approx(1));
}

TEST_CASE("A plane is covered with every corner at the limit, on either side, and with corners sharper than usual") {
    const auto border = GENERATE(DrapeOptions::Border::beyond, DrapeOptions::Border::cut);
    const auto [limit, angle] =
        GENERATE(table<double, double>({{30, 30}, {30, 150}, {45, 45}, {45, 135}, {10, 20}, {10, 160}, {8, 8}}));
    CAPTURE(limit, angle);
    DrapeOptions options;
    options.border = border;
    options.length = 0.1;
    options.smallest_angle = limit * samples::k_pi / 180;
    options.angle = angle * samples::k_pi / 180;
    const auto [drape, report] = draped(samples::plane(5, 1), options);
    CHECK(drape.locked == 0);
    CHECK(drape.met == 0);
    CHECK(report.coverage > 0.97);
}

TEST_CASE("Half a cylinder is draped as the plane it unrolls to") {
    Mesh half = samples::quads(91, 21, false, false, [](int i, int j) {
        const double u = samples::k_pi * i / 90;
        return Eigen::Vector3d(std::cos(u), std::sin(u), j / 10. - 1);
    });
    DrapeOptions options;
    options.length = 0.08;
    options.seed = {0, 1, 0};
    options.direction = {1, 0, 0.6};
    const auto [drape, report] = draped(half, options);
    CHECK(report.coverage > 0.999);
    CHECK(report.max_deviation < samples::k_exact);
    CHECK(report.largest_distance < 0.1 * options.length);
    // Chords, not arcs, have one length: of the order of L² / 8.
    CHECK(std::abs(report.smallest_angle - samples::k_pi / 2) < 0.03);
    CHECK(std::abs(report.largest_angle - samples::k_pi / 2) < 0.03);
}

TEST_CASE("A net goes round a cylinder until it meets itself") {
    DrapeOptions options;
    options.length = 0.1;
    options.seed = {1, 0, 0};
    options.direction = {0, 1, 0};
    const auto [drape, report] = draped(samples::cylinder(120, 21, 1), options);
    CHECK(drape.met > 0);
    CHECK(report.coverage > 0.95);
    CHECK(report.max_deviation < samples::k_exact);
    const int columns = drape.places.row(0).maxCoeff() - drape.places.row(0).minCoeff();
    CHECK(columns >= 60);  // of 62.8
    CHECK(columns <= 62);
}

TEST_CASE("A net goes round a pipe and a torus wherever it begins, and its arms do not shut it in") {
    constexpr unsigned k_seed = 20261130;
    CAPTURE(k_seed);
    std::mt19937 random(k_seed);
    const auto mean_coverage = [&](const Mesh& mesh, double length) {
        const Surface surface(mesh);
        const SurfaceTree tree(surface);
        constexpr int k_nets = 10;
        double sum = 0;
        for (int k = 0; k < k_nets; ++k) {
            DrapeOptions options;
            options.length = length;
            options.seed = surface.position_at(samples::random_place(surface, random));
            options.direction = samples::random_point(1, random);
            const Drape drape = chebnet::drape(surface, tree, options);
            CHECK(max_deviation(drape.net, drape.net.rest_positions()) < samples::k_exact);
            sum += measure_drape(surface, tree, drape.net).coverage / k_nets;
        }
        return sum;
    };
    CHECK(mean_coverage(samples::cylinder(60, 41, 3), 0.15) > 0.97);
    CHECK(mean_coverage(samples::torus(60, 30, 2, 0.8), 0.15) > 0.9);
}

TEST_CASE(
    "A ramp that winds twice is covered from end to end, though its net would lie on itself if it were unrolled") {
    const Mesh ramp = samples::quads(161, 17, false, false, [](int i, int j) {
        const double turn = 4 * samples::k_pi * i / 160, r = 1 + j / 16.;
        return Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), turn / 3);
    });
    const Surface surface(ramp);
    DrapeOptions options;
    options.seed = {1.5, 0, 0};
    options.direction = {0, 1, 1};
    options.length = 0.1;
    CHECK(describe(surface).prospect == Prospect::one_piece);
    const auto [made, report] = draped(ramp, options);
    CHECK(report.coverage > 0.99);
    CHECK(report.gaps == 0);
    CHECK(report.max_deviation < 1e-20);
    // Of two vertices at one place each is on its own turn.
    std::map<std::pair<int, int>, int> at;
    int pairs = 0;
    for (int v = 0; v < made.net.vertex_count(); ++v) {
        const auto [other, is_first] = at.emplace(std::pair(made.places(0, v), made.places(1, v)), v);
        if (is_first) continue;
        ++pairs;
        const Positions& x = made.net.rest_positions();
        CHECK((x.col(v) - x.col(other->second)).norm() > 4 * options.length);
    }
    CHECK(pairs > 100);
}

TEST_CASE("On a hemisphere angles are those of the sine-Gordon equation, to second order in the length", "[large]") {
    // So fine that its triangles err by less than a tenth of what the length does.
    const Mesh mesh = samples::sphere(300, true);
    double before = 0;
    for (const double length : {0.2, 0.1}) {
        CAPTURE(length);
        DrapeOptions options;
        options.length = length;
        options.seed = {0, 0, 1};
        options.smallest_angle = 0.2;
        const auto [drape, report] = draped(mesh, options);
        CHECK(report.coverage > 0.995);
        CHECK(report.max_deviation < samples::k_exact);
        CHECK(report.largest_distance < 0.2 * length);
        const double error = error_of_angles(drape, length, 0.9);
        CHECK(error < 0.012 * length * length);
        if (before > 0) CHECK(before / error == Approx(4).epsilon(0.1));
        before = error;
    }
}

TEST_CASE("A net on a symmetric surface is symmetric") {
    DrapeOptions options;
    options.length = 0.08;
    options.seed = {0, 0, 1};
    options.smallest_angle = 0.4;
    const auto at = positions_by_place(draped(samples::sphere(40, true), options).drape);
    int missing = 0;
    for (const auto& [place, position] : at) {
        const auto turned = at.find({-place.second, place.first});
        if (turned == at.end()) {
            ++missing;
            continue;
        }
        const Eigen::Vector3d expected(-position.y(), position.x(), position.z());
        CHECK((turned->second - expected).norm() < 1e-6);
    }
    CHECK(missing == 0);
}

TEST_CASE("On a hypar the rulings are net lines of an almost exact net") {
    const Mesh mesh = samples::graph(61, 1, [](double x, double y) { return 0.5 * x * y; });
    DrapeOptions options;
    options.length = 0.07;
    const auto [drape, report] = draped(mesh, options);
    CHECK(report.coverage > 0.995);
    CHECK(report.max_deviation < samples::k_exact);
    CHECK(report.largest_distance < 0.05 * options.length);
    CHECK(drape.locked == 0);
    CHECK(report.smallest_angle > samples::k_pi / 3);
}

TEST_CASE("Where a corner would be too sharp there is a gap, not a sliver") {
    for (const double limit : {samples::k_pi / 6, samples::k_pi / 4}) {
        DrapeOptions options;
        options.length = 0.1;
        options.seed = {0, 0, 1};
        options.smallest_angle = limit;
        const auto [drape, report] = draped(samples::sphere(30), options);
        CHECK(drape.locked > 0);
        CHECK(report.smallest_angle > limit - 1e-9);
        CHECK(report.largest_angle < samples::k_pi - limit + 1e-9);
        CHECK(report.max_deviation < samples::k_exact);
        CHECK(report.coverage > 0.4);
        CHECK(report.gaps > 0);
        CHECK(Topology(drape.net).component_count() == 1);
    }
}

TEST_CASE("A surface with a notch is covered behind it too") {
    const Mesh square = samples::plane(21, 1);
    Mesh notched{square.positions, {}};
    for (int f = 0; f < square.faces.size(); ++f) {
        const Eigen::Vector3d corner = square.positions.col(square.faces[f][0]);
        if (!(corner.x() > 0.25 && std::abs(corner.y() + 0.05) < 0.3)) notched.faces.add(square.faces[f]);
    }
    notched = repair(notched, k_all_defects).mesh;
    DrapeOptions options;
    options.length = 0.09;
    options.seed = {-0.5, 0, 0};
    const auto [drape, report] = draped(notched, options);
    CHECK(report.coverage > 0.99);
    CHECK(report.max_deviation < samples::k_exact);
}

TEST_CASE("Every surface of our own takes a net from the middle, as its sentence says") {
    for (const OwnSurface& own : own_surfaces()) {
        INFO(own.name);
        const Surface surface = own.make();
        const SurfaceTree tree(surface);
        const Drape result = drape(surface, tree, suggested_drape(surface, tree, 1000));
        const DrapeReport report = measure_drape(surface, tree, result.net);
        const Prospect prospect = describe(surface).prospect;
        CHECK(report.max_deviation < samples::k_exact);
        CHECK(report.smallest_angle >= samples::k_pi / 6 - 1e-9);
        CHECK(report.coverage > (prospect == Prospect::too_curved ? 0.6 : 0.97));
        CHECK(report.mean_distance < 0.03 * result.net.mean_length());
        CHECK(result.net.face_count() > 600);
    }
    CHECK_THROWS_WITH(make_own_surface("plain"), Contains("no surface is called") && Contains("hypar"));
}

TEST_CASE("A net does not begin on the border of a hole in the middle, but beside it, and goes on around the hole") {
    const double hole = GENERATE(0.02, 0.1, 0.25);  // a fine one is passed over, a large one is gone around
    const Surface dome(samples::quads(64, 24, true, false, [&](int i, int j) {
        const double r = 10 * (hole + (1 - hole) * j / 23), angle = 2 * samples::k_pi * i / 64;
        return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), -r * r / 40);
    }));
    const SurfaceTree tree(dome);
    const DrapeOptions middle = suggested_drape(dome, tree, 600);
    CAPTURE(hole, middle.seed.transpose());
    CHECK(middle.seed.norm() < 10 * hole + 4.5 * middle.length);
    CHECK(middle.seed.head(2).norm() > 10 * hole + 0.5 * middle.length);
    CHECK(measure_drape(dome, tree, drape(dome, tree, middle).net).coverage > 0.97);
}

TEST_CASE("Shear and rods of a slanted net in a plane are those of its cells") {
    DrapeOptions options;
    options.length = 0.1;
    options.reach = 5;
    const auto report_at = [&](double degrees) {
        options.angle = degrees * samples::k_pi / 180;
        return draped(samples::plane(9, 2), options).report;
    };
    const DrapeReport upright = report_at(90), slanted = report_at(70), steep = report_at(50);
    CHECK(std::pair(upright.sheared, upright.much_sheared) == std::pair(0., 0.));
    CHECK(std::pair(slanted.sheared, slanted.much_sheared) == std::pair(1., 0.));
    CHECK(std::pair(steep.sheared, steep.much_sheared) == std::pair(1., 1.));
    CHECK(upright.rods == 2 * 11);
    CHECK(upright.rod_length == Approx(22 * 1.0));
}

TEST_CASE("Gaps are counted: a notch from the border, a hole, and none where the whole is covered") {
    const Mesh square = samples::plane(21, 1);
    DrapeOptions options;
    options.length = 0.1;
    options.seed = {-0.55, 0, 0};
    CHECK(draped(square, options).report.gaps == 0);
    Net whole = draped(square, options).drape.net;
    const auto without = [&](auto is_hole) {
        Mesh left{whole.rest_positions(), {}};
        for (int f = 0; f < whole.face_count(); ++f)
            if (!is_hole(Eigen::Vector3d(whole.rest_positions().col(whole.faces()[f][0]))))
                left.faces.add(whole.faces()[f]);
        left = repair(left, k_all_defects).mesh;
        const Surface surface(square);
        return measure_drape(surface, SurfaceTree(surface), Net(left.positions, left.faces)).gaps;
    };
    CHECK(without([](const auto& x) { return x.head(2).norm() < 0.3; }) == 1);
    CHECK(without([](const auto& x) { return x.x() > 0.2 && std::abs(x.y()) < 0.3; }) == 1);
    CHECK(without([](const auto& x) { return std::abs(x.x()) > 0.2 && std::abs(x.y()) < 0.3; }) == 2);
    CHECK(draped(samples::sphere(16), options).report.gaps >= 1);
}

TEST_CASE("Of proposals that cover alike the one that comes nearest is first, by the distance that is measured",
          "[large]") {
    const DrapeProposal near{{}, 0.98, 0.1, 0.2, 0.01}, far{{}, 0.98, 0.1, 0.2, 0.05};
    CHECK(near.worth() > far.worth());
    const Surface shell = make_own_surface("shell");
    const SurfaceTree tree(shell);
    DrapeOptions options = suggested_drape(shell, tree, 900);
    options.border = DrapeOptions::Border::inside;
    double sheared[2];
    for (const auto arms : {DrapeOptions::Arms::geodesic, DrapeOptions::Arms::least_shear}) {
        options.arms = arms;
        const DrapeProposal best = propose_drapes(shell, tree, options).front();
        const Net net = drape(shell, tree, best.options).net;
        CHECK(best.mean_distance == Approx(measure_drape(shell, tree, net).mean_distance / options.length));
        CHECK(best.much_sheared == part_sheared(net, k_much_shear));
        sheared[static_cast<int>(arms)] = part_sheared(net, k_shear);
    }
    CHECK(sheared[1] < sheared[0]);
}

TEST_CASE("Proposals are ranked, and the best is as good as beginning in the middle") {
    for (const OwnSurface& own : own_surfaces()) {
        INFO(own.name);
        const Surface surface = own.make();
        const SurfaceTree tree(surface);
        const DrapeOptions middle = suggested_drape(surface, tree, 400);
        const std::vector<DrapeProposal> proposals = propose_drapes(surface, tree, middle);
        REQUIRE(proposals.size() > 3);
        CHECK(std::is_sorted(proposals.begin(), proposals.end(),
                             [](const DrapeProposal& a, const DrapeProposal& b) { return a.worth() > b.worth(); }));
        const auto coverage = [&](const DrapeOptions& options) {
            return measure_drape(surface, tree, drape(surface, tree, options).net).coverage;
        };
        CHECK(proposals.front().options.length == middle.length);
        CHECK(coverage(proposals.front().options) > coverage(middle) - 0.02);
    }
    const Surface plane(samples::plane(9, 1));
    DrapeOptions upright;
    upright.angle = 0.1;
    CHECK_THROWS_WITH(propose_drapes(plane, SurfaceTree(plane), upright), Contains("angle at the seed"));
}

TEST_CASE("A round surface that is rough up to its border has proposals", "[large]") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int trial = 0; trial < 4; ++trial) {
        // A dish of 35 quads across.
        std::uniform_real_distribution<double> amount(-0.008, 0.008);
        const Surface dish(samples::quads(36, 36, false, false, [&](int i, int j) {
            // The square onto the disc, border to border.
            const double x = i / 17.5 - 1, y = j / 17.5 - 1;
            const Eigen::Vector2d p(x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2));
            return Eigen::Vector3d(p.x() + amount(random), p.y() + amount(random),
                                   0.6 * (1 - p.squaredNorm()) + amount(random));
        }));
        const SurfaceTree tree(dish);
        for (const int cells : {200, 600}) {
            const DrapeOptions options = suggested_drape(dish, tree, cells);
            const std::vector<DrapeProposal> proposals = propose_drapes(dish, tree, options);
            REQUIRE(!proposals.empty());
            const Net net = drape(dish, tree, proposals.front().options).net;
            const DrapeReport report = measure_drape(dish, tree, net);
            INFO("trial " << trial << " cells " << cells);
            CHECK(report.coverage > 0.95);
            CHECK(report.mean_distance < 0.05 * report.length);
        }
    }
}

TEST_CASE("A surface too narrow for a cell within its border has a proposal none the less") {
    const Surface ribbon(samples::quads(200, 5, false, false, [](int i, int j) {
        const double angle = 9 * std::numbers::pi * i / 199, radius = 1 + 0.015 * j;
        return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 1.5 * i / 199);
    }));
    const SurfaceTree tree(ribbon);
    DrapeOptions options;
    options.length = 0.08;
    const std::vector<DrapeProposal> proposals = propose_drapes(ribbon, tree, options);
    REQUIRE(!proposals.empty());
    CHECK(drape(ribbon, tree, proposals.front().options).net.face_count() > 0);
    options.border = DrapeOptions::Border::inside;
    CHECK_THROWS_WITH(propose_drapes(ribbon, tree, options), Contains("no cell of this edge length fits"));
}

TEST_CASE("Of nets that cover all and are nowhere much sheared the one that is sheared least is proposed") {
    const Surface hypar = make_own_surface("hypar");
    const SurfaceTree tree(hypar);
    for (const int cells : {500, 4000}) {
        const DrapeOptions middle = suggested_drape(hypar, tree, cells);
        const DrapeProposal best = propose_drapes(hypar, tree, middle).front();
        CHECK(best.covered == Approx(1));
        CHECK(best.much_sheared == 0);
        CHECK(best.shear < 1.05 * rms_shear(drape(hypar, tree, middle).net));  // the middle is where it is flattest
    }
}

TEST_CASE("Where no cell is within the border, proposals are made with cells that it cuts, too") {
    const Surface strip(
        samples::quads(2, 2, false, false, [](int i, int j) { return Eigen::Vector3d(10 * i, j / 2., 0); }));
    const SurfaceTree tree(strip);
    DrapeOptions options;
    options.length = 0.7;
    options.border = DrapeOptions::Border::cut;
    const DrapeProposal best = propose_drapes(strip, tree, options).front();
    CHECK(best.covered > 0.9);
    const Net net = drape(strip, tree, best.options).net;
    CHECK(measure_drape(strip, tree, net).coverage > 0.9);
}

TEST_CASE("The compasses find this side of a sheet with two, however thin it is") {
    const Mesh sheet = samples::quads(60, 21, true, false, [](int i, int j) {
        const double u = 2 * samples::k_pi * i / 60;
        return Eigen::Vector3d(std::cos(u), 0.1 * j - 1, 0.01 * std::sin(u));
    });
    DrapeOptions options;
    options.seed = {0, 0, 0.01};
    options.length = 0.15;
    const auto [net, report] = draped(sheet, options);
    CHECK(report.coverage > 0.45);
    CHECK(report.max_deviation < samples::k_exact);
}

TEST_CASE("Where a net begins on a flat face beside a crease its direction is not upright") {
    // Nearest to its centre of mass is a point of the face x = 1, towards the edge where it meets the face y = 0.
    const Surface corner(samples::quads(
        3, 2, false, false, [](int i, int j) { return Eigen::Vector3d(i == 0 ? 0.1 : 1, i < 2 ? 0 : 1, j); }));
    const SurfaceTree tree(corner);
    CHECK(drape(corner, tree, suggested_drape(corner, tree, 50)).net.face_count() > 0);
}

TEST_CASE("What cannot be draped is refused with a sentence") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refusal = [](auto change) {
        DrapeOptions options;
        options.length = 0.1;
        change(options);
        return samples::refusal_of([&] { draped(samples::plane(5, 1), options); });
    };
    CHECK_THAT(refusal([](DrapeOptions& o) { o.length = 0; }), Contains("bad_option") && Contains("edge length"));
    CHECK_THAT(refusal([](DrapeOptions& o) { o.length = 5; }), Contains("bad_option") && Contains("edge length"));
    CHECK_THAT(refusal([](DrapeOptions& o) { o.length = 1e-4; }), Contains("too_large") && Contains("2000000"));
    CHECK_THAT(refusal([&](DrapeOptions& o) { o.seed.x() = nan; }), Contains("non_finite"));
    CHECK_THAT(refusal([](DrapeOptions& o) {
                   o.direction = {0, 0, 1};
               }),
               Contains("bad_option") && Contains("upright"));
    CHECK_THAT(refusal([](DrapeOptions& o) { o.smallest_angle = 2; }), Contains("bad_option") && Contains("limit"));
    CHECK_THAT(refusal([](DrapeOptions& o) { o.angle = 0.1; }), Contains("bad_option") && Contains("angle"));
    CHECK_THAT(refusal([](DrapeOptions& o) { o.reach = 0; }), Contains("bad_option") && Contains("reach"));
    CHECK_THAT(refusal([](DrapeOptions& o) {
                   o.length = 1.5;
                   o.border = DrapeOptions::Border::inside;
               }),
               Contains("bad_option") && Contains("no cell"));
}

TEST_CASE("Where a net locks it may leave the surface, as far as is asked for") {
    const auto guide = std::make_shared<const Guide>(make_own_surface("pebble"));
    DrapeOptions options = suggested_drape(guide->surface(), guide->tree(), 250);
    const Drape locked = drape(guide->surface(), guide->tree(), options);
    REQUIRE(locked.locked > 0);
    const double before = measure_drape(guide->surface(), guide->tree(), locked.net).coverage;
    double covered = 0;
    for (const double height : {0.25, 1.0}) {
        CAPTURE(height);
        const Drape bridged = bridged_drape(guide, options, height);
        const DrapeReport report = measure_drape(guide->surface(), guide->tree(), bridged.net);
        CHECK(report.coverage >= before);
        CHECK(report.max_deviation < 1e-9);
        CHECK(report.smallest_angle >= options.smallest_angle);
        CHECK(heights_over(*guide, bridged.net.rest_positions()).cwiseAbs().maxCoeff() <= height * options.length);
        CHECK(bridged.places.cols() == bridged.net.vertex_count());
        covered = report.coverage;
    }
    CHECK(covered > before);
    CHECK_THROWS_WITH(bridged_drape(guide, options, 11), Contains("10 edge lengths"));
}

TEST_CASE("A net that leaves the surface where it locks does not lie on itself") {
    std::vector<Surface> surfaces;
    surfaces.emplace_back(samples::sphere(16));
    surfaces.emplace_back(samples::torus(60, 30, 2, 0.9));
    surfaces.emplace_back(samples::rough_sphere(10, 0.05));
    int left = 0;
    for (Surface& surface : surfaces) {
        const auto guide = std::make_shared<const Guide>(std::move(surface));
        for (const int cells : {400, 800}) {
            const DrapeOptions options = suggested_drape(guide->surface(), guide->tree(), cells);
            const Drape bridged = bridged_drape(guide, options, 2);
            left += heights_over(*guide, bridged.net.rest_positions()).cwiseAbs().maxCoeff() > 0.01 * options.length;
            const Positions& x = bridged.net.rest_positions();
            int close = 0;
            for (int a = 0; a < x.cols(); ++a)
                for (int b = 0; b < a; ++b)
                    close += (x.col(a) - x.col(b)).norm() < 0.7 * options.length &&
                             (bridged.places.col(a) - bridged.places.col(b)).cwiseAbs().sum() > 2;
            CHECK(close == 0);
        }
    }
    CHECK(left > 3);
}

TEST_CASE("Sharp corners are opened on the surface, and nothing else is moved") {
    const auto guide = std::make_shared<const Guide>(Surface(samples::plane(9, 1)));
    const auto slanted = [](double angle) {
        const Mesh mesh = samples::quads(9, 9, false, false, [&](int i, int j) {
            return Eigen::Vector3d(0.05 * (i + j * std::cos(angle)), 0.05 * j * std::sin(angle), 0);
        });
        return Net(mesh.positions, mesh.faces, RestLengths::equal);
    };
    const Net open = slanted(samples::k_pi / 4), sharp = slanted(samples::k_pi / 9);
    const auto as_it_was = with_opened_corners(open, *guide, samples::k_pi / 6);
    REQUIRE(as_it_was);
    CHECK((*as_it_was - open.rest_positions()).cwiseAbs().maxCoeff() < 1e-12);
    const auto opened = with_opened_corners(sharp, *guide, samples::k_pi / 6);
    REQUIRE(opened);
    CHECK(max_deviation(sharp, *opened) < samples::k_exact);
    CHECK(corner_angle_range(sharp, *opened).smallest >= samples::k_pi / 6);
    CHECK(corner_angle_range(sharp, *opened).smallest < samples::k_pi / 5);
    CHECK(heights_over(*guide, *opened).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("Corners are opened far from the origin, and of very small nets, as of others") {
    const Mesh net = samples::quads(9, 9, false, false,
                                    [](int i, int j) { return Eigen::Vector3d(0.05 * (i + 0.94 * j), 0.017 * j, 0); });
    const auto is_opened = [&](double unit, double far) {
        const auto moved = [=](Mesh mesh) {
            mesh.positions = unit * mesh.positions;
            mesh.positions.row(1).array() += far;
            return mesh;
        };
        const Guide plane(Surface(moved(samples::plane(9, 1))));
        const Net sharp(moved(net).positions, net.faces, RestLengths::equal);
        const auto opened = with_opened_corners(sharp, plane, samples::k_pi / 6);
        return opened && corner_angle_range(sharp, *opened).smallest >= samples::k_pi / 6;
    };
    for (const double far : {0.0, 1e3, 1e5, 1e6}) CHECK(is_opened(1, far));
    for (const double unit : {1e-25, 1e-16, 1e16, 1e25}) CHECK(is_opened(unit, 0));
}

TEST_CASE("A surface far from the origin is covered as near to it") {
    Mesh mesh = samples::sphere(12, true);
    const auto coverage = [&] {
        const Surface surface(mesh);
        const SurfaceTree tree(surface);
        const DrapeReport report =
            measure_drape(surface, tree, drape(surface, tree, suggested_drape(surface, tree, 400)).net);
        CHECK(report.max_deviation < 1e-9);
        return report.coverage;
    };
    const double near = coverage();
    mesh.positions.row(0).array() += 1e7;
    CHECK(coverage() == Approx(near).epsilon(0.01));
}

TEST_CASE("Where corners are opened a net keeps to the border of the surface as where it was laid") {
    const auto cap = std::make_shared<const Guide>(Surface(samples::quads(64, 40, true, false, [](int i, int j) {
        const double around = samples::k_pi / 32 * i, down = 0.03 + 0.057 * j;
        return Eigen::Vector3d(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down));
    })));
    const auto overhang = [&](const Eigen::Vector3d& position) {
        return height_of(cap->surface(), cap->tree(), position, 0).overhang;
    };
    int opened = 0;
    for (const int cells : {400, 700, 1000, 1500}) {
        DrapeOptions options = suggested_drape(cap->surface(), cap->tree(), cells);
        const double exact = 2e-9 * options.length;
        options.border = DrapeOptions::Border::inside;
        const Net inside = bridged_drape(cap, options, 0.5).net;
        opened += inside.face_count() != drape(cap->surface(), cap->tree(), options).net.face_count() ? 1 : 0;
        for (const auto& position : inside.rest_positions().colwise()) CHECK(overhang(position) < exact);
        options.border = DrapeOptions::Border::beyond;
        const Net beyond = bridged_drape(cap, options, 0.5).net;
        for (int f = 0; f < beyond.face_count(); ++f) {
            const std::span<const int> face = beyond.faces()[f];
            CHECK(std::any_of(face.begin(), face.end(),
                              [&](int v) { return overhang(beyond.rest_positions().col(v)) < exact; }));
        }
    }
    CHECK(opened > 0);
}

TEST_CASE("A narrow strip that is bare for the most part has an open border, one that is covered has none") {
    // Every place of it is beside its border.
    const Mesh strip = samples::quads(
        60, 4, false, false, [](int i, int j) { return Eigen::Vector3d(i / 10., j / 10., 0.02 * std::sin(i)); });
    DrapeOptions options;
    options.seed = {3, 0.2, 0};
    options.length = 0.19;
    CHECK(draped(strip, options).report.gaps == 0);
    CHECK(draped(strip, options).report.open_border == 0);
    options.reach = 5;
    const DrapeReport report = draped(strip, options).report;
    CHECK(report.coverage < 0.5);
    CHECK(report.gaps == 2);
    CHECK(report.open_border >= 4 * options.length);
}

TEST_CASE("Slits and gaps are told by the border that is open inside, though a slit counts as covered") {
    // Two pieces of 5 × 10 cells of length 1, side by side on a square of 10 × 10, or one cell apart.
    const double apart = GENERATE(0.0, 1.0);
    CAPTURE(apart);
    Mesh pieces{Positions(3, 2 * 6 * 11), {}};
    for (int piece = 0; piece < 2; ++piece)
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 11; ++j) {
                const auto vertex = [&](int a, int b) { return (piece * 6 + a) * 11 + b; };
                pieces.positions.col(vertex(i, j)) = Eigen::Vector3d(5 * piece - 5 + i + piece * apart, j - 5, 0);
                if (i < 5 && j < 10)
                    pieces.faces.add({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
            }
    const Surface surface(samples::plane(11, 5));
    const DrapeReport report =
        measure_drape(surface, SurfaceTree(surface), Net(pieces.positions, pieces.faces, RestLengths::equal));
    CHECK(report.coverage == Approx(1));
    // Ten edges on each side, of which two at each end are beside the border.
    CHECK(report.open_border == Approx(2 * 6));
}

TEST_CASE("A net with a quad that lies folded on itself is measured like others") {
    Positions x(3, 6);
    x << 0, 1, 0, 0, 1, 0,  //
        0, 0, 0, 1, 1, 2,   //
        0, 0, 0, 0, 0, 0;
    // Of the first face two opposite corners are in one place, of the others all but one.
    x.col(2) = x.col(0);
    Faces faces;
    faces.add({0, 1, 2, 3});
    faces.add({1, 4, 3, 2});
    x.conservativeResize(3, 5);
    const Net net(x, faces, RestLengths::own);
    const Surface plane(samples::plane(4, 4));
    const DrapeReport report = measure_drape(plane, SurfaceTree(plane), net);
    CHECK(report.coverage > 0);
    CHECK(sampled_coverage(plane, net) > 0);

    // What has no area at all covers nothing.
    Positions flat = Positions::Zero(3, 4);
    flat(0, 1) = flat(0, 3) = 1;
    Faces one;
    one.add({0, 1, 2, 3});
    const Net line(flat, one);
    CHECK(measure_drape(plane, SurfaceTree(plane), line).coverage == 0);
}

TEST_CASE("A cut net most of whose edges are shorter is measured by the length it was laid with") {
    const Surface hemisphere = make_own_surface("hemisphere");
    const SurfaceTree tree(hemisphere);
    DrapeOptions options = suggested_drape(hemisphere, tree, 8);
    options.border = DrapeOptions::Border::cut;
    const Net net = drape(hemisphere, tree, options).net;
    REQUIRE_FALSE(shared_length(net));
    const DrapeReport report = measure_drape(hemisphere, tree, net, options.length);
    CHECK(report.length == options.length);
    CHECK(report.whole_cells > 0);
    CHECK(report.smallest_angle <= report.largest_angle);
    // Longer than any edge of it, no cell is whole; and where nothing is known the net's whole cells say it.
    CHECK(measure_drape(hemisphere, tree, net, 2 * options.length).whole_cells == 0);
    const DrapeReport unsaid = measure_drape(hemisphere, tree, net);
    CHECK(unsaid.length == Approx(options.length));
    CHECK(unsaid.whole_cells == report.whole_cells);
    CHECK(unsaid.rods == report.rods);
    CHECK(unsaid.rod_length == Approx(report.rod_length));
    CHECK(part_sheared(net, 0, options.length) == 1);
}

TEST_CASE("Coverage of a surface of few triangles is guessed by samples all over them") {
    Mesh panel{Positions::Zero(3, 4), {}};
    panel.positions.row(0) << 0, 40, 40, 0;
    panel.positions.row(1) << 0, 0, 10, 10;
    panel.faces.add({0, 1, 2});
    panel.faces.add({0, 2, 3});
    const Surface surface(panel);
    const Net net = samples::patch(14, 11, 0);  // its left third
    const double exact = measure_drape(surface, SurfaceTree(surface), net).coverage;
    CHECK(exact == Approx(13.5 / 40).margin(0.01));
    CHECK(sampled_coverage(surface, net) == Approx(exact).margin(0.02));
}
