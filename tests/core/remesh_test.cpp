#include "remesh/remesh.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "constants.h"
#include "drape/drape.h"
#include "drape/tilt.h"
#include "hard_surfaces.h"
#include "implicit_surface.h"
#include "net/measures.h"
#include "net/repair.h"
#include "net/topology.h"
#include "remesh/border_distance.h"
#include "remesh/border_sides.h"
#include "remesh/cell_mesh.h"
#include "remesh/cells.h"
#include "remesh/connection.h"
#include "remesh/creases.h"
#include "remesh/direction_field.h"
#include "remesh/even_triangles.h"
#include "remesh/fewer_singular.h"
#include "remesh/grid_map.h"
#include "remesh/integers.h"
#include "remesh/one_piece.h"
#include "remesh/pinholes.h"
#include "remesh/remesh_one_way.h"
#include "remesh/rows.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "surface/gallery.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

/// Σ over inner vertices of 4 less their edges, and over those of the boundary of 3 less theirs: four times the Euler
/// characteristic of every mesh of quads.
int valence_defects(const Net& net) {
    const Topology topology(net);
    int sum = 0;
    for (int v = 0; v < net.vertex_count(); ++v) sum += (topology.is_boundary(v) ? 3 : 4) - topology.valence(v);
    return sum;
}

int singular_count(const Net& net) {
    int sum = 0;
    for (const auto& [valence, count] : Topology(net).singular_vertices()) sum += count;
    return sum;
}

/// Two pieces, of which the other one is moved.
Mesh beside(Mesh mesh, const Mesh& other, const Eigen::Vector3d& move) {
    const auto count = mesh.positions.cols();
    mesh.positions.conservativeResize(3, count + other.positions.cols());
    mesh.positions.rightCols(other.positions.cols()) = other.positions.colwise() + move;
    for (int f = 0; f < other.faces.size(); ++f) {
        std::vector<int> face(other.faces[f].begin(), other.faces[f].end());
        for (int& v : face) v += static_cast<int>(count);
        mesh.faces.add(face);
    }
    return mesh;
}

/// Each face with vertices of its own, drawn together by a part of its size.
Mesh in_scraps(const Mesh& mesh, double gap) {
    Mesh scraps{Positions(3, 3 * mesh.faces.size()), {}};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::span<const int> face = mesh.faces[f];
        Eigen::Matrix3d corners;
        for (int k = 0; k < 3; ++k) corners.col(k) = mesh.positions.col(face[k]);
        const Eigen::Vector3d middle = corners.rowwise().mean();
        scraps.positions.middleCols(3 * f, 3) = (1 - gap) * corners + gap * middle.replicate(1, 3);
        scraps.faces.add({3 * f, 3 * f + 1, 3 * f + 2});
    }
    return scraps;
}

/// A net over the whole of it, with all that is promised.
Remesh remeshed(const Surface& surface, const RemeshOptions& options, int characteristic) {
    const auto guide = std::make_shared<const Guide>(surface);
    Remesh made = remesh(guide, options);
    const Net& net = made.net;
    CHECK(faces_by_arity(net.faces()).count(4) == 1);
    CHECK(faces_by_arity(net.faces()).size() == 1);
    CHECK(samples::euler_characteristic(net) == characteristic);
    CHECK(valence_defects(net) == 4 * characteristic);
    CHECK(max_deviation(net, net.rest_positions()) < 1e-9);
    CHECK(corner_angle_range(net, net.rest_positions()).smallest >= options.smallest_angle - 1e-9);
    const DrapeReport report = measure_drape(surface, guide->tree(), net);
    CHECK(report.mean_distance < 0.3 * net.mean_length());
    CHECK(report.coverage > 0.85);
    return made;
}

RemeshOptions of_cells(int cells) {
    RemeshOptions options;
    options.cells = cells;
    return options;
}

Surface cube() {
    Mesh mesh;
    mesh.positions.resize(3, 8);
    mesh.positions << 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1;
    for (const auto& face : {std::array{3, 2, 1, 0}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                             std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}})
        mesh.faces.add(face);
    return Surface(mesh);
}

Surface stretched(const Surface& surface, const Eigen::Vector3d& by) {
    Mesh mesh{surface.positions(), {}};
    for (int axis = 0; axis < 3; ++axis) mesh.positions.row(axis) *= by[axis];
    for (int f = 0; f < surface.face_count(); ++f)
        mesh.faces.add({surface.triangles()(0, f), surface.triangles()(1, f), surface.triangles()(2, f)});
    return Surface(mesh);
}

double distance_to(const Net& net, const Eigen::Vector3d& point, int a, int b) {
    const Eigen::Vector3d from = net.rest_positions().col(a);
    const Eigen::Vector3d edge = net.rest_positions().col(b) - from;
    const double part = std::clamp((point - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return (point - from - part * edge).norm();
}

double distance_to_edges(const Net& net, const Eigen::Vector3d& point) {
    double least = std::numeric_limits<double>::infinity();
    for (int e = 0; e < net.edge_count(); ++e)
        least = std::min(least, distance_to(net, point, net.edges()(0, e), net.edges()(1, e)));
    return least;
}

/// In edges.
double off_border(const Surface& surface, const Net& net) { return border_distance(surface, net) / net.mean_length(); }

/// Of the vertices on the border how many have so many edges, but for those that it goes straight on at.
std::map<int, int> border_corners(const Net& net) {
    const Topology topology(net);
    std::map<int, int> counts;
    for (int v = 0; v < net.vertex_count(); ++v)
        if (topology.is_boundary(v) && topology.valence(v) != 3) ++counts[topology.valence(v)];
    return counts;
}

Surface plate(int m, int n, double width, double height, const std::function<bool(double, double)>& is_there) {
    const Mesh all = samples::quads(m + 1, n + 1, false, false,
                                    [&](int i, int j) { return Eigen::Vector3d(width * i / m, height * j / n, 0); });
    Mesh mesh{all.positions, {}};
    for (int f = 0; f < all.faces.size(); ++f) {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        for (const int v : all.faces[f]) centre += all.positions.col(v) / 4;
        if (is_there(centre.x(), centre.y())) mesh.faces.add(all.faces[f]);
    }
    return Surface(repair(mesh, {Defect::unused_vertices}).mesh);
}

/// Of squares, without those beyond a circle.
Surface stepped_dome(int size, double height) {
    const Mesh whole = samples::graph(
        size, 1, [height](double x, double y) { return height * std::sqrt(std::max(0.0, 1.4 - x * x - y * y)); });
    return Surface(samples::without(whole, [](const auto& p) { return p.x() * p.x() + p.y() * p.y() > 0.97; }));
}

Surface disc() {
    Mesh mesh = samples::sphere(16, true);
    for (int v = 0; v < mesh.positions.cols(); ++v) {
        const Eigen::Vector3d p = mesh.positions.col(v);
        const double angle = std::acos(std::min(1.0, p.z())), radius = std::hypot(p.x(), p.y());
        mesh.positions.col(v) =
            radius > 0 ? Eigen::Vector3d(angle * p.x() / radius, angle * p.y() / radius, 0) : Eigen::Vector3d::Zero();
    }
    return Surface(mesh);
}

}  // namespace

TEST_CASE("A smooth closed body gets a net with eight singular vertices") {
    const Net net = remeshed(make_own_surface("pebble"), of_cells(400), 2).net;
    CHECK(net.face_count() == Approx(400).epsilon(0.1));
    CHECK(Topology(net).singular_vertices() == std::map<int, int>{{3, 8}});
}

TEST_CASE("A net on a smooth closed body lies on it about singular vertices, too, rather than rising to tips there",
          "[large]") {
    const auto guide = std::make_shared<const Guide>(make_own_surface("pebble"));
    const Net net = remesh(guide, of_cells(1500)).net;
    const DrapeReport report = measure_drape(guide->surface(), guide->tree(), net);
    CHECK(report.mean_distance < 0.1 * report.length);
    CHECK(report.coverage > 0.998);
    CHECK(report.folds < 0.002 * net.edge_count());
    CHECK(report.largest_distance < 0.8 * report.length);
    // Straight rods would make a cone of three corners of 75 degrees where the surface has about 360.
    const Topology topology(net);
    double sum = 0;
    for (int f = 0; f < net.face_count(); ++f)
        for (int k = 0; k < 4; ++k) {
            const std::span<const int> face = net.faces()[f];
            if (topology.valence(face[k]) != 3) continue;
            const auto along = [&](int other) {
                return Eigen::Vector3d(net.rest_positions().col(face[other % 4]) - net.rest_positions().col(face[k]))
                    .normalized();
            };
            sum += std::acos(along(k + 1).dot(along(k + 3)));
        }
    CHECK(sum / 8 > 250 * std::numbers::pi / 180);
}

TEST_CASE("Nor does a net with a border rise to a tip, on the top of a hill", "[large]") {
    const Surface hill(samples::graph(41, 2, [](double x, double y) { return 1.5 * std::exp(-x * x - y * y); }));
    const Remesh made = remesh(std::make_shared<const Guide>(hill), of_cells(1500));
    CHECK(made.singular.size() == 1);
    CHECK(sharp_folds(made.net, made.net.rest_positions(), k_fold) == 0);
}

TEST_CASE("Directions on a sphere are turned so that edges of one length need few folds, whatever its triangles",
          "[large]") {
    const int around = GENERATE(12, 16, 20, 24);
    const auto guide = std::make_shared<const Guide>(Surface(samples::sphere(around)));
    const Net net = remesh(guide, of_cells(1500)).net;
    CAPTURE(around);
    CHECK(measure_drape(guide->surface(), guide->tree(), net).folds < 0.008 * net.edge_count());
}

TEST_CASE("Closed bodies get nets that are crumpled nowhere: lines have kinks beside those from singular vertices") {
    const auto guide = std::make_shared<const Guide>(Surface(samples::blob(3)));
    const Net net = remesh(guide, of_cells(1000)).net;
    const DrapeReport report = measure_drape(guide->surface(), guide->tree(), net);
    CHECK(crumpled_edges(*guide, net) == 0);
    CHECK(report.folds < 5);
    CHECK(report.mean_distance < 0.075 * report.length);
}

TEST_CASE("Between singular vertices there are as many cells as edges of one length ask for", "[large]") {
    const auto guide =
        std::make_shared<const Guide>(repaired_surface(samples::chain_of_rings(2), k_all_defects).surface);
    const Net net = remesh(guide, of_cells(1000)).net;
    CHECK(crumpled_edges(*guide, net) == 0);
    CHECK(distance_to(*guide, net, net.rest_positions()).mean < 0.1 * net.mean_length());
}

TEST_CASE("A cube of twelve triangles gets a net with eight singular vertices") {
    CHECK(Topology(remeshed(cube(), of_cells(600), 2).net).singular_vertices() == std::map<int, int>{{3, 8}});
}

TEST_CASE("A torus gets the Chebyshev net that is turned about its axis, without singular vertices") {
    const Surface torus(samples::torus(60, 24, 3, 1));
    const Net net = remeshed(torus, of_cells(800), 0).net;
    CHECK(singular_count(net) == 0);
    const Guide guide(torus);
    const DrapeReport report = measure_drape(torus, guide.tree(), net);
    CHECK(report.mean_distance < 0.1 * report.length);
    // Both families cross the circles about the axis at the angle φ. Between two of their lines one goes 2 L sin φ
    // along such a circle, of radius ρ, and n pairs of lines close it: 2 L sin φ = 2π ρ / n, the same part of every
    // circle.
    double sum = 0, squares = 0;
    for (int f = 0; f < net.face_count(); ++f) {
        const auto at = [&](int k) { return Eigen::Vector3d(net.rest_positions().col(net.faces()[f][k])); };
        const Eigen::Vector3d centre = (at(0) + at(1) + at(2) + at(3)) / 4;
        const Eigen::Vector3d around = Eigen::Vector3d::UnitZ().cross(centre).normalized();
        const double across = std::max(std::abs((at(2) - at(0)).dot(around)), std::abs((at(3) - at(1)).dot(around)));
        const double part = across / std::hypot(centre.x(), centre.y());
        sum += part, squares += part * part;
    }
    const double mean = sum / net.face_count();
    CHECK(std::sqrt(squares / net.face_count() - mean * mean) < 0.1 * mean);
}

TEST_CASE("Of singular vertices a net has as few as it takes, if that is asked for", "[large]") {
    // Two rings in one: χ = −2, so that no net of quads has fewer than eight.
    const Surface rings(samples::implicit_surface(24, {-2.6, -1.5, -0.6}, {2.6, 1.5, 0.6}, [](const auto& p) {
        const auto ring = [&](double x) {
            const double around = std::hypot(p.x() - x, p.y()) - 1;
            return std::hypot(around, p.z()) - 0.42;
        };
        const double a = ring(-1), b = ring(1), blend = std::max(0.4 - std::abs(a - b), 0.0) / 0.4;
        return std::min(a, b) - 0.1 * blend * blend;
    }));
    RemeshOptions options = of_cells(700);
    const int usual = singular_count(remeshed(rings, options, -2).net);
    options.fewest = true;
    const Net net = remeshed(rings, options, -2).net;
    CHECK(singular_count(net) < usual);
    CHECK(singular_count(net) >= 8);
    const Guide guide(rings);
    const DrapeReport report = measure_drape(rings, guide.tree(), net);
    CHECK(report.mean_distance < 0.2 * report.length);
}

SingularWishes wished_alone(const Surface& surface, const std::vector<PlacedWishes::Pin>& pins) {
    SingularWishes wishes;
    wishes.only = true;
    for (const PlacedWishes::Pin& pin : pins)
        wishes.vertices.push_back({surface.positions().col(pin.vertex), 4 - pin.index});
    return wishes;
}

TEST_CASE("Singular vertices of a field are placed where they are, and where two stand on one vertex beside it") {
    const Surface sphere(samples::sphere(24));
    const SurfaceTree tree(sphere);
    const WishPlacer placer(sphere, 0.2);
    const auto same = [](const PlacedWishes::Pin& a, const PlacedWishes::Pin& b) {
        return a.vertex == b.vertex && a.index == b.index;
    };
    for (const std::vector<PlacedWishes::Pin>& pins : fewer_and_fewer(sphere, smoothest_field(sphere, {}), {})) {
        const PlacedWishes there = placer.placed_alone(pins, tree);
        const PlacedWishes searched = placer.placed(wished_alone(sphere, pins), tree);
        CHECK(std::equal(there.pins.begin(), there.pins.end(), pins.begin(), pins.end(), same));
        CHECK(std::equal(there.pins.begin(), there.pins.end(), searched.pins.begin(), searched.pins.end(), same));
        CHECK(there.is_forbidden == searched.is_forbidden);
        CHECK(there.only);
    }
    int inner = 0;
    while (sphere.is_boundary(inner)) ++inner;
    const PlacedWishes twice = placer.placed_alone({{inner, 1}, {inner, 1}}, tree);
    CHECK(twice.pins[0].vertex == inner);
    CHECK(twice.pins[1].vertex != inner);
    CHECK((sphere.positions().col(twice.pins[1].vertex) - sphere.positions().col(inner)).norm() < 0.6);
}

TEST_CASE("Smoothing a field can be ended in each of its rounds") {
    const Surface sphere(samples::sphere(6));
    int rounds = 0;
    FieldOptions options;
    options.smoothing = 1000;
    options.go_on = [&rounds] {
        if (++rounds == 3) throw std::runtime_error("enough");
    };
    CHECK_THROWS_AS(smoothest_field(sphere, options), std::runtime_error);
    CHECK(rounds == 3);
}

TEST_CASE("A net whose corners cannot all keep the limit says how many quads do not") {
    const auto guide = std::make_shared<const Guide>(Surface(samples::torus(24, 12, 2, 1)));
    RemeshOptions options = of_cells(60);
    options.smallest_angle = std::numbers::pi / 3;
    CHECK(remesh(guide, options).sharp_quads == 0);
    // Hardly any number of so few cells suits the inside and the outside.
    options.cells = 36;
    const Remesh made = remesh(std::make_shared<const Guide>(Surface(samples::torus(24, 12, 2.5, 1))), options);
    const Positions& x = made.net.rest_positions();
    CHECK(corner_angle_range(made.net, x).smallest < options.smallest_angle - 0.01);
    CHECK(made.sharp_quads > 0);
    CHECK(made.sharp_quads == sharp_quads(made.net, x, options.smallest_angle - 1e-3));
}

TEST_CASE("Singular vertices cancel each other until those of one sign are left") {
    const Surface torus(samples::torus(60, 24, 3, 1)), sphere(samples::sphere(12));
    for (const auto& [surface, index] : {std::pair(&torus, 0), std::pair(&sphere, 8)}) {
        const std::vector<std::vector<PlacedWishes::Pin>> pins =
            fewer_and_fewer(*surface, smoothest_field(*surface, {}), border_sides(*surface));
        for (std::size_t k = 0; k < pins.size(); ++k) {
            CHECK(pins[k].size() == pins[0].size() - 2 * k);
            check_wishes(Guide(*surface), wished_alone(*surface, pins[k]));  // each adds up to 4 χ
        }
        CHECK(static_cast<int>(pins.back().size()) == index);
    }
}

TEST_CASE("Where there is a border singular vertices go over it, the nearest to it first, until none is left") {
    const Surface cap = make_own_surface("hemisphere");
    const std::vector<std::vector<PlacedWishes::Pin>> pins = fewer_and_fewer(cap, smoothest_field(cap, {}), {});
    REQUIRE(pins.size() > 1);
    const auto lowest = [&cap](const std::vector<PlacedWishes::Pin>& those) {
        double z = std::numeric_limits<double>::infinity();
        for (const auto& each : those) z = std::min(z, cap.positions()(2, each.vertex));
        return z;
    };
    for (std::size_t k = 1; k < pins.size(); ++k) {
        const std::size_t gone = pins[k - 1].size() - pins[k].size();
        CHECK((gone == 1 || gone == 2));
        check_wishes(Guide(cap), wished_alone(cap, pins[k]));
        if (gone == 1) CHECK(lowest(pins[k - 1]) <= lowest(pins[k]));  // the border is at the foot
    }
    CHECK(pins.back().empty());
}

TEST_CASE("A hemisphere gets a net without singular vertices that is folded nowhere", "[large]") {
    const auto guide = std::make_shared<const Guide>(make_own_surface("hemisphere"));
    for (const double cells : {400, 1000}) {
        const Remesh made = remesh(guide, of_cells(cells));
        const DrapeReport report = measure_drape(guide->surface(), guide->tree(), made.net);
        CHECK(made.singular.empty());
        CHECK(report.folds == 0);
        CHECK(report.mean_distance < 0.05 * report.length);
        CHECK(report.coverage > 0.95);
    }
}

TEST_CASE("A surface with borders gets a net with borders") {
    const Net tube = remeshed(make_own_surface("torso"), of_cells(400), 0).net;
    CHECK(Topology(tube).boundary_loops().size() == 2);
    const Net hypar = remeshed(make_own_surface("hypar"), of_cells(400), 1).net;
    CHECK(singular_count(hypar) == 0);
}

TEST_CASE("Net lines do not wave: from vertex to vertex they go on bending to the same side", "[large]") {
    const Net net = remeshed(Surface(samples::sphere(24)), of_cells(1500), 2).net;
    const Positions& x = net.rest_positions();
    const auto turn = [&](const std::vector<int>& line, std::size_t k) {
        return Eigen::Vector3d(x.col(line[k - 1]) - 2 * x.col(line[k]) + x.col(line[k + 1]));
    };
    double turns = 0, changes = 0;
    for (const std::vector<int>& line : Topology(net).net_lines())
        for (std::size_t k = 2; k + 1 < line.size(); ++k) {
            turns += turn(line, k).squaredNorm();
            changes += (turn(line, k) - turn(line, k - 1)).squaredNorm();
        }
    // Turns that have nothing to do with one another would change by √2 of their size, those of a zigzag by 2.
    CHECK(std::sqrt(changes / turns) < 1.3);
}

TEST_CASE("A rough scan gets a net with as few singular vertices as the shape without its noise") {
    Mesh mesh = samples::sphere(24);
    std::mt19937 random(7);
    for (int v = 0; v < mesh.positions.cols(); ++v) mesh.positions.col(v) += samples::random_point(0.01, random);
    CHECK(singular_count(remeshed(Surface(mesh), of_cells(500), 2).net) <= 12);
}

TEST_CASE("A net over a rough scan is folded no more than one over the shape without its noise", "[large]") {
    const Net rough = remeshed(Surface(samples::rough_sphere(36, 0.03)), of_cells(1500), 2).net;
    const Net smooth = remeshed(Surface(samples::sphere(36)), of_cells(1500), 2).net;
    const int smooth_folds = sharp_folds(smooth, smooth.rest_positions(), k_fold);
    CAPTURE(smooth_folds);
    CHECK(sharp_folds(rough, rough.rest_positions(), k_fold) <= smooth_folds + 8);
}

TEST_CASE("The teeth of a wheel are no noise: its net keeps its shape", "[large]") {
    const Mesh wheel = samples::implicit_surface(48, {-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}, [](const Eigen::Vector3d& p) {
        const double radius = p.head<2>().norm(), tooth = std::sin(7 * std::atan2(p.y(), p.x())) > 0 ? 0.25 : 0;
        return std::max({std::abs(p.z()) - 0.3, radius - 1.05 - tooth, 0.45 - radius});
    });
    remeshed(Surface(wheel), of_cells(1500), 0);
}

TEST_CASE("Limbs get singular vertices of their own where cells would be sheared more without", "[large]") {
    const Surface tetrapod(
        samples::implicit_surface(40, {-2.2, -2.2, -2.2}, {2.2, 2.2, 2.2}, [](const Eigen::Vector3d& p) {
            double sum = 0;
            for (const Eigen::Vector3d& tip : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(-1, -1, 1),
                                               Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(1, -1, -1)})
                sum += std::exp(6 * (0.5 - (p - std::clamp(p.dot(tip) / 3, 0.0, 1.0) * tip).norm()));
            return 1 - sum;
        }));
    const auto with_smoothing = [&](double smoothing) {
        RemeshOptions options = of_cells(2000);
        options.smoothing = smoothing;
        return remeshed(tetrapod, options, 2).net;
    };
    const auto sheared_part = [](const Net& net) {
        const double limit = std::numbers::pi / 6;
        return sharp_quads(net, net.rest_positions(), std::numbers::pi / 2 - limit) /
               static_cast<double>(net.face_count());
    };
    const Net usual = with_smoothing(1), no_rougher = with_smoothing(1.01);
    CHECK(singular_count(usual) > singular_count(no_rougher));
    CHECK(sheared_part(usual) < 0.95 * sheared_part(no_rougher));
}

TEST_CASE(
    "Of cells in a row one or two that hang at a border are left out, a narrow part and a piece of its own stay") {
    using Place = std::pair<int, int>;
    const auto faces_left = [](const std::vector<Place>& places, std::vector<int> pieces = {}) {
        pieces.resize(places.size(), 0);
        Cells cells{{}, Positions::Zero(3, std::ssize(places)), Positions::Zero(3, std::ssize(places)), pieces};
        for (int q = 0; q < cells.size(); ++q) {
            cells.centres.col(q) << places[q].first, places[q].second, 0;
            cells.normals.col(q) = Eigen::Vector3d::UnitZ();
            const auto& [i, j] = places[q];
            const Place beyond[] = {{i, j - 1}, {i + 1, j}, {i, j + 1}, {i - 1, j}};
            for (int side = 0; side < 4; ++side) {
                const auto other = std::find(places.begin(), places.end(), beyond[side]);
                const int number = static_cast<int>(other - places.begin());
                cells.opposite.push_back(other == places.end() ? -1 : 4 * number + (side + 2) % 4);
            }
        }
        return mesh_of(cells).faces.size();
    };
    const auto block_with_row = [](int size, int row) {
        std::vector<Place> places;
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < size; ++j) places.emplace_back(i, j);
        for (int k = 0; k < row; ++k) places.emplace_back(size + k, 0);
        return places;
    };
    for (const auto& [row, left] : {std::pair(0, 9), {1, 9}, {2, 9}, {3, 12}, {4, 13}})
        CHECK(faces_left(block_with_row(3, row)) == left);
    for (const int alone : {1, 2, 3, 4}) CHECK(faces_left(block_with_row(0, alone)) == alone);
    // Beside a block, on the same piece of the surface or on one of its own.
    std::vector<Place> apart = block_with_row(3, 0);
    for (const auto& [count, left] : {std::pair(1, 9), {2, 9}, {3, 12}}) {
        apart.emplace_back(8 + count, 0);
        CHECK(faces_left(apart) == left);
        std::vector<int> pieces(9, 0);
        pieces.resize(apart.size(), 1);
        CHECK(faces_left(apart, pieces) == 9 + count);
    }
}

TEST_CASE("No tail of one or two cells hangs at the border, a narrow part of a surface is covered", "[large]") {
    const Mesh roof = samples::without(
        samples::quads(61, 37, false, false,
                       [](int i, int j) {
                           const double x = 50. * i / 60, y = 30. * j / 36;
                           return Eigen::Vector3d(x, y, 2 * std::sin(x / 5) + 1.2 * std::cos(y / 4));
                       }),
        [](const Eigen::Vector3d& p) { return std::pow((p.x() - 27) / 7, 2) + std::pow((p.y() - 14) / 4, 2) < 1; });
    for (const int cells : {450, 800, 1500}) {
        CAPTURE(cells);
        RemeshOptions options = of_cells(cells);
        options.border = RemeshOptions::Border::across;
        const Net net = remeshed(Surface(roof), options, 0).net;
        const Topology topology(net);
        for (int f = 0; f < net.face_count(); ++f) {
            int inner = 0;
            for (int k = 0; k < 4; ++k) {
                const int edge = topology.edge_between(net.faces()[f][k], net.faces()[f][(k + 1) % 4]);
                inner += net.edge_face_counts()[edge] - 1;
            }
            CHECK(inner > 1);
        }
        CHECK(sharp_folds(net, net.rest_positions(), k_fold) == 0);
    }
    // With an arm as wide as a cell, five cells long.
    const Mesh arm = samples::without(samples::plane(81, 8),
                                      [](const Eigen::Vector3d& p) { return p.x() > 2 && std::abs(p.y()) > 0.6; });
    CHECK(remeshed(Surface(arm), of_cells(120), 1).net.rest_positions().row(0).maxCoeff() > 6.5);
}

TEST_CASE("A dome whose border goes in steps of about a cell is covered by as many cells as asked for") {
    RemeshOptions options = of_cells(400);
    options.border = RemeshOptions::Border::never;
    const Net net = remesh(std::make_shared<const Guide>(stepped_dome(41, 0.9)), options).net;
    CHECK(std::abs(net.face_count() - options.cells) < 50);
}

TEST_CASE("A net line along a border that goes in steps of about a cell does not crumple the net") {
    RemeshOptions options = of_cells(400);
    options.border = RemeshOptions::Border::always;
    for (const Surface& dome : {stepped_dome(25, 0.7), stepped_dome(41, 0.9)}) {
        const Net net = remesh(std::make_shared<const Guide>(dome), options).net;
        const DrapeReport report = measure_drape(dome, SurfaceTree(dome), net);
        CAPTURE(dome.face_count());
        CHECK(report.folds == 0);
        CHECK(report.mean_distance < 0.02 * report.length);
        CHECK(off_border(dome, net) < 0.5);
    }
}

TEST_CASE("All pieces of a surface are covered") {
    const Surface spheres(beside(samples::sphere(8), samples::sphere(8), {3, 0, 0}));
    CHECK(Topology(remeshed(spheres, of_cells(600), 4).net).component_count() == 2);
}

TEST_CASE("A surface in scraps is refused with how many there are and the way out") {
    const Mesh sphere = samples::sphere(10);  // 800 triangles
    const auto refusal = [](const Mesh& mesh, int cells) -> std::string {
        try {
            check_remesh(Guide(Surface(mesh)), of_cells(cells));
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::too_large);
            return error.what();
        }
        return "";
    };
    CHECK(refusal(in_scraps(sphere, 0), 4000) ==
          "the surface is in 800 pieces, 800 of which are small and touch others without being joined to them: "
          "repaired (--repair), vertices that coincide are merged");
    CHECK(refusal(in_scraps(sphere, 0.1), 1000) ==
          "the surface is in 800 pieces, 800 of which are smaller than four cells: smaller cells, or a surface without "
          "these, may do");
    CHECK(refusal(in_scraps(sphere, 0.1), 4000) == "");
    CHECK(refusal(in_scraps(sphere, 0), 40000) == "");
    const Mesh specks = in_scraps(sphere, 0.1);
    CHECK(refusal(beside(samples::sphere(10), {0.1 * specks.positions, specks.faces}, {3, 0, 0}), 4000) == "");
}

TEST_CASE("The length and the limit of corners are kept where they are given") {
    RemeshOptions options;
    options.length = 0.2;
    options.smallest_angle = 45 * samples::k_degree;
    const Net net = remeshed(Surface(samples::sphere(16)), options, 2).net;
    CHECK(net.mean_length() == Approx(0.2).epsilon(1e-9));
}

TEST_CASE("Edges have one length to the last digits, also where a net has not come to rest", "[large]") {
    RemeshOptions options = of_cells(900);
    options.border = RemeshOptions::Border::always;
    for (const char* name : {"hemisphere", "shell"}) {
        const Net net = remeshed(make_own_surface(name), options, 1).net;
        CAPTURE(name);
        CHECK(max_deviation(net, net.rest_positions()) < 1e-20);
    }
}

TEST_CASE("Where a given length does not fit around a body there are as many cells as let the net lie on it",
          "[large]") {
    const Surface torus(samples::torus(60, 24, 3, 1));
    const Guide guide(torus);
    for (const double length : {0.3, 0.32, 0.34, 0.38}) {
        RemeshOptions options;
        options.length = length;
        const Net net = remeshed(torus, options, 0).net;
        const DrapeReport report = measure_drape(torus, guide.tree(), net);
        INFO(length);
        CHECK(report.length == Approx(length).epsilon(1e-8));
        CHECK(report.coverage > 0.999);
        CHECK(report.mean_distance < 0.1 * length);
        CHECK(report.folds == 0);
    }
}

TEST_CASE("Far from the origin a surface gets the net that it gets there") {
    const Eigen::Vector3d far(5e5, -4e6, 300);
    Mesh mesh = samples::sphere(12);
    const auto distance = [](const Mesh& of, const RemeshOptions& options) {
        const Guide guide{Surface(of)};
        const Net net = remeshed(guide.surface(), options, 2).net;
        return measure_drape(guide.surface(), guide.tree(), net).mean_distance;
    };
    const double near_by_cells = distance(mesh, of_cells(200));
    RemeshOptions of_length;
    of_length.length = 0.25;
    const double near_by_length = distance(mesh, of_length);
    mesh.positions.colwise() += far;
    CHECK(distance(mesh, of_cells(200)) == Approx(near_by_cells).epsilon(0.02));
    CHECK(distance(mesh, of_length) == Approx(near_by_length).epsilon(0.02));
}

TEST_CASE("The same surface gives the same net, whose progress is told in order and can be ended") {
    const auto surface = std::make_shared<const Guide>(make_own_surface("pebble"));
    std::vector<RemeshPhase> phases;
    const Remesh first = remesh(surface, of_cells(200), [&](RemeshPhase phase, double done) {
        CHECK((done >= 0 && done <= 1));
        if (phases.empty() || phases.back() != phase) phases.push_back(phase);
    });
    CHECK(phases == std::vector{RemeshPhase::triangles, RemeshPhase::field, RemeshPhase::grid, RemeshPhase::fit});
    const Remesh second = remesh(surface, of_cells(200));
    CHECK(first.net.rest_positions() == second.net.rest_positions());
    CHECK(first.net.faces().vertices == second.net.faces().vertices);

    const auto stop = [](RemeshPhase phase, double) {
        if (phase == RemeshPhase::fit) throw std::string("enough");
    };
    CHECK_THROWS_AS(remesh(surface, of_cells(200), stop), std::string);
}

TEST_CASE("A net's faces follow each other in rows, and its vertices in the order of faces") {
    const Surface sphere(samples::sphere(12));
    const Net net = remesh(std::make_shared<const Guide>(sphere), {.cells = 600}).net;
    Mesh shuffled{net.rest_positions(), net.faces()};
    std::vector<int> vertices(static_cast<std::size_t>(net.vertex_count()));
    std::iota(vertices.begin(), vertices.end(), 0);
    std::vector<int> faces(static_cast<std::size_t>(net.face_count()));
    std::iota(faces.begin(), faces.end(), 0);
    std::mt19937 random(7);
    std::shuffle(vertices.begin(), vertices.end(), random);
    std::shuffle(faces.begin(), faces.end(), random);
    shuffled.faces = {};
    for (const int f : faces) {
        std::array<int, 4> corners;
        for (int k = 0; k < 4; ++k) corners[k] = vertices[net.faces()[f][k]];
        shuffled.faces.add(corners);
    }
    for (int v = 0; v < net.vertex_count(); ++v) shuffled.positions.col(vertices[v]) = net.rest_positions().col(v);

    const Mesh rows = in_rows(shuffled);
    // The same quads, as sets of places.
    const auto places = [](const Mesh& mesh) {
        std::vector<std::vector<std::array<double, 3>>> quads;
        for (int f = 0; f < mesh.faces.size(); ++f) {
            std::vector<std::array<double, 3>>& quad = quads.emplace_back();
            for (const int v : mesh.faces[f])
                quad.push_back({mesh.positions(0, v), mesh.positions(1, v), mesh.positions(2, v)});
            std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
        }
        std::sort(quads.begin(), quads.end());
        return quads;
    };
    CHECK(places(rows) == places({net.rest_positions(), net.faces()}));
    // Most have an edge with the one before.
    const auto joined = [](const Faces& quads) {
        int count = 0;
        for (int f = 1; f < quads.size(); ++f) {
            int shared = 0;
            for (const int v : quads[f]) shared += std::count(quads[f - 1].begin(), quads[f - 1].end(), v) > 0;
            count += shared == 2;
        }
        return count;
    };
    CHECK(joined(shuffled.faces) < 0.1 * net.face_count());
    CHECK(joined(rows.faces) > 0.9 * net.face_count());
    CHECK(joined(net.faces()) > 0.9 * net.face_count());
    int seen = 0;
    for (const int v : rows.faces.vertices) {
        CHECK(v <= seen + 2);
        seen = std::max(seen, v + 1);
    }
    CHECK(seen == net.vertex_count());
}

TEST_CASE("Rows that cross themselves leave no quad behind, wherever one begins") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int trial = 0; trial < 200; ++trial) {
        // A tetrahedron some of whose triangles are cut in three, and then all of them into three quads.
        std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
        for (int v = 4; v < 4 + trial % 12; ++v) {
            std::swap(triangles[random() % triangles.size()], triangles.back());
            const auto [a, b, c] = triangles.back();
            triangles.pop_back();
            triangles.insert(triangles.end(), {{a, b, v}, {b, c, v}, {c, a, v}});
        }
        std::map<std::vector<int>, int> numbers;  // of a corner, the middle of an edge, that of a triangle
        const auto number = [&](std::vector<int> of) {
            std::sort(of.begin(), of.end());
            return numbers.emplace(of, static_cast<int>(numbers.size())).first->second;
        };
        std::vector<std::array<int, 4>> quads;
        for (const auto& [a, b, c] : triangles)
            for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}})
                quads.push_back({number({p}), number({p, q}), number({a, b, c}), number({r, p})});
        std::shuffle(quads.begin(), quads.end(), random);
        Mesh mesh{Positions::Random(3, std::ssize(numbers)), {}};
        for (std::array<int, 4>& quad : quads) {
            std::rotate(quad.begin(), quad.begin() + random() % 4, quad.end());
            mesh.faces.add(quad);
        }
        const Mesh rows = in_rows(mesh);
        REQUIRE(rows.faces.size() == mesh.faces.size());
        CHECK(rows.positions.rowwise().sum().isApprox(mesh.positions.rowwise().sum()));
    }
}

TEST_CASE("What is too thin for its cells is refused, and says so") {
    const auto ring = std::make_shared<const Guide>(Surface(samples::torus(300, 8, 10, 0.01)));
    CHECK_THROWS_WITH(remesh(ring, of_cells(40)), Contains("smaller ones may"));
}

TEST_CASE("Even triangles keep topology and lie on the surface") {
    const Surface surface(samples::torus(40, 12, 3, 1));
    const SurfaceTree tree(surface);
    const Surface even = even_triangles(surface, tree, 0.3).surface;
    int short_or_long = 0;
    for (int s = 0; s < 3 * even.face_count(); ++s) {
        const double length = (even.positions().col(even.to(s)) - even.positions().col(even.from(s))).norm();
        short_or_long += length < 0.15 || length > 0.45 ? 1 : 0;
    }
    CHECK(short_or_long < 3 * even.face_count() / 50);
    CHECK(even.vertex_count() - even.face_count() / 2 == 0);
    for (int v = 0; v < even.vertex_count(); ++v) CHECK(tree.nearest(even.positions().col(v)).distance < 1e-9);
}

TEST_CASE("Even triangles keep creases, and the flat faces between them") {
    const Surface surface = cube();
    const SurfaceTree tree(surface);
    const std::vector<bool> creases = creases_of(surface, 40 * samples::k_degree);
    CHECK(std::count(creases.begin(), creases.end(), true) == 2 * 12);
    const EvenTriangles even = even_triangles(surface, tree, 0.07, creases);
    CHECK(even.surface.area() == Approx(6).epsilon(1e-12));
    double length = 0;
    for (int s = 0; s < 3 * even.surface.face_count(); ++s) {
        if (!even.creases[s]) continue;
        CHECK(even.creases[even.surface.opposite(s)]);
        const auto from = even.surface.positions().col(even.surface.from(s)),
                   to = even.surface.positions().col(even.surface.to(s));
        length += (to - from).norm() / 2;
        CHECK(((to - from).cwiseAbs().array() > 1e-9).count() == 1);
    }
    CHECK(length == Approx(12));
}

TEST_CASE("Net lines follow the creases of a box if they are asked to", "[large]") {
    const Surface box = stretched(cube(), {3, 1.7, 1.1});
    /// Mean over the box's edges of the way to the nearest edge of the net, in its edges.
    const auto off_creases = [&](const Net& net) {
        double sum = 0;
        int count = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 4; ++corner)
                for (double part = 0.02; part < 1; part += 0.02, ++count) {
                    Eigen::Vector3d at(3, 1.7, 1.1);
                    at[axis] *= part;
                    if (corner % 2 == 0) at[(axis + 1) % 3] = 0;
                    if (corner / 2 == 0) at[(axis + 2) % 3] = 0;
                    sum += distance_to_edges(net, at) / net.mean_length();
                }
        return sum / count;
    };
    RemeshOptions options = of_cells(800);
    const Remesh before = remeshed(box, options, 2);
    CHECK(off_creases(before.net) > 0.2);
    options.crease = 40 * samples::k_degree;
    const Remesh made = remeshed(box, options, 2);
    CHECK(off_creases(made.net) < 0.1);
    CHECK(made.singular.size() == 8);
    CHECK(corner_angle_range(made.net, made.net.rest_positions()).smallest > 75 * samples::k_degree);
}

/// Of unit squares in the plane, by their lower left corners.
Surface plate(const std::vector<std::array<int, 2>>& squares) {
    Mesh mesh;
    std::map<std::array<int, 2>, int> vertices;
    const auto vertex = [&](int i, int j) {
        const auto [place, is_new] = vertices.try_emplace({i, j}, static_cast<int>(vertices.size()));
        if (is_new) {
            mesh.positions.conservativeResize(3, place->second + 1);
            mesh.positions.col(place->second) << i, j, 0;
        }
        return place->second;
    };
    for (const auto& [i, j] : squares)
        mesh.faces.add(std::array{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    return Surface(mesh);
}

TEST_CASE("Flat plates of squares become squares, as many as fit between their corners", "[large]") {
    const Surface plates[] = {
        plate({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {0, 2}}),
        plate({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {2, 2}}),
        plate({{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 0}, {2, 0}, {1, 2}, {2, 2}, {1, 4}, {2, 4}}),
    };
    const int cells = GENERATE(600, 1230, 2900);
    for (const Surface& surface : plates) {
        const Net net = remeshed(surface, of_cells(cells), 1).net;
        CAPTURE(surface.area(), cells, net.face_count());
        CHECK(corner_angle_range(net, net.rest_positions()).smallest > 89 * samples::k_degree);
        CHECK(net.rest_positions().row(2).cwiseAbs().maxCoeff() < 1e-3 * net.mean_length());
        CHECK(std::abs(net.face_count() - cells) < 0.15 * cells);
    }
}

/// Closed, of radius and height 1.
Surface can() {
    constexpr int k_around = 48;
    Mesh mesh = samples::cylinder(k_around, 2, 0.5);
    for (const double z : {-0.5, 0.5}) {
        const auto middle = static_cast<int>(mesh.positions.cols());
        mesh.positions.conservativeResize(3, middle + 1);
        mesh.positions.col(middle) << 0, 0, z;
        std::vector<int> rim;
        for (int v = 0; v < middle; ++v)
            if (std::abs(mesh.positions(2, v) - z) < 1e-9 && mesh.positions.col(v).head<2>().norm() > 0.5)
                rim.push_back(v);
        REQUIRE(rim.size() == k_around);
        std::sort(rim.begin(), rim.end(), [&](int a, int b) {
            const auto angle = [&](int v) { return std::atan2(mesh.positions(1, v), mesh.positions(0, v)); };
            return angle(a) < angle(b);
        });
        for (int k = 0; k < k_around; ++k) {
            const int a = rim[k], b = rim[(k + 1) % k_around];
            mesh.faces.add(z > 0 ? std::array{a, b, middle} : std::array{b, a, middle});
        }
    }
    return Surface(mesh);
}

TEST_CASE("Sharp edges are followed where the net lies better so, and only there", "[large]") {
    RemeshOptions without = of_cells(800), fitting = without, along = without;
    fitting.tries_creases = true;
    along.crease = k_sharp_edge;
    const auto crumpled = [](const Surface& surface, const Remesh& made) {
        return crumpled_edges(Guide(surface), made.net);
    };
    const Surface box = stretched(cube(), {3, 1.7, 1.1});
    CHECK(crumpled(box, remeshed(box, without, 2)) > 0);
    const Remesh on_box = remeshed(box, fitting, 2);
    CHECK(crumpled(box, on_box) == 0);
    CHECK(on_box.net.rest_positions() == remeshed(box, along, 2).net.rest_positions());

    // The rim of a can is longer than a row of cells beside it has room for.
    const Surface round = can();
    const Remesh on_can = remeshed(round, fitting, 2);
    CHECK(crumpled(round, on_can) < crumpled(round, remesh(std::make_shared<const Guide>(round), along)));
    CHECK(on_can.net.rest_positions() == remeshed(round, without, 2).net.rest_positions());

    const Surface smooth(samples::torus(48, 24, 2, 0.8));
    CHECK(remeshed(smooth, fitting, 0).net.rest_positions() == remeshed(smooth, without, 0).net.rest_positions());
}

TEST_CASE("Net lines follow creases that meet at 60 degrees as near as equal edges allow") {
    Mesh mesh;
    mesh.positions.resize(3, 6);
    const double height = std::sqrt(3.0) / 2;
    mesh.positions << 0, 1, 0.5, 0, 1, 0.5, 0, 0, height, 0, 0, height, 0, 0, 0, 2, 2, 2;
    for (const std::vector<int>& face :
         std::vector<std::vector<int>>{{2, 1, 0}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}})
        mesh.faces.add(face);
    const Surface prism(mesh);
    RemeshOptions options = of_cells(500);
    options.crease = 40 * samples::k_degree;
    const Remesh made = remeshed(prism, options, 2);
    double sum = 0;
    int count = 0;
    for (int s = 0; s < 3 * prism.face_count(); ++s) {
        if (!creases_of(prism, options.crease)[s]) continue;
        const Eigen::Vector3d from = prism.positions().col(prism.from(s)), to = prism.positions().col(prism.to(s));
        for (double part = 0.02; part < 1; part += 0.02, ++count)
            sum += distance_to_edges(made.net, (1 - part) * from + part * to);
    }
    CHECK(sum / count < 0.35 * made.net.mean_length());
    // At the six corners, and within each of the triangles.
    CHECK(made.singular.size() == 8);
}

TEST_CASE("Creases that a surface does not have change nothing of its net", "[large]") {
    const Surface round = disc();
    RemeshOptions options = of_cells(300);
    const Net plain = remeshed(round, options, 1).net;
    options.crease = 40 * samples::k_degree;
    const Net net = remeshed(round, options, 1).net;
    CHECK(net.rest_positions() == plain.rest_positions());
    CHECK(net.edges() == plain.edges());
}

TEST_CASE("The border of a plate is a net line from corner to corner, whatever its shape") {
    const Surface rectangle = plate(17, 6, 3.3, 1.2, [](double, double) { return true; });
    const Net straight = remeshed(rectangle, of_cells(400), 1).net;
    CHECK(singular_count(straight) == 0);
    CHECK(border_corners(straight) == std::map<int, int>{{2, 4}});
    CHECK(off_border(rectangle, straight) < 0.15);

    const Surface angle = plate(20, 20, 2, 2, [](double x, double y) { return x < 0.9 || y < 0.7; });
    const Net bent = remeshed(angle, of_cells(700), 1).net;
    CHECK(singular_count(bent) == 0);
    CHECK(border_corners(bent) == std::map<int, int>{{2, 5}, {4, 1}});
    CHECK(off_border(angle, bent) < 0.2);
}

TEST_CASE("A net with one net line for its border has singular vertices within, as many as its border turns",
          "[large]") {
    const Surface round = disc();
    RemeshOptions options = of_cells(400);
    options.border = RemeshOptions::Border::always;
    const Net made = remeshed(round, options, 1).net;
    CHECK(border_corners(made).empty());
    CHECK(Topology(made).singular_vertices() == std::map<int, int>{{3, 4}});
    CHECK(off_border(round, made) < 0.6);
    // One that ends in steps goes without them.
    options.border = RemeshOptions::Border::never;
    const Net stepped = remeshed(round, options, 1).net;
    CHECK(singular_count(stepped) == 0);
    CHECK(off_border(round, stepped) < 0.6);

    const Surface half = Surface(samples::sphere(16, true));
    options = of_cells(500);
    options.border = RemeshOptions::Border::always;
    CHECK(border_corners(remeshed(half, options, 1).net).empty());
}

/// A plate with a round hole, raised to a vault.
Surface roof_with_hole(double rise) {
    const Surface flat = plate(60, 40, 6, 4, [](double x, double y) { return std::hypot(x - 3.4, y - 1.8) > 0.7; });
    Mesh mesh{flat.positions(), {}};
    for (int v = 0; v < flat.vertex_count(); ++v)
        mesh.positions(2, v) = rise * std::sin(std::numbers::pi / 6 * flat.positions()(0, v));
    for (int f = 0; f < flat.face_count(); ++f)
        mesh.faces.add({flat.from(3 * f), flat.from(3 * f + 1), flat.from(3 * f + 2)});
    return Surface(mesh);
}

TEST_CASE("A net over a roof with a hole has its lines along the roof's sides, not along the hole", "[large]") {
    for (const double rise : {0.0, 0.8}) {
        const Surface roof = roof_with_hole(rise);
        const Net net = remeshed(roof, of_cells(500), 0).net;
        INFO("rise " << rise);
        CHECK(singular_count(net) == 0);
        CHECK(corner_angle_range(net, net.rest_positions()).smallest > 60 * samples::k_degree);
        CHECK(measure_drape(roof, SurfaceTree(roof), net).coverage > 0.99);
        const Topology topology(net);
        std::vector<std::vector<int>> loops = topology.boundary_loops();
        const auto outer = std::max_element(loops.begin(), loops.end(),
                                            [](const auto& a, const auto& b) { return a.size() < b.size(); });
        std::map<int, int> corners;
        for (const int v : *outer)
            if (topology.valence(v) != 3) ++corners[topology.valence(v)];
        CHECK(corners == std::map<int, int>{{2, 4}});
    }
}

TEST_CASE("The outer border is the longest of a piece, and what is about as long") {
    const Surface roof = roof_with_hole(0);
    const std::vector<bool> outer = outer_border_sides(roof);
    for (int s = 0; s < 3 * roof.face_count(); ++s) {
        const double x = roof.positions()(0, roof.from(s)), y = roof.positions()(1, roof.from(s));
        const bool is_outside = std::min({x, 6 - x, y, 4 - y}) < 1e-9;
        CHECK(outer[s] == (roof.opposite(s) < 0 && is_outside));
    }
    const Surface tube(samples::quads(12, 5, true, false, [](int i, int j) {
        return Eigen::Vector3d(std::cos(std::numbers::pi / 6 * i), std::sin(std::numbers::pi / 6 * i), 0.4 * j);
    }));
    CHECK(outer_border_sides(tube) == border_sides(tube));
}

TEST_CASE("A field is as straight as the border of a flat plate, also between inward corners") {
    const Surface angle = plate(20, 20, 2, 2, [](double x, double y) { return x < 0.9 || y < 0.7; });
    const DirectionField field = smoothest_field(angle, {});
    for (const auto& direction : field.directions.colwise())
        CHECK(std::min(std::abs(direction.x()), std::abs(direction.y())) < 1e-6);
}

TEST_CASE("A field along the outer border alone goes around a hole without singular vertices") {
    // Between a circle and a square.
    const Surface flat(samples::quads(64, 12, true, false, [](int i, int j) {
        const Eigen::Vector3d circle = {std::cos(std::numbers::pi / 32 * i), std::sin(std::numbers::pi / 32 * i), 0};
        const Eigen::Vector3d square = 2 / circle.cwiseAbs().maxCoeff() * circle;
        return Eigen::Vector3d(circle * 0.7 * (11 - j) / 11 + square * j / 11);
    }));
    CHECK(chebnet::singular_count(smoothest_field(flat, {})) == 4);
    CHECK(chebnet::singular_count(smoothest_field(flat, {0, nullptr, {}, outer_border_sides(flat)})) == 0);

    // A dome's curvature leaves by the hole at its top, if nowhere else.
    const Surface dome(samples::quads(48, 12, true, false, [](int i, int j) {
        const double around = std::numbers::pi / 24 * i, down = 0.3 + 0.1 * j;
        return Eigen::Vector3d(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down));
    }));
    const std::vector<bool> outer = outer_border_sides(dome);
    REQUIRE(outer != border_sides(dome));
    SingularWishes wishes;
    wishes.only = true;
    const PlacedWishes none = WishPlacer(dome, 0.1).placed(wishes, SurfaceTree(dome));
    const DirectionField field = smoothest_field(dome, {0, &none, {}, outer});
    CHECK(chebnet::singular_count(field) == 0);
    for (int s = 0; s < 3 * dome.face_count(); ++s) {
        if (!outer[s]) continue;
        const Eigen::Vector3d along =
            (dome.positions().col(dome.to(s)) - dome.positions().col(dome.from(s))).normalized();
        const double cosine = along.dot(field.directions.col(Surface::face_of(s)));
        CHECK(std::max(cosine * cosine, 1 - cosine * cosine) > 0.9);
    }
}

TEST_CASE("Where a net line along the border would strain the net it is there only if it is asked for", "[large]") {
    const Surface shell = make_own_surface("shell");
    RemeshOptions options = of_cells(600);
    const Net fitting = remeshed(shell, options, 1).net;
    CHECK(border_corners(fitting).at(2) > 4);
    options.border = RemeshOptions::Border::always;
    const Net always = remeshed(shell, options, 1).net;
    CHECK(border_corners(always) == std::map<int, int>{{2, 4}});
    CHECK(off_border(shell, always) < off_border(shell, fitting));
}

TEST_CASE("A ring far longer outside than inside is cut from a flat net, or covered at 45 degrees to its borders",
          "[large]") {
    const Surface ring(samples::quads(80, 12, true, false, [](int i, int j) {
        const double angle = 2 * std::numbers::pi * i / 80, radius = 1 + 0.8 * j / 11;
        return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
    }));
    const Guide guide(ring);
    const auto coverage = [&](const Net& net) { return measure_drape(ring, guide.tree(), net).coverage; };
    RemeshOptions options = of_cells(600);
    const Net fitting = remeshed(ring, options, 0).net;
    CHECK(singular_count(fitting) == 0);
    CHECK(coverage(fitting) > 0.995);
    CHECK(corner_angle_range(fitting, fitting.rest_positions()).smallest > 89 * samples::k_degree);
    options.border = RemeshOptions::Border::across;
    const Net across = remeshed(ring, options, 0).net;
    CHECK(singular_count(across) == 0);
    CHECK(coverage(across) > 0.995);
    CHECK(off_border(ring, across) < 0.4);
    options.border = RemeshOptions::Border::always;
    CHECK(coverage(remesh(std::make_shared<const Guide>(ring), options).net) < 0.95);
}

TEST_CASE("A tower gets so many cells around that they are sheared alike where it is widest and narrowest", "[large]") {
    // The radius from −1 to 1 along the axis: a hyperboloid's, wide above and below, and a cone's.
    const auto hyperboloid = [](double t) { return std::cosh(1.5 * t); };
    const auto cone = [](double t) { return 2 + t; };
    for (const std::function<double(double)>& radius : {std::function<double(double)>(hyperboloid), {cone}}) {
        const Surface tower(samples::quads(64, 40, true, false, [&](int i, int j) {
            const double t = 2 * j / 39. - 1, u = 2 * std::numbers::pi * i / 64;
            return Eigen::Vector3d(radius(t) * std::cos(u), radius(t) * std::sin(u), 3 * t);
        }));
        const auto guide = std::make_shared<const Guide>(tower);
        RemeshOptions options;
        options.cells = 800;
        const Remesh made = remesh(guide, options);
        const DrapeReport report = measure_drape(guide->surface(), guide->tree(), made.net);
        CHECK(made.singular.empty());
        CHECK(std::abs(made.net.face_count() - 800) < 0.05 * 800);
        CHECK(report.coverage > 0.999);
        CHECK(report.gaps == 0);
        CHECK(report.mean_distance < 0.01 * report.length);
        CHECK(report.largest_distance < 0.3 * report.length);
        // As many edges of one length are around both: sines of half the angles above them are as the radii.
        const double ratio = radius(1) / std::min(radius(0), radius(-1));
        CHECK(report.smallest_angle > 0.8 * 2 * std::atan(1 / ratio));
    }
}

TEST_CASE("A ring is neither sheared nor crumpled for what singular vertices do better", "[large]") {
    // A pseudosphere, from its rim to where it is a quarter as wide: closed, half of its cells would be sheared much.
    const Surface horn(samples::quads(64, 40, true, false, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 64, t = 2 * j / 39.;
        return Eigen::Vector3d(std::cos(u) / std::cosh(t), std::sin(u) / std::cosh(t), t - std::tanh(t));
    }));
    const auto guide = std::make_shared<const Guide>(horn);
    for (const int cells : {400, 700}) {
        const Net net = remesh(guide, of_cells(cells)).net;
        const DrapeReport report = measure_drape(horn, guide->tree(), net);
        CHECK(report.much_sheared < 0.2);
        CHECK(report.coverage > 0.99);
        CHECK(crumpled_edges(*guide, net) == 0);
    }
}

TEST_CASE("A tube is not drawn out where its cells may shear: they stay as square as they can be", "[large]") {
    // Unrolled it is flat: squares fit all of it but its upper border, which is at a slant.
    const Surface tube(samples::quads(48, 33, true, false, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 48;
        return Eigen::Vector3d(std::cos(u), std::sin(u), j / 32. * (4 + 0.8 * std::cos(u)));
    }));
    RemeshOptions options = of_cells(2500);
    options.border = RemeshOptions::Border::across;
    const Net net = remeshed(tube, options, 0).net;
    CHECK(part_sheared(net, 25 * samples::k_degree) < 0.1);
}

TEST_CASE("A body whose net without singular vertices would crumple gets one with them, whatever small nets promise",
          "[large]") {
    // A torus three times as long outside as inside, which leaves hardly any room for other numbers of cells around.
    const Surface torus(samples::quads(72, 36, true, true, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 72, v = 2 * std::numbers::pi * j / 36;
        return Eigen::Vector3d((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
    }));
    const auto guide = std::make_shared<const Guide>(torus);
    CHECK(crumpled_edges(*guide, remesh(guide, of_cells(1700)).net) == 0);
}

TEST_CASE("What promises only nets with edges of many lengths is given up before one is fitted") {
    const auto sides_of = [](double above) {
        const auto point = [above](int i, int j) {
            const double u = 2 * std::numbers::pi * i / 40, radius = 1 + (above - 1) * j / 12.;
            return Eigen::Vector3d(radius * std::cos(u), radius * std::sin(u), j / 4.);
        };
        return std::make_shared<const Guide>(Surface(samples::quads(40, 13, true, false, point)));
    };
    RemeshOptions options = of_cells(300);
    options.border = RemeshOptions::Border::always;
    CHECK(!remesh_if_even(sides_of(3), options, 0.1, {}));
    CHECK(remesh_if_even(sides_of(1.05), options, 0.1, {}));
}

TEST_CASE("A disc with more curvature than a net can take is left open where the net would lock, rather than folded",
          "[large]") {
    // A saddle as steep as 70 degrees: net lines along its border, across it and in steps all crumple.
    const Surface saddle(samples::graph(41, 1, [](double x, double y) { return 1.5 * (x * x - y * y); }));
    const Guide guide(saddle);
    RemeshOptions options = of_cells(800);
    const Net net = remesh(std::make_shared<const Guide>(saddle), options).net;
    const DrapeReport report = measure_drape(saddle, guide.tree(), net);
    CHECK(report.folds == 0);
    CHECK(report.coverage > 0.9);
    CHECK(report.smallest_angle > options.smallest_angle - 1e-3);
    options.border = RemeshOptions::Border::across;
    const Net across = remesh(std::make_shared<const Guide>(saddle), options).net;
    CHECK(measure_drape(saddle, guide.tree(), across).folds > 10);
}

TEST_CASE("A hole that is smaller than a cell is covered, and a larger one stays open") {
    const Surface small(samples::without(samples::sphere(12), [](const auto& p) { return p.z() > 0.98; }));
    const Surface large(samples::sphere(12, true));
    const std::vector<std::vector<int>> loops = small.boundary_loops();
    REQUIRE(loops.size() == 1);
    double around = 0;
    for (const int s : loops[0])
        around += (small.positions().col(small.to(s)) - small.positions().col(small.from(s))).norm();
    CHECK(!without_pinholes(small, 0.999 * around));
    const std::optional<Surface> closed = without_pinholes(small, 1.001 * around);
    REQUIRE(closed);
    CHECK(closed->euler_characteristic() == 2);
    CHECK(closed->boundary_loops().empty());
    CHECK(closed->positions().leftCols(small.vertex_count()) == small.positions());
    // What closes it is wound as the rest: its normal shows out.
    CHECK(closed->normal_at({closed->face_count() - 1, Eigen::Vector3d::Constant(1. / 3)}).z() > 0.9);
    const double cells = 4 * std::numbers::pi * std::pow(3.5 / around, 2);  // so that it is smaller than one of them
    const Net net = remesh(std::make_shared<const Guide>(small), of_cells(cells)).net;
    CHECK(Topology(net).boundary_loops().empty());
    CHECK(net.vertex_count() - net.edge_count() + net.face_count() == 2);
    CHECK(!without_pinholes(large, 1.001 * around));
}

TEST_CASE("The border around a piece that is smaller than a cell is none of a hole") {
    // A square of cells of length 0.5 nearly, and a scrap of it.
    const Surface both(beside(samples::plane(11, 5), samples::plane(3, 0.245), {7, 0, 0}));
    CHECK(!without_pinholes(both, 2));
    const Net net = remesh(std::make_shared<const Guide>(both), of_cells(400)).net;
    CHECK(Topology(net).component_count() == 2);
    CHECK(Topology(net).boundary_loops().size() == 2);
}

TEST_CASE("The distance of borders is measured between them, whatever lies within") {
    const auto square = [](double height) {
        return samples::graph(
            6, 1, [=](double x, double y) { return std::max(std::abs(x), std::abs(y)) > 0.99 ? height : 5; });
    };
    const Mesh lifted = square(0.25);
    const Net net(lifted.positions, lifted.faces, RestLengths::own);
    CHECK(border_distance(Surface(square(0)), net) == Approx(0.25));
    CHECK(border_distance(Surface(samples::sphere(4)), net) == 0);
}

TEST_CASE("Without a limit of corners a net in one piece is tried as well") {
    const Surface hill(samples::graph(21, 1, [](double x, double y) { return 0.8 * std::exp(-4 * (x * x + y * y)); }));
    const SurfaceTree tree(hill);
    for (const double limit : {0.0, 1e-4}) {
        const std::optional<Net> net = one_piece(hill, tree, 100, 0, limit);
        REQUIRE(net);
        CHECK(net->face_count() > 80);
    }
}

TEST_CASE("Ways to end at a border are tried first, and then a net is made once", "[large]") {
    const auto guide = std::make_shared<const Guide>(
        Surface(samples::graph(33, 1, [](double x, double y) { return 0.5 * std::cos(2 * x) * std::cos(3 * y); })));
    std::vector<RemeshPhase> phases;
    double before = 0;
    const Net net = remesh(guide, of_cells(1600), [&](RemeshPhase phase, double done) {
                        if (phases.empty() || phases.back() != phase) phases.push_back(phase);
                        if (phase == RemeshPhase::border) CHECK(done >= before);
                        if (phase == RemeshPhase::border) before = done;
                    }).net;
    CHECK(phases == std::vector{RemeshPhase::border, RemeshPhase::triangles, RemeshPhase::singular, RemeshPhase::field,
                                RemeshPhase::grid, RemeshPhase::fit});
    CHECK(before > 0.9);
}

TEST_CASE("Net lines at 45 degrees to the border go along creases none the less") {
    // A roof, with its ridge in the middle.
    const Surface roof(samples::graph(21, 1, [](double x, double) { return -std::abs(x); }));
    RemeshOptions options = of_cells(400);
    options.border = RemeshOptions::Border::across;
    options.crease = 60 * samples::k_degree;
    const Net net = remeshed(roof, options, 1).net;
    for (const double y : {-0.7, -0.2, 0.3, 0.6}) CHECK(distance_to_edges(net, {0, y, 0}) < 0.25 * net.mean_length());
}

TEST_CASE("Creases, borders and singular vertices wished for go together") {
    // Half a box, without its lid: creases end at the border.
    const Surface whole = cube();
    Mesh open{whole.positions(), {}};
    for (int f = 0; f < whole.face_count(); ++f)
        if (whole.face_normals()(2, f) < 0.5)
            open.faces.add({whole.triangles()(0, f), whole.triangles()(1, f), whole.triangles()(2, f)});
    RemeshOptions options = of_cells(500);
    options.crease = 40 * samples::k_degree;
    options.singular.vertices = {{{0, 0, 0}, 3}, {{1, 1, 0}, 3}};
    const Remesh made = remeshed(Surface(open), options, 1);
    CHECK(made.kept.missed() == 0);
    CHECK(Topology(made.net).boundary_loops().size() == 1);
}

TEST_CASE("A field on a sphere has the holonomy of its curvature") {
    const DirectionField field = smoothest_field(Surface(samples::sphere(12)), {});
    CHECK(chebnet::singular_count(field) == 8);
}

TEST_CASE("A field that is turned as a whole stays in the triangles' planes, and as smooth") {
    const Surface surface(samples::sphere(12));
    const DirectionField field = smoothest_field(surface, {});
    const double angle = 0.3;
    const DirectionField other = turned(surface, field, angle);
    for (int f = 0; f < surface.face_count(); ++f) {
        CHECK(other.directions.col(f).dot(field.directions.col(f)) == Approx(std::cos(angle)));
        CHECK(std::abs(other.directions.col(f).dot(surface.face_normals().col(f))) < 1e-12);
    }
    CHECK(other.turns == field.turns);
    CHECK(other.holonomy == field.holonomy);
}

TEST_CASE("A fitter of grids makes the same along a field that is turned as if it were made for that alone") {
    const Surface surface(samples::sphere(12));
    const DirectionField field = smoothest_field(surface, {});
    const GridFitter fitted = grid_fitter(surface, field);
    const double sheared = 50 * samples::k_degree;
    for (const auto& [angle, smallest_angle] : {std::pair(0.0, sheared), {0.3, std::numbers::pi / 2}, {0.6, sheared}}) {
        CAPTURE(angle);
        const DirectionField other = turned(surface, field, angle);
        const GridMap map = fitted(other, 0.2, smallest_angle);
        const GridMap alone = fit_grid(surface, other, 0.2, 0, {}, smallest_angle);
        CHECK(map.corners == alone.corners);
        CHECK(map.shifts == alone.shifts);
    }
}

TEST_CASE("Eight singular vertices wished for at a cube's corners give a sphere the cube's pattern, and no others") {
    RemeshOptions options = of_cells(400);
    options.singular.only = true;
    for (const double x : {-1, 1})
        for (const double y : {-1, 1})
            for (const double z : {-1, 1})
                options.singular.vertices.push_back({Eigen::Vector3d(x, y, z) / std::sqrt(3.0), 3});
    const Remesh made = remeshed(Surface(samples::sphere(16)), options, 2);
    CHECK(made.kept.missed() == 0);
    REQUIRE(made.singular.size() == 8);
    for (const double distance : made.kept.distances) CHECK(distance < 1);
    // Along each of the cube's twelve edges a net line goes from corner to corner: all are as long.
    const Topology topology(made.net);
    std::vector<std::size_t> between;
    for (const std::vector<int>& line : topology.net_lines()) {
        const auto is_singular = [&](int v) { return topology.valence(v) == 3; };
        if (is_singular(line.front()) && is_singular(line.back())) between.push_back(line.size());
    }
    CHECK(between.size() == 12);
    CHECK(*std::max_element(between.begin(), between.end()) - *std::min_element(between.begin(), between.end()) <= 1);
}

TEST_CASE("A singular vertex wished for stands where it is wished for, and takes its turn from the others", "[large]") {
    for (const int valence : {3, 5, 6}) {
        CAPTURE(valence);
        RemeshOptions options = of_cells(400);
        const Eigen::Vector3d point(0, 0.6, 0.8);
        options.singular.vertices = {{point, valence}};
        const Remesh made = remeshed(Surface(samples::sphere(16)), options, 2);
        CHECK(made.kept.vertices == std::vector{true});
        int there = 0;
        for (const SingularVertex& singular : made.singular)
            there += singular.valence == valence && (singular.position - point).norm() < made.net.mean_length() ? 1 : 0;
        CHECK(there == 1);
    }
}

TEST_CASE("In a forbidden region there is no singular vertex", "[large]") {
    const Surface sphere(samples::sphere(16));
    const Remesh before = remeshed(sphere, of_cells(400), 2);
    RemeshOptions options = of_cells(400);
    const double radius = 4 * before.net.mean_length();
    for (const int k : {0, 4}) options.singular.forbidden.push_back({before.singular[k].position, radius});
    const Remesh made = remeshed(sphere, options, 2);
    CHECK(made.kept.intruders == std::vector{0, 0});
    for (const SingularVertex& singular : made.singular)
        for (const ForbiddenRegion& region : options.singular.forbidden)
            CHECK((singular.position - region.centre).norm() >= radius);
}

TEST_CASE("A torus for which no singular vertices are wished gets none") {
    RemeshOptions options = of_cells(500);
    options.singular.only = true;
    const Remesh made = remeshed(Surface(samples::torus(80, 20, 3, 0.6)), options, 0);
    CHECK(made.singular.empty());
    CHECK(made.kept.missed() == 0);
}

TEST_CASE("With singular vertices wished for the turns of a field still add up to its Euler characteristic") {
    const Surface sphere(samples::sphere(24));
    const SurfaceTree tree(sphere);
    SingularWishes wishes;
    wishes.vertices = {{{1, 0, 0}, 3}, {{0, 1, 0}, 5}, {{0, 0, 1}, 6}};
    wishes.forbidden = {{{-1, 0, 0}, 0.6}};
    const PlacedWishes on_triangles = WishPlacer(sphere, 0.08).placed(wishes, tree);
    const DirectionField field = smoothest_field(sphere, {0, &on_triangles, {}, {}});
    int sum = 0;
    for (int v = 0; v < sphere.vertex_count(); ++v) {
        // 3 quarter turns are −1; only the one of valence 6 is −2.
        const int turns = field.holonomy[v];
        sum += turns == 1 ? 1 : turns == 3 ? -1 : -turns;
        if (turns != 0) CHECK((sphere.positions().col(v) - wishes.forbidden[0].centre).norm() > 0.6);
    }
    CHECK(sum == 8);
    for (const PlacedWishes::Pin& pin : on_triangles.pins) CHECK(field.holonomy[pin.vertex] == (pin.index + 4) % 4);
}

TEST_CASE("A singular vertex wished for stays on its piece and its side of a surface, however thin that is") {
    // A flat box, thinner than its triangles are wide, and above it a sheet, nearer still.
    const double thickness = 0.02;
    Mesh mesh = samples::plane(10, 1);
    const Mesh sheet = mesh;
    const auto add = [&](double height, bool is_turned, double shift) {
        const auto first = static_cast<int>(mesh.positions.cols());
        mesh.positions.conservativeResize(3, first + sheet.positions.cols());
        mesh.positions.rightCols(sheet.positions.cols()) = sheet.positions;
        mesh.positions.rightCols(sheet.positions.cols()).row(0).array() += shift;
        mesh.positions.rightCols(sheet.positions.cols()).row(2).array() += height;
        for (int f = 0; f < sheet.faces.size(); ++f) {
            std::vector<int> face(sheet.faces[f].begin(), sheet.faces[f].end());
            for (int& v : face) v += first;
            if (is_turned) std::reverse(face.begin(), face.end());
            mesh.faces.add(face);
        }
    };
    add(thickness, false, 0.04);
    add(2 * thickness, true, 0.02);
    const Surface surface(mesh);
    const SurfaceTree tree(surface);
    const WishPlacer placer(surface, 0.2);
    for (const double height : {0.0, thickness, 2 * thickness}) {
        CAPTURE(height);
        for (const double x : {0.0, 0.02, 0.04, 0.06}) {
            SingularWishes wishes;
            wishes.vertices = {{{x, 0, height}, 3}};
            const PlacedWishes placed_there = placer.placed(wishes, tree);
            CHECK(surface.positions()(2, placed_there.pins[0].vertex) == height);
        }
    }
}

TEST_CASE("What was not kept is said, wish by wish") {
    const Net net = remesh(std::make_shared<const Guide>(make_own_surface("pebble")), of_cells(200)).net;
    const std::vector<SingularVertex> singular = singular_vertices(net);
    SingularWishes wishes;
    wishes.vertices = {{singular[0].position, 3}, {singular[0].position, 3}, {{0, 0, 0}, 6}};
    wishes.forbidden = {{singular[1].position, 1e-6}, {singular[1].position + Eigen::Vector3d(0, 0, 100), 1}};
    wishes.only = true;
    const KeptWishes kept = kept_wishes(net, singular, wishes);
    CHECK(kept.vertices == std::vector{true, false, false});
    CHECK(kept.distances[0] == 0);
    CHECK(kept.distances[2] == -1);
    CHECK(kept.intruders == std::vector{1, 0});
    CHECK(kept.others == std::ssize(singular) - 1);
    CHECK(kept.missed() == 4);
    const std::vector<std::string> sentences = unkept_wishes(wishes, kept);
    REQUIRE(sentences.size() == 4);
    CHECK_THAT(sentences[0], Contains("the nearest stands"));
    CHECK_THAT(sentences[1], Contains("valence 6") && Contains("has not come about"));
    CHECK_THAT(sentences[2], Contains("forbidden region"));
    CHECK_THAT(sentences[3], Contains("where none were wished for"));
}

TEST_CASE("Wishes that cannot be kept are refused, with what is missing") {
    const auto refusal = [](const Guide& surface, const SingularWishes& wishes) {
        return [&surface, wishes] { check_wishes(surface, wishes); };
    };
    const Guide sphere(Surface(samples::sphere(8)));
    const Guide hypar(make_own_surface("hypar"));
    const WishedSingular at_top{{0, 0, 1}, 3};
    CHECK_THROWS_WITH(refusal(sphere, {{at_top}, {}, true})(), Contains("7 more of valence 3 are missing"));
    CHECK_THROWS_WITH(refusal(sphere, {{9, at_top}, {}, true})(), Contains("1 more of valence 5 is missing"));
    const Guide spheres(Surface(beside(samples::sphere(4), samples::sphere(4), {3, 0, 0})));
    CHECK_THROWS_WITH(refusal(spheres, {{}, {}, true})(), Contains("piece 1 of the surface: 8 more"));
    CHECK_NOTHROW(refusal(hypar, {{at_top}, {}, true})());
    CHECK_THROWS_WITH(refusal(sphere, {{{{0, 0, 1}, 4}}, {}, false})(), Contains("valence 4; it must be 3, 5 or 6"));
    CHECK_THROWS_WITH(refusal(sphere, {{{{0, 0, NAN}, 3}}, {}, false})(), Contains("finite"));
    CHECK_THROWS_WITH(refusal(sphere, {{}, {{{0, 0, 1}, 0}}, false})(), Contains("radius"));
    CHECK_THROWS_WITH(refusal(sphere, {{}, {{{0, 0, 1}, INFINITY}}, false})(), Contains("finite"));
    CHECK_THROWS_WITH(refusal(sphere, {{at_top}, {{{0, 0, 1.1}, 0.3}}, false})(), Contains("stands in the forbidden"));
    CHECK_THROWS_WITH(refusal(sphere, {std::vector(601, at_top), {}, false})(), Contains("no more than 600"));

    RemeshOptions options = of_cells(400);
    options.singular.vertices = std::vector(40, at_top);
    CHECK_THROWS_WITH(remesh(std::make_shared<const Guide>(Surface(samples::sphere(8))), options),
                      Contains("no place of its own"));
}

TEST_CASE("Why there is no net is said of the cells asked for, not of the larger ones that ways were tried with",
          "[large]") {
    // Wishes that have places of their own between cells as small as asked for only, and others that never have.
    RemeshOptions options = of_cells(6000);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 12; ++j) options.singular.vertices.push_back({{-0.5 + 0.03 * i, 0.03 * j, 0}, 5});
    const WishedSingular never{{0.5, 0.5, 0}, 5};
    options.singular.vertices.insert(options.singular.vertices.end(), 40, never);
    CHECK_THROWS_WITH(remesh(std::make_shared<const Guide>(Surface(samples::plane(41, 1))), options),
                      Contains("at 0.5 0.5 0 has no place"));
}

TEST_CASE("A map that folds over still gives quads without gaps") {
    const Surface plane(samples::plane(9, 1));
    const DirectionField field = smoothest_field(plane, {});
    GridMap map = fit_grid(plane, field, 0.3);
    std::mt19937 random(3);
    std::vector<GridPoint> moved(static_cast<std::size_t>(plane.vertex_count()), GridPoint{});
    for (int v = 0; v < plane.vertex_count(); ++v)
        if (!plane.is_boundary(v))
            for (std::int64_t& part : moved[v])
                part = 2 * (static_cast<std::int64_t>(random() % (2 * k_cell)) - k_cell);
    for (int s = 0; s < 3 * plane.face_count(); ++s)
        for (int axis = 0; axis < 2; ++axis) {
            map.corners[s][axis] += moved[plane.from(s)][axis];
            if (map.corners[s][axis] % (k_cell / 2) == 0) ++map.corners[s][axis];
        }
    const Cells cells = cells_of(plane, map);
    CHECK(cells.size() > 50);
    for (int s = 0; s < 4 * cells.size(); ++s)
        if (cells.opposite[s] >= 0) CHECK(cells.opposite[cells.opposite[s]] == s);
}

TEST_CASE("Integer solutions of conditions are found, all of them") {
    // x + 2 y = 3 z and x = y: all multiples of (1, 1, 1).
    const Eigen::MatrixXi basis = integer_null_space(3, {{{{0, 1}, {1, 2}, {2, -3}}}, {{{0, 1}, {1, -1}}}});
    REQUIRE(basis.cols() == 1);
    CHECK(basis.cwiseAbs() == Eigen::Vector3i(1, 1, 1));
    // 2 x = 3 y: multiples of (3, 2), not of fractions of it.
    const Eigen::MatrixXi other = integer_null_space(2, {{{{0, 2}, {1, -3}}}});
    REQUIRE(other.cols() == 1);
    CHECK(other.cwiseAbs() == Eigen::Vector2i(3, 2));
}

TEST_CASE("Integers are rounded together") {
    // The least of (x − y − 1)² + (0.1 x − 0.04)² + …: x alone would be rounded to 0, and y follows.
    Eigen::Matrix2d A;
    A << 2.02, -2, -2, 2.02;
    CHECK(nearest_integers(A, Eigen::Vector2d(-2.008, 2)) == Eigen::Vector2i(1, 0));
}

TEST_CASE("A surface thousands of times as long as wide is refused, and soon") {
    // Fourteen triangles of hardly any area, whose edges are a million cells long.
    const Surface thread(
        samples::quads(8, 2, false, false, [](int i, int j) { return Eigen::Vector3d(i, 1e-12 * j, 0); }));
    CHECK_THROWS_WITH(remesh(std::make_shared<const Guide>(thread), of_cells(100)), Contains("thin"));
}

TEST_CASE("Where the grid is stretched beyond measure no lines are counted, of which there would be billions") {
    // A ring as thin as a thread, of which one point has been pulled to the middle, and another to its plane.
    Mesh ring = samples::torus(8, 4, 1, 3.7435515245435452e-11);
    ring.positions.col(0).setZero();
    ring.positions(2, 13) = 0;
    RemeshOptions options = of_cells(56);
    options.smoothing = 10;
    options.smallest_angle = 0;
    options.border = RemeshOptions::Border::always;
    CHECK_THROWS_WITH(remesh(std::make_shared<const Guide>(Surface(ring)), options), Contains("stretched"));
}

TEST_CASE("Numbers out of range are refused") {
    const Guide surface(make_own_surface("hypar"));
    const auto refusal = [&](auto change) {
        RemeshOptions options;
        change(options);
        return [&surface, options] { check_remesh(surface, options); };
    };
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.cells = 19; })(), Contains("at least 20"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.cells = 100'001; })(), Contains("more than 100000"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.length = -1; })(), Contains("positive"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.length = NAN; })(), Contains("finite"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.length = 100; })(), Contains("too long"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.smallest_angle = 2; })(), Contains("shear limit"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.crease = 4; })(), Contains("angle of creases"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.smoothing = 101; })(), Contains("smoothing"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.fewest = o.singular.only = true; })(), Contains("either"));
    for (const double unit : {1e-25, 1e25})
        CHECK_THROWS_WITH(check_remesh(Guide(scaled(surface.surface(), unit)), {}), Contains("scale it"));
}

TEST_CASE("A surface of any size that bodies have gets the same net") {
    const Surface sphere(samples::sphere(12));
    const Net net = remeshed(sphere, of_cells(200), 2).net;
    for (const double unit : {1e-12, 1e12})
        CHECK(remeshed(scaled(sphere, unit), of_cells(200), 2).net.face_count() == net.face_count());
}
