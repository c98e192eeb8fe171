#include "edit/equalize.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

/// Stretched and bent, so that lengths differ in the large.
Positions warped(Positions x) {
    const Eigen::Vector3d corner = x.rowwise().minCoeff();
    const double size = (x.rowwise().maxCoeff() - corner).norm();
    for (auto p : x.colwise()) {
        const Eigen::Vector3d q = (p - corner) / size;
        p += size *
             Eigen::Vector3d(q.x() * q.x() + 0.15 * std::sin(9 * q.y()), q.y() * q.z(), 0.1 * std::sin(7 * q.x()));
    }
    return x;
}

/// A gallery shape, warped and with every coordinate off by up to `noise` edge lengths.
Net raw_mesh(const std::string& recipe, double noise) {
    std::mt19937 random(7);
    const Net net = make_shape(recipe).net;
    return Net(samples::shaken(warped(net.rest_positions()), noise * net.mean_length(), random), net.faces());
}

Net noisy_patch() {
    std::mt19937 random(3);
    const Net patch = samples::patch(20, 15);
    return Net(samples::shaken(patch.rest_positions(), 0.2, random), patch.faces());
}

/// Waves above a patch, and somewhat beyond its border.
Surface waves_over(const Net& patch) {
    const Eigen::Vector3d low = patch.rest_positions().rowwise().minCoeff();
    const Eigen::Vector3d high = patch.rest_positions().rowwise().maxCoeff();
    const int columns = static_cast<int>(high.x() - low.x()) + 5, rows = static_cast<int>(high.y() - low.y()) + 5;
    Mesh mesh{Positions(3, columns * rows), {}};
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const double x = low.x() + i - 2, y = low.y() + j - 2, middle = (low.z() + high.z()) / 2;
            mesh.positions.col(j * columns + i) << x, y, middle + 1 + std::sin(0.4 * x) + std::cos(0.3 * y);
            const int a = j * columns + i;
            if (i + 1 < columns && j + 1 < rows) mesh.faces.add({a, a + 1, a + columns + 1, a + columns});
        }
    return Surface(mesh);
}

/// Every quad cut along a diagonal and every triangle into three quads: valences 3, 4 and 6 side by side.
Net split_triangles(const Net& quads) {
    Positions x = quads.rest_positions();
    Faces faces;
    const auto midpoint = [&](int a, int b) {
        for (Eigen::Index v = quads.vertex_count(); v < x.cols(); ++v)
            if ((x.col(v) - (x.col(a) + x.col(b)) / 2).norm() < 1e-9) return static_cast<int>(v);
        x.conservativeResize(3, x.cols() + 1);
        x.rightCols(1) = (x.col(a) + x.col(b)) / 2;
        return static_cast<int>(x.cols()) - 1;
    };
    const auto split = [&](int a, int b, int c) {
        const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
        x.conservativeResize(3, x.cols() + 1);
        const int centre = static_cast<int>(x.cols()) - 1;
        x.col(centre) = (x.col(a) + x.col(b) + x.col(c)) / 3;
        faces.add({a, ab, centre, ca});
        faces.add({b, bc, centre, ab});
        faces.add({c, ca, centre, bc});
    };
    for (int f = 0; f < quads.face_count(); ++f) {
        const std::span<const int> q = quads.faces()[f];
        split(q[0], q[1], q[2]);
        split(q[0], q[2], q[3]);
    }
    return Net(x, faces);
}

/// All ten pairs of five vertices joined, on a Möbius strip: space has no five points at one distance from each other.
Net five_neighbours() {
    Positions x(3, 5);
    x << 0, 1, 0, 0, 1,  //
        0, 0, 1, 0, 1,   //
        0, 0, 0, 1, 1;
    Faces faces;
    for (int i = 0; i < 5; ++i) faces.add({i, (i + 1) % 5, (i + 2) % 5});
    return Net(x, faces);
}

/// Measured by itself, without anything that the report says.
double largest_deviation(const Net& mesh, const Positions& x, double length) {
    double largest = 0;
    for (const auto edge : mesh.edges().colwise()) {
        const double ratio = (x.col(edge[0]) - x.col(edge[1])).norm() / length;
        largest = std::max(largest, ratio + 1 / ratio - 2);
    }
    return largest;
}

EqualizeOptions by_lengths_alone(EqualLength choice, double length = 0) {
    EqualizeOptions options;
    options.choice = choice;
    options.length = length;
    options.way = EqualizeWay::lengths;
    return options;
}

}  // namespace

TEST_CASE("What is asked of an equalised net is told by the name of a method") {
    for (const EqualizeWay way : {EqualizeWay::usual, EqualizeWay::at_rest, EqualizeWay::lengths})
        CHECK(equalize_way_named(to_string(way)) == way);
    CHECK_THROWS_WITH(equalize_way_named("li2022"),
                      "a mesh is equalised by equilibrium or by projection, not by li2022");
}

TEST_CASE("Raw meshes of many kinds become nets with edges of one length") {
    const auto [name, mesh, farthest] = GENERATE(table<std::string, Net, double>({
        {"noise", noisy_patch(), 0.3},
        {"open", raw_mesh("dome:vertices=1500", 0.2), 2},
        {"boundaries, stretched", raw_mesh("vault:vertices=1500", 0), 2},
        {"closed, genus 1", raw_mesh("torus:vertices=1500", 0.2), 2.5},
        {"closed, singular", raw_mesh("jack:vertices=1500", 0.2), 2.5},
        {"genus 5", raw_mesh("steps:vertices=1500", 0.3), 2},
        {"flat", Net(Eigen::Vector3d(1, 1, 0).asDiagonal() * noisy_patch().rest_positions(), noisy_patch().faces()), 2},
        {"valences 3, 4 and 6", split_triangles(noisy_patch()), 2},
    }));
    INFO(name);
    Equalizer equalizer(mesh, by_lengths_alone(EqualLength::fitting));
    const EqualizeReport report = equalizer.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.way == EqualizeWay::lengths);
    CHECK(report.max_deviation < k_equal_deviation);
    CHECK(largest_deviation(mesh, equalizer.positions(), report.length) < 1.1e-9);
    CHECK(Net(equalizer.positions(), mesh.faces()).is_chebyshev());
    CHECK(report.worst_edges.empty());
    CHECK(report.before.standard_deviation > 0.1);
    CHECK(report.after.longest - report.after.shortest < 2e-4);

    CHECK(report.max_move * report.length ==
          Approx(samples::largest_move(equalizer.positions(), mesh.rest_positions())));
    CHECK(report.mean_move < report.max_move);
    CHECK(report.mean_move < farthest);
}

/// Its outer edges are three times as long as the inner ones: no net near it is fair.
Net flat_ring(int around, int rows) {
    Positions x(3, around * (rows + 1));
    Faces faces;
    for (int row = 0; row <= rows; ++row)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * EIGEN_PI * k / around, radius = 1 + 2.0 * row / rows;
            x.col(around * row + k) << radius * std::cos(angle), radius * std::sin(angle), 0;
            const int next = (k + 1) % around;
            if (row < rows)
                faces.add({around * row + k, around * row + next, around * (row + 1) + next, around * (row + 1) + k});
        }
    return Net(std::move(x), std::move(faces));
}

TEST_CASE("A net with corners sharper than the limit is not called converged") {
    EqualizeOptions options;
    options.choice = GENERATE(EqualLength::mean, EqualLength::fitting);
    options.way = EqualizeWay::at_rest;
    const Net ring = flat_ring(30, 10);
    Equalizer equalizer(ring, options);
    const EqualizeReport report = equalizer.solve();
    CHECK(report.status == Status::exact);
    CHECK(largest_deviation(ring, equalizer.positions(), report.length) < 1.1e-9);
    CHECK(report.quads_beyond_limit > 0);
    CHECK(report.quads_beyond_limit == sharp_quads(ring, equalizer.positions(), 29.9 * EIGEN_PI / 180));

    options.way = EqualizeWay::lengths;
    CHECK(Equalizer(ring, options).solve().status == Status::converged);
}

TEST_CASE("Quads become a net near the surface of their mesh, fair and with no corner too sharp") {
    const auto [name, mesh] = GENERATE(table<std::string, Net>({
        {"open", raw_mesh("dome:vertices=300", 0.1)},
        {"closed, genus 1", raw_mesh("torus:vertices=300", 0.1)},
        {"closed, singular", raw_mesh("jack:vertices=300", 0.1)},
    }));
    const EqualLength choice = GENERATE(EqualLength::mean, EqualLength::fitting);
    INFO(name);
    EqualizeOptions options;
    options.choice = choice;
    Equalizer near(mesh, options), alone(mesh, by_lengths_alone(choice));
    const EqualizeReport report = near.solve(), other = alone.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.way == EqualizeWay::at_rest);
    CHECK(largest_deviation(mesh, near.positions(), report.length) < 1.1e-9);
    CHECK(report.smallest_angle > 29.99 * EIGEN_PI / 180);
    REQUIRE((report.distance && other.distance));
    CHECK(report.distance->mean < 0.3);
    CHECK(report.distance->mean < other.distance->mean);

    if (mesh.edge_count() > 2 * mesh.face_count()) return;  // the net may reach beyond a border
    const Guide surface(Surface({mesh.rest_positions(), mesh.faces()}));
    double sum = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) sum += surface.tree().nearest(near.positions().col(v)).distance;
    CHECK(sum / mesh.vertex_count() < 2 * report.distance->mean * report.length);
}

TEST_CASE("With a guide the net comes near that and not near its own surface, of the size and where it is") {
    const Net mesh = noisy_patch();
    const auto guide = std::make_shared<const Guide>(waves_over(mesh));
    EqualizeOptions options;
    options.choice = GENERATE(EqualLength::mean, EqualLength::fitting, EqualLength::given);
    options.length = 1.05 * mesh.mean_length();
    Equalizer own(mesh, options);
    own.solve();
    options.guide = guide;
    if (options.choice != EqualLength::fitting) options.handles = GENERATE(std::vector<int>{}, std::vector<int>{150});
    Equalizer guided(mesh, options);
    const EqualizeReport report = guided.solve();
    const auto distance = [&](const Equalizer& equalizer) {
        return distance_to(*guide, mesh, equalizer.positions()).mean / report.length;
    };
    CHECK(report.status == Status::converged);
    CHECK(report.way == EqualizeWay::at_rest);
    CHECK(largest_deviation(mesh, guided.positions(), report.length) < 1.1e-9);
    CHECK(report.smallest_angle > 29.99 * EIGEN_PI / 180);
    if (options.choice == EqualLength::given) CHECK(report.length == options.length);
    for (const int v : options.handles) CHECK(guided.positions().col(v) == mesh.rest_positions().col(v));
    CHECK(distance(guided) < 0.1);
    CHECK(distance(guided) < distance(own) / 5);
    REQUIRE(report.distance);
    CHECK(report.distance->mean == Approx(distance(guided)));
    CHECK(!guided.surface_positions());
}

TEST_CASE("A net that is exact already still comes near a guide, which alone makes large ones do so") {
    const Net exact = samples::patch(15, 12);
    EqualizeOptions options;
    options.guide = std::make_shared<const Guide>(waves_over(exact));
    Equalizer guided(exact, options);
    const EqualizeReport report = guided.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.iterations > 0);
    REQUIRE(report.distance);
    CHECK(report.distance->mean < distance_to(*options.guide, exact, exact.rest_positions()).mean / 5);

    Equalizer large(samples::patch(120, 101), options);
    CHECK(large.solve({1, 0}).way == EqualizeWay::at_rest);
    options.way = EqualizeWay::lengths;
    CHECK(Equalizer(exact, options).positions() == exact.rest_positions());
}

TEST_CASE("The limit of corners is the user's") {
    const Net mesh = raw_mesh("torus:vertices=600", 0.1);
    EqualizeOptions options;
    options.shear_limit = 45 * EIGEN_PI / 180;
    const EqualizeReport report = Equalizer(mesh, options).solve();
    CHECK(report.status == Status::converged);
    CHECK(report.smallest_angle > 44.99 * EIGEN_PI / 180);
}

/// Edges of length 1, corners of this angle.
Net rhombi(int n, double angle) {
    Positions x = samples::patch(n, n, 0).rest_positions();
    for (auto point : x.colwise()) point << point.x() + std::cos(angle) * point.y(), std::sin(angle) * point.y(), 0;
    return Net(x, samples::patch(n, n, 0).faces());
}

TEST_CASE("A net that comes with edges of one length has its corners opened, or it is said that they are sharp") {
    const Net sharp = rhombi(6, 15 * EIGEN_PI / 180);
    Equalizer opened(sharp);
    const EqualizeReport report = opened.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.way == EqualizeWay::at_rest);
    CHECK(report.quads_beyond_limit == 0);
    CHECK(largest_deviation(sharp, opened.positions(), 1) < 1.1e-9);

    EqualizeOptions options;
    options.handles = {14, 15, 20};  // the corner of 165 degrees of one quad
    Equalizer held(sharp, options);
    CHECK(held.solve().status == Status::exact);
    for (const int v : options.handles) CHECK(held.positions().col(v) == sharp.rest_positions().col(v));

    options = by_lengths_alone(EqualLength::mean);
    Equalizer alone(sharp, options);
    CHECK(alone.solve().status == Status::converged);
    CHECK(alone.positions() == sharp.rest_positions());
}

TEST_CASE("Where there is no surface to be near, lengths alone are asked for, and it is said") {
    Equalizer equalizer(five_neighbours()), alone(five_neighbours(), by_lengths_alone(EqualLength::mean));
    const EqualizeReport report = equalizer.solve();
    CHECK(report.way == EqualizeWay::lengths);
    CHECK(!report.distance);
    CHECK(report.status == alone.solve().status);
    CHECK(equalizer.positions() == alone.positions());
}

TEST_CASE("Edges get the length that is asked for, as near as they get one length") {
    const Net mesh = noisy_patch();
    for (const double length : {0.9 * mesh.mean_length(), 1.1 * mesh.mean_length()}) {
        EqualizeOptions options;
        options.choice = EqualLength::given;
        options.length = length;
        Equalizer equalizer(mesh, options);
        REQUIRE(equalizer.solve().status == Status::converged);
        const Eigen::VectorXd lengths = edge_ratios(mesh, equalizer.positions()).cwiseProduct(mesh.rest_lengths());
        CHECK(lengths.mean() == Approx(length).epsilon(1e-10));
    }
}

TEST_CASE("A flat mesh that cannot become equal in its plane leaves it") {
    // Six equal triangles fill a full turn about a vertex; with diagonals both ways there are four, seven or eight.
    const Net patch = noisy_patch();
    Faces triangles;
    for (int f = 0; f < patch.face_count(); ++f) {
        const std::span<const int> q = patch.faces()[f];
        const int turn = f % 3 == 0 ? 1 : 0;
        triangles.add({q[turn], q[turn + 1], q[turn + 2]});
        triangles.add({q[turn], q[turn + 2], q[(turn + 3) % 4]});
    }
    const Net flat(Eigen::Vector3d(1, 1, 0).asDiagonal() * patch.rest_positions(), triangles);
    Equalizer equalizer(flat);
    CHECK(equalizer.solve().status == Status::converged);
    CHECK(equalizer.positions().row(2).cwiseAbs().maxCoeff() > 0.01 * flat.mean_length());
}

TEST_CASE("A net with edges of one length comes back bit for bit") {
    const Net net = make_shape("elephant:vertices=1000").net;
    const EqualizeOptions options = GENERATE_COPY(EqualizeOptions{}, EqualizeOptions{EqualLength::fitting, 0, {}},
                                                  EqualizeOptions{EqualLength::given, net.mean_length(), {3, 100}});
    Equalizer equalizer(net, options);
    const EqualizeReport report = equalizer.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.way == EqualizeWay::at_rest);
    CHECK(report.iterations == 0);
    CHECK(report.max_move == 0);
    CHECK(equalizer.positions() == net.rest_positions());
}

TEST_CASE("Folds over 60 degrees are counted, in the mesh and in the net") {
    const double turns[] = {0, 50, -70, 120, 59, 61};  // degrees, between unit squares in a row
    const int count = static_cast<int>(std::size(turns)) + 1;
    Positions x(3, 2 * count);
    Faces faces;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double heading = 0;
    for (int k = 0; k < count; ++k) {
        x.col(2 * k) = at;
        x.col(2 * k + 1) = at + Eigen::Vector3d::UnitY();
        if (k > 0) faces.add({2 * k - 2, 2 * k, 2 * k + 1, 2 * k - 1});
        heading += turns[k % std::size(turns)] * std::numbers::pi / 180;
        at += Eigen::Vector3d(std::cos(heading), 0, std::sin(heading));
    }
    const EqualizeReport ribbon = Equalizer(Net(x, faces)).solve();
    CHECK(ribbon.folds_before == 3);
    CHECK(ribbon.folds == 3);
    const EqualizeReport crumpled = Equalizer(split_triangles(samples::patch(6, 5))).solve();
    CHECK(crumpled.folds_before == 0);
    CHECK(crumpled.folds > 0);
}

TEST_CASE("A length that is given is the length of all edges, without handles only the size depends on it") {
    const Net mesh = noisy_patch();
    const double factor = GENERATE(0.01, 0.7, 1.0, 30.0);
    Equalizer given(mesh, {EqualLength::given, factor * mesh.mean_length(), {}});
    const EqualizeReport report = given.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.length == factor * mesh.mean_length());
    CHECK(largest_deviation(mesh, given.positions(), factor * mesh.mean_length()) < 1.1e-9);

    Equalizer mean(mesh);
    CHECK(mean.solve().fitting_length == Approx(report.fitting_length));
    const Positions& x = mean.positions();
    const Eigen::Vector3d centre = mesh.rest_positions().rowwise().mean();
    const Positions grown = (factor * (x.colwise() - centre)).colwise() + centre;
    CHECK(samples::largest_move(grown, given.positions()) < 1e-9 * std::max(1.0, factor));
}

TEST_CASE("With the fitting length the net lies nearer to the original than with any other") {
    const Net mesh = split_triangles(noisy_patch());
    const auto squared_distance = [&](EqualizeOptions options) {
        Equalizer equalizer(mesh, std::move(options));
        equalizer.solve();
        return (equalizer.positions() - mesh.rest_positions()).squaredNorm();
    };
    Equalizer fitting(mesh, by_lengths_alone(EqualLength::fitting));
    const EqualizeReport report = fitting.solve();
    CHECK(report.length == report.fitting_length);
    CHECK(report.length > 1.2 * mesh.mean_length());  // such meshes crumple
    const double nearest = squared_distance(by_lengths_alone(EqualLength::fitting));
    for (double factor : {0.9, 0.99, 1.01, 1.1})
        CHECK(nearest < squared_distance(by_lengths_alone(EqualLength::given, factor * report.length)));
}

TEST_CASE("Near the surface the fitting length is the one that is told with another, and the net nearer") {
    const Net mesh = GENERATE(noisy_patch(), samples::twice(noisy_patch(), {30, 7, 0}));
    EqualizeOptions options;
    options.way = EqualizeWay::at_rest;
    Equalizer mean(mesh, options);
    options.choice = EqualLength::fitting;
    Equalizer fitting(mesh, options);
    const EqualizeReport report = fitting.solve(), other = mean.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.way == EqualizeWay::at_rest);
    CHECK(report.length == report.fitting_length);
    CHECK(report.length == Approx(other.fitting_length).epsilon(0.005));
    REQUIRE((report.distance && other.distance));
    CHECK(report.distance->mean < other.distance->mean);
}

TEST_CASE("A net without handles neither drifts nor turns, and neither do its pieces") {
    const Net patch = noisy_patch();
    const int n = patch.vertex_count();
    Positions x(3, 2 * n);
    x << patch.rest_positions(), 2 * (patch.rest_positions().colwise() + Eigen::Vector3d(50, 7, 0));
    Faces faces = patch.faces();
    for (int f = 0; f < patch.face_count(); ++f) {
        std::vector<int> face(patch.faces()[f].begin(), patch.faces()[f].end());
        for (int& v : face) v += n;
        faces.add(face);
    }
    const Net mesh(x, faces);
    Equalizer equalizer(mesh, by_lengths_alone(EqualLength::mean));
    CHECK(equalizer.solve().status == Status::converged);
    for (int first : {0, n}) {
        const Positions before = x.middleCols(first, n), after = equalizer.positions().middleCols(first, n);
        CHECK((before.rowwise().mean() - after.rowwise().mean()).norm() < 1e-10);
        // Least squares is reached where the moves have no moment about the centre.
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();
        for (int v = 0; v < n; ++v) moment += (before.col(v) - before.rowwise().mean()).cross(after.col(v));
        CHECK(moment.norm() < 1e-6 * before.squaredNorm());
    }
}

TEST_CASE("The result of a moved mesh is the moved result") {
    const Net mesh = noisy_patch();
    const Eigen::Isometry3d motion =
        Eigen::Translation3d(3, -20, 8) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, -1).normalized());
    Equalizer here(mesh), there(Net(motion * mesh.rest_positions(), mesh.faces()));
    CHECK(here.solve().status == there.solve().status);
    CHECK(samples::largest_move(motion * here.positions(), there.positions()) < 1e-3);
}

TEST_CASE("Handles stay exactly where they are") {
    const Net mesh = noisy_patch();
    const std::vector<int> handles{0, 19, 150};
    const double factor = GENERATE(1.0, 1.1);
    Equalizer equalizer(mesh, {EqualLength::given, factor * mesh.mean_length(), handles});
    const EqualizeReport report = equalizer.solve();
    CHECK(report.status == Status::converged);
    CHECK(largest_deviation(mesh, equalizer.positions(), report.length) < 1.1e-9);
    for (int v : handles) CHECK(equalizer.positions().col(v) == mesh.rest_positions().col(v));
    CHECK(report.fitting_length == report.length);
    CHECK(report.max_move < 3);
}

TEST_CASE("What cannot be is refused honestly, with the best that was found") {
    SECTION("no five points have one distance from each other") {
        const Net mesh = five_neighbours();
        Equalizer equalizer(mesh);
        const EqualizeReport report = equalizer.solve();
        CHECK((report.status == Status::stalled || report.status == Status::max_iterations));
        CHECK(report.max_deviation > 1e-3);
        CHECK(report.max_deviation < largest_deviation(mesh, mesh.rest_positions(), mesh.mean_length()));
        CHECK(report.max_deviation == Approx(largest_deviation(mesh, equalizer.positions(), report.length)));
        REQUIRE(!report.worst_edges.empty());
        const auto edge = mesh.edges().col(report.worst_edges[0]);
        const double worst = (equalizer.positions().col(edge[0]) - equalizer.positions().col(edge[1])).norm();
        CHECK(deviation(worst / report.length) == Approx(report.max_deviation));
    }
    SECTION("handles farther apart than the net is long") {
        const Net mesh = noisy_patch();
        Equalizer equalizer(mesh, {EqualLength::given, 0.5 * mesh.mean_length(), {0, 299}});
        const EqualizeReport report = equalizer.solve();
        CHECK(report.status == Status::unreachable);
        CHECK(equalizer.positions().allFinite());
        REQUIRE(report.unreachable_pairs.size() == 1);
        const UnreachablePair& pair = report.unreachable_pairs[0];
        CHECK(pair.distance == Approx((mesh.rest_positions().col(0) - mesh.rest_positions().col(299)).norm()));
        CHECK(pair.reach == Approx(33 * 0.5 * mesh.mean_length()));
        for (int v : {0, 299}) CHECK(equalizer.positions().col(v) == mesh.rest_positions().col(v));
    }
}

TEST_CASE("In slices it comes to the same result, and can be left at any of them") {
    const Net mesh = raw_mesh("steps:vertices=400", 0.3);
    Equalizer whole(mesh), sliced(mesh);
    const EqualizeReport at_once = whole.solve();
    EqualizeReport report;
    int slices = 0;
    do {
        report = sliced.solve({1, 1e9});
        CHECK(report.iterations == ++slices);
        CHECK(sliced.positions().allFinite());
        CHECK(report.max_deviation == Approx(largest_deviation(mesh, sliced.positions(), report.length)).margin(1e-12));
    } while (report.status == Status::running);
    CHECK(report.status == at_once.status);
    CHECK(report.iterations == at_once.iterations);
    CHECK(sliced.positions() == whole.positions());
    CHECK(sliced.solve().iterations == report.iterations);  // nothing is left to do
    CHECK(report.mean_move == at_once.mean_move);
    CHECK(report.folds == at_once.folds);

    Equalizer unmeasured(mesh);
    while (unmeasured.advance({1, 1e9}) == Status::running) CHECK_FALSE(unmeasured.solve({1, 1e9}).distance);

    Equalizer hurried(mesh);
    CHECK(hurried.solve({1000, 0}).iterations == 1);
}

TEST_CASE("Lengths of any size, far from the origin and close by") {
    const double unit = GENERATE(1e-100, 1e-6, 1e6, 1e100);
    const Net patch = noisy_patch();
    const Positions x = unit * (patch.rest_positions().array() + 1000).matrix();
    Equalizer equalizer(Net(x, patch.faces()));
    const EqualizeReport report = equalizer.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.max_deviation < k_equal_deviation);
    CHECK(report.max_move < 3);
}

TEST_CASE("Lengths and handles that make no sense are refused") {
    const Net mesh = samples::mixed_mesh();
    const auto code = [&](EqualizeOptions options) {
        try {
            const Equalizer equalizer(mesh, std::move(options));
        } catch (const Error& error) {
            return error.code();
        }
        FAIL("not refused");
        return ErrorCode::no_faces;
    };
    for (double length : {0.0, -1.0, 1e-9, 1e9, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK(code({EqualLength::given, length, {}}) == ErrorCode::bad_option);
    CHECK(code({EqualLength::fitting, 0, {1}}) == ErrorCode::bad_option);
    CHECK(code({EqualLength::mean, 0, {8}}) == ErrorCode::index_out_of_range);
    CHECK(code({EqualLength::mean, 0, {1, 1}}) == ErrorCode::repeated_vertex);
    for (double limit : {-1.0, 2.0, std::nan("")})
        CHECK(code({.way = EqualizeWay::at_rest, .shear_limit = limit}) == ErrorCode::bad_option);
}
