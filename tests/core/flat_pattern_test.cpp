#include "fabricate/flat_pattern.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "constants.h"
#include "drape/drape.h"
#include "io/obj.h"
#include "net/measures.h"
#include "net/rods.h"
#include "sample_drapes.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "shapes/shapes.h"
#include "surface/gallery.h"

using namespace chebnet;

namespace {

using Reason = PatternFault::Reason;

Net net_of(const std::string& obj) {
    Mesh mesh = read_obj(obj, "test");
    return Net(std::move(mesh.positions), std::move(mesh.faces));
}

/// Five squares around one boundary vertex: the fifth would lie upon the first.
Net winding_stair() {
    Positions positions(3, 12);
    Faces faces;
    for (int v = 0; v < 12; ++v) positions.col(v) << v, v * v, 0;
    for (int i = 0; i < 5; ++i) faces.add({0, 1 + 2 * i, 2 + 2 * i, 3 + 2 * i});
    return Net(std::move(positions), std::move(faces), RestLengths::equal);
}

FlatPattern pattern_of(const Net& net) { return std::get<FlatPattern>(flat_pattern(net, Topology(net))); }
PatternFault fault_of(const Net& net) { return std::get<PatternFault>(flat_pattern(net, Topology(net))); }

/// Surfaces whose borders cut nets in many ways.
std::vector<Surface> cut_surfaces() {
    std::vector<Surface> surfaces;
    for (const char* const name : {"hemisphere", "shell", "hypar"}) surfaces.push_back(make_own_surface(name));
    // A plate with five thin rays; one with steep hills; a ring; the middle of a sphere.
    surfaces.emplace_back(samples::quads(80, 20, true, false, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 80, r = (0.2 + 0.8 * j / 19) * (1 + 0.6 * std::cos(5 * u));
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), 0);
    }));
    surfaces.emplace_back(samples::graph(50, 1, [](double x, double y) {
        return 0.8 * std::exp(-15 * (std::pow(x + 0.4, 2) + std::pow(y + 0.4, 2))) +
               0.6 * std::exp(-22 * (std::pow(x - 0.4, 2) + std::pow(y - 0.3, 2)));
    }));
    surfaces.emplace_back(samples::quads(60, 9, true, false, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 60, r = 0.3 + 0.1 * j;
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), 0.3 * r * r * std::cos(2 * u));
    }));
    surfaces.emplace_back(samples::quads(60, 20, true, false, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 60, z = 0.8 * (2. * j / 19 - 1), r = std::sqrt(1 - z * z);
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), z);
    }));
    return surfaces;
}

/// A net as it was laid, by the steps that its vertices are from the seed.
struct LaidNet {
    const Drape& drape;
    double length;

    bool is_end(int v) const { return v >= drape.net.vertex_count() - drape.cut_ends; }
    /// Along an edge, from its first vertex; to an end, which is the second one then, towards the vertex beyond.
    Eigen::Vector2i steps(int e) const {
        return drape.places.col(drape.net.edges()(1, e)) - drape.places.col(drape.net.edges()(0, e));
    }
    /// Whether it can be of a rod. A rod that ends towards one vertex may be that of either of two that are one step
    /// away from it.
    bool may_be_rod(int e) const { return !is_end(drape.net.edges()(0, e)) && steps(e).cwiseAbs().sum() == 1; }
};

/// How many edges are rods that cannot be, and how many ends have none or several.
int wrong_rods(const LaidNet& laid, const std::vector<bool>& is_of_rod) {
    const Net& net = laid.drape.net;
    std::vector<int> rods_at(static_cast<std::size_t>(net.vertex_count()));
    int wrong = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const int b = net.edges()(1, e);
        if (is_of_rod[e] ? !laid.may_be_rod(e) : laid.may_be_rod(e) && !laid.is_end(b)) ++wrong;
        if (is_of_rod[e]) ++rods_at[b];
    }
    for (int v = 0; v < net.vertex_count(); ++v) wrong += laid.is_end(v) && rods_at[v] != 1 ? 1 : 0;
    return wrong;
}

/// How many rods are not along their own line of the grid, and as long as they are.
int misplaced_rods(const LaidNet& laid, const std::vector<bool>& is_of_rod, const FlatPattern& pattern) {
    const Net& net = laid.drape.net;
    const auto step = [&](int e) -> Eigen::Vector2d {
        return (pattern.places.col(net.edges()(1, e)) - pattern.places.col(net.edges()(0, e))) * laid.length /
               net.rest_lengths()[e];
    };
    Eigen::Matrix2d turn = Eigen::Matrix2d::Zero();
    int misplaced = 0;
    for (const bool is_first : {true, false})
        for (int e = 0; e < net.edge_count(); ++e) {
            if (!is_of_rod[e]) continue;
            const Eigen::Vector2d steps = laid.steps(e).cast<double>();
            for (int k = 0; k < 2 && is_first; ++k)
                if (steps[k] != 0 && turn.col(k).isZero(0)) turn.col(k) = step(e) / steps[k];
            if (!is_first && (step(e) - turn * steps).norm() > 1e-4) ++misplaced;
        }
    return misplaced;
}

const std::string k_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

}  // namespace

TEST_CASE("A vault's flat pattern is the square grid it was bent from") {
    const Net net = make_shape("vault:vertices=300").net;
    const FlatPattern pattern = pattern_of(net);
    CHECK((pattern.columns + 1) * (pattern.rows + 1) == net.vertex_count());
    std::set<std::pair<double, double>> taken;
    for (const auto& place : pattern.places.colwise()) {
        CHECK((place.x() >= 0 && place.x() <= pattern.columns && place.y() >= 0 && place.y() <= pattern.rows));
        taken.emplace(place.x(), place.y());
    }
    CHECK(static_cast<int>(taken.size()) == net.vertex_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto step = pattern.places.col(net.edges()(0, e)) - pattern.places.col(net.edges()(1, e));
        CHECK(step.cwiseAbs().sum() == 1);
    }
}

TEST_CASE("A flat pattern shows the front of the faces") {
    const Net net = samples::patch(5, 4);
    const FlatPattern pattern = pattern_of(net);
    for (int f = 0; f < net.face_count(); ++f) {
        const auto side = [&](int k) -> Eigen::Vector2d {
            return pattern.places.col(net.faces()[f][k]) - pattern.places.col(net.faces()[f][0]);
        };
        CHECK(side(1).x() * side(3).y() - side(1).y() * side(3).x() == 1);
    }
}

TEST_CASE("Pieces of a net lie beside and below each other, two squares apart, each seen from its front") {
    // Sheets of several sizes, the faces of each among those of the others.
    const std::vector<std::array<int, 2>> sizes = {{6, 2}, {1, 1}, {3, 4}, {2, 2}, {9, 1}};
    Positions positions(3, 0);
    std::vector<std::vector<std::array<int, 4>>> quads;
    for (const auto& [columns, rows] : sizes) {
        const Net sheet = samples::patch(columns + 1, rows + 1);
        const int first = static_cast<int>(positions.cols());
        positions.conservativeResize(3, first + sheet.vertex_count());
        positions.rightCols(sheet.vertex_count()) = sheet.rest_positions();
        quads.emplace_back();
        for (int f = 0; f < sheet.face_count(); ++f) {
            quads.back().emplace_back();
            for (int k = 0; k < 4; ++k) quads.back().back()[k] = first + sheet.faces()[f][k];
        }
    }
    Faces faces;
    for (std::size_t i = 0; i < 12; ++i)
        for (const auto& piece : quads)
            if (i < piece.size()) faces.add(piece[i]);
    const Net net(std::move(positions), std::move(faces));

    const FlatPattern pattern = pattern_of(net);
    REQUIRE(pattern.pieces.size() == sizes.size());
    CHECK(pattern.places.rowwise().minCoeff() == Eigen::Vector2d(0, 0));
    CHECK(pattern.places.rowwise().maxCoeff() == Eigen::Vector2d(pattern.columns, pattern.rows));
    int vertex = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const PatternPiece& piece = pattern.pieces[i];
        // On its side, if its first face is seen so.
        CHECK(std::minmax(piece.columns, piece.rows) == std::minmax(sizes[i][0], sizes[i][1]));
        const int count = (sizes[i][0] + 1) * (sizes[i][1] + 1);
        const auto own = pattern.places.middleCols(vertex, count);
        CHECK(own.rowwise().minCoeff() == Eigen::Vector2d(piece.column, piece.row));
        CHECK(own.rowwise().maxCoeff() == Eigen::Vector2d(piece.column + piece.columns, piece.row + piece.rows));
        vertex += count;
        for (std::size_t j = 0; j < i; ++j) {
            const PatternPiece& other = pattern.pieces[j];
            const bool is_beside =
                piece.column >= other.column + other.columns + 2 || other.column >= piece.column + piece.columns + 2;
            const bool is_below = piece.row >= other.row + other.rows + 2 || other.row >= piece.row + piece.rows + 2;
            CHECK((is_beside || is_below));
        }
    }
    for (int f = 0; f < net.face_count(); ++f) {
        const auto side = [&](int k) -> Eigen::Vector2d {
            return pattern.places.col(net.faces()[f][k]) - pattern.places.col(net.faces()[f][0]);
        };
        CHECK(side(1).x() * side(3).y() - side(1).y() * side(3).x() == 1);
    }
}

TEST_CASE("Where rods were cut at a border each keeps its length in the flat pattern") {
    const auto cut_net = [](const Mesh& mesh, double length, double turn) {
        const Surface surface(mesh);
        const SurfaceTree tree(surface);
        DrapeOptions options = suggested_drape(surface, tree, 200);
        options.length = length;
        options.direction = {std::cos(turn), std::sin(turn), 0};
        options.border = DrapeOptions::Border::cut;
        return drape(surface, tree, options).net;
    };
    // Flat, with a hole, the net is its own pattern: all lengths are as they were, those from end to end, too.
    const Mesh ring = samples::quads(60, 9, true, false, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 60, r = 0.3 + 0.1 * j;
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), 0);
    });
    for (const double turn : {0., 0.2, 0.5, 0.7}) {
        const Net net = cut_net(ring, 0.09, turn);
        const FlatPattern pattern = pattern_of(net);
        REQUIRE(pattern.pieces.size() == 1);
        for (int e = 0; e < net.edge_count(); ++e) {
            const auto side = pattern.places.col(net.edges()(0, e)) - pattern.places.col(net.edges()(1, e));
            CHECK(0.09 * side.norm() == Approx(net.rest_lengths()[e]).epsilon(1e-6));
        }
    }
    // Curved, the rods have their lengths still, and lie upright or level.
    const Net net = cut_net(samples::sphere(24, true), 0.08, 0.3);
    const FlatPattern pattern = pattern_of(net);
    int cut = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (net.edge_face_counts()[e] != 2) continue;
        const auto side = pattern.places.col(net.edges()(0, e)) - pattern.places.col(net.edges()(1, e));
        CHECK(side.cwiseAbs().minCoeff() < 1e-9);
        CHECK(0.08 * side.norm() == Approx(net.rest_lengths()[e]).epsilon(1e-6));
        cut += net.rest_lengths()[e] < 0.0799;
    }
    CHECK(cut > 20);
}

TEST_CASE("A rod that is cut along the boundary hangs on its own corner") {
    // Two whole squares, and above them what a border leaves of two more; then mirrored.
    for (const int turn : {1, -1}) {
        const auto corner = [turn](int a, int b, int c, int d) {
            return "f " + std::to_string(a) + ' ' + std::to_string(turn > 0 ? b : d) + ' ' + std::to_string(c) + ' ' +
                   std::to_string(turn > 0 ? d : b) + '\n';
        };
        const auto at = [turn](double x, double y) {
            return "v " + std::to_string(turn * x) + ' ' + std::to_string(y) + " 0\n";
        };
        const std::string squares = at(0, 0) + at(1, 0) + at(2, 0) + at(0, 1) + at(1, 1) + at(2, 1);
        const Net quads = net_of(squares + at(0, 1.5) + at(1, 1.6) + at(2, 1.7) + corner(1, 2, 5, 4) +
                                 corner(2, 3, 6, 5) + corner(4, 5, 8, 7) + corner(5, 6, 9, 8));
        const FlatPattern pattern = pattern_of(quads);
        for (const auto& [low, high, length] : {std::tuple(3, 6, 0.5), {4, 7, 0.6}, {5, 8, 0.7}}) {
            const Eigen::Vector2d step = (pattern.places.col(high) - pattern.places.col(low)).cwiseAbs();
            CHECK(step.minCoeff() < 1e-9);
            CHECK(step.maxCoeff() == Approx(length));
        }
        const std::string triangle = turn > 0 ? "f 4 5 7\n" : "f 4 7 5\n";
        const FlatPattern sharp =
            pattern_of(net_of(squares + at(0, 1.5) + corner(1, 2, 5, 4) + corner(2, 3, 6, 5) + triangle));
        CHECK((sharp.places.col(6) - sharp.places.col(3)).norm() == Approx(0.5));
        CHECK((sharp.places.col(6) - sharp.places.col(4)).norm() == Approx(std::sqrt(1.25)));
    }
}

TEST_CASE("What joins the ends of cut rods is no rod in the flat pattern, though it is as long as one") {
    // Above three whole squares rods end, each a little farther than the one before.
    const FlatPattern steps = pattern_of(
        net_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\nv 0 1.7 0\nv 1 1.712 0\n"
               "v 2 1.724 0\nv 3 1.736 0\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\n"));
    CHECK((steps.places.col(11) - steps.places.col(0)).norm() == Approx(std::hypot(3, 1.736)));

    // A border that cuts the two rods at the corner of a square so that a triangle with a side of 1 is left.
    Mesh plate{Positions::Zero(3, 4), {}};
    plate.positions.row(0) << -2.5, 5.975, -0.4, -2.5;
    plate.positions.row(1) << -2.5, -2.5, 6, 6;
    plate.faces.add({0, 1, 2, 3});
    const Surface surface(plate);
    DrapeOptions options;
    options.border = DrapeOptions::Border::cut;
    const Net net = drape(surface, SurfaceTree(surface), options).net;
    REQUIRE(faces_by_arity(net.faces()).count(3) == 1);
    const FlatPattern pattern = pattern_of(net);
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto side = pattern.places.col(net.edges()(0, e)) - pattern.places.col(net.edges()(1, e));
        CHECK(side.norm() == Approx(net.rest_lengths()[e]).epsilon(1e-6));
    }
}

TEST_CASE("A tongue of cut cells along a border that follows a line is laid along that") {
    const FlatPattern pattern = pattern_of(net_of(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 1 1.3 0\nv 0.6 2 0\nv 0 2 0\nv 0.4 3 0\nv 0 3 0\nv 0 4 0\nv 0.3 4 0\n"
        "f 1 2 4 3\nf 3 4 5 6 7\nf 7 6 8 9\nf 9 8 11 10\n"));
    CHECK(pattern.rows == 4);
    CHECK((pattern.places.col(8) - pattern.places.col(0)).norm() == Approx(3));
    CHECK((pattern.places.col(10) - pattern.places.col(9)).norm() == Approx(0.3));
    CHECK((pattern.places.col(10) - pattern.places.col(0)).squaredNorm() == Approx(16.09));
}

TEST_CASE("What rods do not hold together has no flat pattern") {
    // A ring of eight cells; of one the sides that no other has are not as long as the others'.
    Positions positions(3, 16);
    Faces faces;
    for (int i = 0; i < 8; ++i) {
        const double u = samples::k_pi / 4 * i, r = 0.5 / std::sin(samples::k_pi / 8);
        positions.col(2 * i) << r * std::cos(u), r * std::sin(u), 0;
        positions.col(2 * i + 1) << r * std::cos(u), r * std::sin(u), 1;
        const int next = (i + 1) % 8;
        faces.add({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    Mesh ring{positions, faces};
    CHECK(fault_of(Net(ring.positions, ring.faces)).reason == Reason::closed);
    const Eigen::Vector3d axis = (positions.col(2) - positions.col(0)).normalized();
    ring.positions.col(0) += 0.05 * axis;
    ring.positions.col(1) -= 0.05 * axis;
    CHECK_FALSE(std::holds_alternative<FlatPattern>(
        flat_pattern(Net(ring.positions, ring.faces), Topology(Net(ring.positions, ring.faces)))));

    // Longer than the rod between them; off the grid behind a short cell; and a single cell that is a piece.
    for (const char* const obj : {"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 .6 0\nv 1 .7 0\nv 2 .8 0\nf 1 2 5 4\nf 2 3 6 5\n",
                                  "v 0 0 0\nv 1 0 0\nv 1.5 0 0\nv 2.5 0 0\nv 0 1 0\nv 1 1 0\nv 1.5 1 0\nv 2.5 1 0\nf 1 "
                                  "2 6 5\nf 2 3 7 6\nf 3 4 8 7\n",
                                  "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 5 0 0\nv 5.9 0 0\nv 5 0.5 "
                                  "0\nf 1 2 5 4\nf 2 3 6 5\nf 7 8 9\n"})
        CHECK(fault_of(net_of(obj)).reason == Reason::loose);
}

TEST_CASE("A net without a flat pattern says why") {
    CHECK(fault_of(make_shape("jack").net).reason == Reason::singular);
    CHECK(fault_of(make_shape("torus").net).reason == Reason::closed);
    CHECK(fault_of(make_shape("tube").net).reason == Reason::closed);
    CHECK(fault_of(net_of("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n")).reason == Reason::unequal);
    // Two whole squares, and beside them a rod that is cut at both ends.
    const PatternFault loose = fault_of(
        net_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 0.3 0\nv 3 0.8 0\nv 4 0.3 0\nv 4 0.8 0\n"
               "f 1 2 5 4\nf 2 3 6 5\nf 3 7 8 6\nf 7 9 10 8\n"));
    CHECK(loose.reason == Reason::loose);
    CHECK(loose.face == 2);
    const PatternFault tip = fault_of(net_of(k_square + "v 2 1 0\nv 2 2 0\nv 1 2 0\nf 3 5 6 7\n"));
    CHECK(tip.reason == Reason::touching);
    CHECK(tip.vertex == 2);
    const PatternFault cut = fault_of(net_of(k_square + "v 1.8660254037844386 0.5 0\nf 2 5 3\n"));
    CHECK(cut.reason == Reason::not_quads);
    CHECK(cut.face == 1);
    const PatternFault stair = fault_of(winding_stair());
    CHECK(stair.reason == Reason::overlap);
    CHECK(stair.face == 4);
}

TEST_CASE("A singular vertex without a place on the grid is named") {
    const Net net = make_shape("jack").net;
    const Topology topology(net);
    const int vertex = fault_of(net).vertex;
    CHECK_FALSE(topology.is_boundary(vertex));
    CHECK(topology.valence(vertex) != 4);
}

TEST_CASE("A cut net that was edited to the threshold, saved and opened again lies flat") {
    const Surface hemisphere = make_own_surface("hemisphere");
    const SurfaceTree tree(hemisphere);
    DrapeOptions options = suggested_drape(hemisphere, tree, 300);
    options.border = DrapeOptions::Border::cut;
    const Net net = drape(hemisphere, tree, options).net;
    std::mt19937 random(5);  // NOLINT(cert-msc51-cpp): the same net each time
    const Net edited(samples::shaken(net.rest_positions(), 2e-4 * options.length, random), net.faces());
    const Eigen::ArrayXd change = edited.rest_lengths().array() / net.rest_lengths().array() - 1;
    CHECK(change.abs().maxCoeff() > 1e-4);
    CHECK(is_cut(edited, Topology(edited)));
    CHECK(rods(edited, Topology(edited)) == rods(net, Topology(net)));
    const FlatPattern before = pattern_of(net), after = pattern_of(edited);
    CHECK((after.places - before.places).cwiseAbs().maxCoeff() < 0.01);
}

TEST_CASE("A strip of cut rods that was edited, saved and opened again lies flat") {
    // One cell wide, and whole along its sides only; what is beside it has been cut off.
    const auto strip = [](double error) {
        std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same net each time
        std::uniform_real_distribution<double> off(-error, error);
        Positions positions(3, 24);
        Faces faces;
        double low = 0, high = 0;
        for (int i = 0; i < 12; ++i) {
            positions.col(2 * i) << low, 0, 0;
            positions.col(2 * i + 1) << high, 0.6, 0;
            low += 1 + off(random);
            high += 1 + off(random);
            positions(1, 2 * i + 1) += off(random);
            if (i > 0) faces.add({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
        }
        return Net(positions, faces);
    };
    for (const double error : {0., 1e-5, 4e-5, 4e-4}) {
        const Net net = strip(error);
        const FlatPattern pattern = pattern_of(net);
        CHECK(std::min(pattern.columns, pattern.rows) == 1);
        CHECK(std::max(pattern.columns, pattern.rows) == 11);
        for (int e = 0; e < net.edge_count(); ++e) {
            const auto side = pattern.places.col(net.edges()(0, e)) - pattern.places.col(net.edges()(1, e));
            CHECK(side.norm() == Approx(net.rest_lengths()[e]).epsilon(5e-3));
            CHECK(side.cwiseAbs().minCoeff() < 1e-9);
        }
        // Both sides and ten rods between; at its ends it may be rims that are as long.
        CHECK(rods(net, Topology(net)).size() == 12);
    }
}

TEST_CASE("Rods that end longer than the others are no net of equal edges") {
    // Also by little: no cut helps them.
    for (const double wide : {1.5, 1.005}) {
        const Net even = samples::patch(9, 9);
        Positions positions = even.rest_positions() / even.mean_length();
        const double least = positions.row(0).minCoeff(), most = positions.row(0).maxCoeff();
        for (int v = 0; v < even.vertex_count(); ++v) {
            if (positions(0, v) < least + 0.5) positions(0, v) -= wide - 1;
            if (positions(0, v) > most - 0.5) positions(0, v) += wide - 1;
        }
        CHECK(fault_of(Net(positions, even.faces())).reason == Reason::unequal);
    }
}

TEST_CASE("Rods and the flat pattern of a net that a border has cut are what it was laid by") {
    constexpr int k_nets = 20;  // on each surface
    int ends = 0, patterns = 0;
    for (const Surface& surface : cut_surfaces()) {
        const SurfaceTree tree(surface);
        for (unsigned seed = 0; seed < k_nets; ++seed) {
            std::mt19937 random(seed);  // NOLINT(cert-msc51-cpp): the same nets each time
            DrapeOptions options = suggested_drape(surface, tree, 100 + static_cast<int>(random() % 1000));
            options.seed = surface.position_at(samples::random_place(surface, random));
            options.direction = samples::random_point(1, random);
            options.angle = samples::k_pi * (0.2 + 0.15 * static_cast<double>(seed % 5));
            options.border = DrapeOptions::Border::cut;
            const std::optional<Drape> draped = samples::drape_if_any(surface, tree, options);
            if (!draped) continue;
            INFO("surface of " << surface.face_count() << " triangles, seed " << seed);
            const Topology topology(draped->net);
            const LaidNet laid{*draped, options.length};
            const std::vector<bool> is_of_rod = rod_edges(draped->net, topology, options.length);
            CHECK(wrong_rods(laid, is_of_rod) == 0);
            ends += draped->cut_ends;
            const auto pattern = flat_pattern(draped->net, topology);
            if (const auto* const fault = std::get_if<PatternFault>(&pattern)) {
                CHECK(std::string(to_string(fault->reason)) == "overlap");
                continue;
            }
            CHECK(misplaced_rods(laid, is_of_rod, std::get<FlatPattern>(pattern)) == 0);
            ++patterns;
        }
    }
    CHECK(ends > 5000);
    CHECK(patterns > 100);
}
