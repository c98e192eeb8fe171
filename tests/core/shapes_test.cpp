#include "shapes/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "net/measures.h"
#include "net/topology.h"
#include "sample_nets.h"
#include "shapes/voxel_solid.h"

using namespace chebnet;

namespace {

/// Shapes that are relaxed until they are smooth, each as the beginning of a recipe.
const std::vector<std::string> k_bodies{"teddy", "rabbit", "horse", "jug", "shirt"},
    k_smooth_figures{"elephant:smooth=1", "jack:smooth=1"};

std::vector<std::string> smooth_shapes() {
    std::vector<std::string> all = k_bodies;
    all.insert(all.end(), k_smooth_figures.begin(), k_smooth_figures.end());
    return all;
}

std::string with_vertices(const std::string& recipe, int vertices) {
    return recipe + (recipe.find(':') == recipe.npos ? ":vertices=" : ",vertices=") + std::to_string(vertices);
}

/// Largest difference of an edge's length from that of the first edge, relative to it.
double edge_length_spread(const Net& net) {
    const Positions& p = net.rest_positions();
    const auto length = [&](int e) { return (p.col(net.edges()(0, e)) - p.col(net.edges()(1, e))).norm(); };
    double spread = 0;
    for (int e = 0; e < net.edge_count(); ++e) spread = std::max(spread, std::abs(length(e) / length(0) - 1));
    return spread;
}

/// No side of a face is run through twice in the same direction.
bool is_consistently_oriented(const Net& net) {
    std::set<std::pair<int, int>> sides;
    for (int f = 0; f < net.face_count(); ++f) {
        const auto face = net.faces()[f];
        for (std::size_t k = 0; k < face.size(); ++k)
            if (!sides.insert({face[k], face[(k + 1) % face.size()]}).second) return false;
    }
    return true;
}

/// The faces at each vertex of a closed net follow each other in one round.
bool has_one_fan_at_each_vertex(const Net& net) {
    std::vector<std::map<int, int>> next(net.vertex_count());
    for (int f = 0; f < net.face_count(); ++f) {
        const auto face = net.faces()[f];
        const auto n = face.size();
        for (std::size_t k = 0; k < n; ++k) next[face[k]][face[(k + 1) % n]] = face[(k + n - 1) % n];
    }
    for (const auto& round : next) {
        std::size_t faces = 1;
        for (int v = round.at(round.begin()->first); v != round.begin()->first; v = round.at(v)) ++faces;
        if (faces != round.size()) return false;
    }
    return true;
}

/// Normal of a quad, with twice its area as length.
Eigen::Vector3d face_normal(const Net& net, int f) {
    const Positions& p = net.rest_positions();
    const auto face = net.faces()[f];
    return (p.col(face[2]) - p.col(face[0])).cross(p.col(face[3]) - p.col(face[1]));
}

Eigen::Vector3d face_middle(const Net& net, int f) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int v : net.faces()[f]) sum += net.rest_positions().col(v);
    return sum / 4;
}

/// Volume within a closed net of planar quads; positive if they face outwards.
double volume(const Net& net) {
    double sum = 0;
    for (int f = 0; f < net.face_count(); ++f) sum += face_middle(net, f).dot(face_normal(net, f)) / 6;
    return sum;
}

/// By how much the directions of two edges that follow each other in a net line differ: nearly the angle between them.
struct Turns {
    double root_mean_square = 0;
    double largest = 0;  // more than ten edges away from where net lines end
};

Turns turns(const Net& net) {
    const Topology topology(net);
    const std::vector<std::vector<int>> lines = topology.net_lines();
    std::vector<int> ends;
    for (const std::vector<int>& line : lines)
        if (line.front() != line.back()) ends.insert(ends.end(), {line.front(), line.back()});
    std::erase_if(ends, [&](int v) { return topology.is_boundary(v) && topology.valence(v) == 3; });
    const std::vector<double> distance = topology.distances_from(ends);
    const Positions& p = net.rest_positions();
    Turns turns;
    int count = 0;
    for (const std::vector<int>& line : lines)
        for (std::size_t i = 1; i + 1 < line.size(); ++i, ++count) {
            const double turn =
                (p.col(line[i - 1]) - 2 * p.col(line[i]) + p.col(line[i + 1])).norm() / net.mean_length();
            turns.root_mean_square += turn * turn;
            if (distance[line[i]] > 10 * net.mean_length()) turns.largest = std::max(turns.largest, turn);
        }
    turns.root_mean_square = std::sqrt(turns.root_mean_square / count);
    return turns;
}

/// Between the normals of faces that share an edge, degrees.
double largest_fold_of(const Net& net) {
    std::map<std::pair<int, int>, int> seen;
    double least_cosine = 1;
    for (int f = 0; f < net.face_count(); ++f) {
        const auto face = net.faces()[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            const auto [first, is_new] = seen.insert({std::minmax(face[k], face[(k + 1) % face.size()]), f});
            if (!is_new)
                least_cosine = std::min(
                    least_cosine, face_normal(net, f).normalized().dot(face_normal(net, first->second).normalized()));
        }
    }
    return std::acos(least_cosine) * 180 / std::numbers::pi;
}

std::string recipe_text(const std::string& name, const std::vector<std::pair<std::string, double>>& values) {
    std::ostringstream text;
    text.precision(17);
    text << name;
    char separator = ':';
    for (const auto& [key, value] : values) {
        text << std::exchange(separator, ',') << key << '=' << value;
    }
    return text.str();
}

/// Recipes of a shape with every parameter but `vertices` at the one or the other end of its range.
std::vector<std::string> extreme_recipes(const ShapeInfo& shape, double vertices) {
    std::vector<std::string> recipes;
    const std::size_t free_parameters = shape.parameters.size() - 1;
    for (unsigned corner = 0; corner < 1u << free_parameters; ++corner) {
        std::vector<std::pair<std::string, double>> values{{"vertices", vertices}};
        for (std::size_t k = 0; k < free_parameters; ++k) {
            const ShapeParameter& parameter = shape.parameters[k + 1];
            values.emplace_back(parameter.name, corner >> k & 1 ? parameter.largest : parameter.smallest);
        }
        recipes.push_back(recipe_text(shape.name, values));
    }
    return recipes;
}

/// Bodies are relaxed, which takes seconds where others are laid out at once.
double largest_size(const ShapeInfo& shape) {
    const auto is_it = [&](const std::string& body) { return body == shape.name; };
    return std::any_of(k_bodies.begin(), k_bodies.end(), is_it) ? 5000 : 100000;
}

/// `vertices`: about so many are asked for; fewer than a thousand are met less closely.
void check_shape(const std::string& recipe, double vertices = 0) {
    INFO(recipe);
    const Shape shape = make_shape(recipe);
    const Net& net = shape.net;
    CHECK(net.is_chebyshev());
    CHECK(edge_length_spread(net) < 1e-12);
    CHECK(is_consistently_oriented(net));
    if (vertices >= 1000) CHECK(net.vertex_count() == Approx(vertices).epsilon(0.15));

    const Eigen::Vector3d low = net.rest_positions().rowwise().minCoeff();
    const Eigen::Vector3d high = net.rest_positions().rowwise().maxCoeff();
    CHECK((high - low).maxCoeff() == Approx(10));
    CHECK((high + low).head<2>().norm() < 1e-12);
    CHECK(std::abs(low.z()) < 1e-12);

    const std::set<int> handles(shape.suggested_handles.begin(), shape.suggested_handles.end());
    CHECK(handles.size() == shape.suggested_handles.size());
    CHECK(handles.size() >= 3);
    CHECK(*handles.begin() >= 0);
    CHECK(*handles.rbegin() < net.vertex_count());
    // An anchor next to the vertex to drag would hold it back by the length of one edge.
    const Topology topology(net);
    for (const int neighbour : topology.neighbours(shape.suggested_handles.back()))
        CHECK(handles.count(neighbour) == 0);
}

/// "code: message" of the error that a recipe is refused with.
std::string recipe_refusal(const std::string& recipe) {
    try {
        make_shape(recipe);
    } catch (const Error& error) {
        return std::string(to_string(error.code())) + ": " + error.what();
    }
    return "none";
}

/// Size of the random solids of the tests below, and how many.
constexpr int k_room = 5, k_solids = 300;

VoxelSolid random_solid(std::mt19937& random) {
    VoxelSolid solid({0, 0, 0}, {k_room, k_room, k_room});
    std::bernoulli_distribution is_filled(std::uniform_real_distribution(0.05, 0.95)(random));
    Eigen::Vector3i cell;
    for (cell.z() = 0; cell.z() < k_room; ++cell.z())
        for (cell.y() = 0; cell.y() < k_room; ++cell.y())
            for (cell.x() = 0; cell.x() < k_room; ++cell.x())
                if (is_filled(random)) solid.fill(cell, cell + Eigen::Vector3i::Ones());
    return solid;
}

int filled_count(const VoxelSolid& solid) {
    int count = 0;
    Eigen::Vector3i cell;
    for (cell.z() = 0; cell.z() < k_room; ++cell.z())
        for (cell.y() = 0; cell.y() < k_room; ++cell.y())
            for (cell.x() = 0; cell.x() < k_room; ++cell.x()) count += solid.filled(cell);
    return count;
}

Net boundary_net(const VoxelSolid& solid) {
    Mesh surface = boundary_surface(solid);
    return Net(std::move(surface.positions), std::move(surface.faces));
}

/// The boundary of the solid with these cells.
Net net_of_cells(const std::vector<Eigen::Vector3i>& cells) {
    VoxelSolid solid({0, 0, 0}, {k_room, k_room, k_room});
    for (const Eigen::Vector3i& cell : cells) solid.fill(cell, cell + Eigen::Vector3i::Ones());
    return boundary_net(solid);
}

bool is_closed_manifold(const Net& net) {
    for (const int faces : net.edge_face_counts())
        if (faces != 2) return false;
    return has_one_fan_at_each_vertex(net) && is_consistently_oriented(net) &&
           samples::euler_characteristic(net) % 2 == 0;
}

}  // namespace

TEST_CASE("Every shape is exact, oriented and in place by default") {
    for (const ShapeInfo& shape : shape_table()) check_shape(shape.name);
}

TEST_CASE(
    "Every shape is exact and has about as many vertices as asked for, at the ends of its ranges and at every size",
    "[large]") {
    for (const ShapeInfo& shape : shape_table()) {
        for (const double vertices : {1000., 4000., largest_size(shape)})
            check_shape(recipe_text(shape.name, {{"vertices", vertices}}), vertices);
        for (const double vertices : {100, 317, 1000, 10000})
            for (const std::string& recipe : extreme_recipes(shape, vertices)) check_shape(recipe, vertices);
    }
}

TEST_CASE("The open shapes are grids that face up or outwards") {
    const Net vault = make_shape("vault").net, dome = make_shape("dome").net, tube = make_shape("tube:bend=0").net;
    CHECK(Topology(vault).boundary_loops().size() == 1);
    CHECK(Topology(dome).boundary_loops().size() == 1);
    CHECK(Topology(tube).boundary_loops().size() == 2);
    for (const Net* net : {&vault, &dome, &tube}) CHECK(Topology(*net).singular_vertices().empty());

    for (int f = 0; f < vault.face_count(); ++f) REQUIRE(face_normal(vault, f).z() > 0);
    for (int f = 0; f < dome.face_count(); ++f) REQUIRE(face_normal(dome, f).z() > 0);
    for (int f = 0; f < tube.face_count(); ++f)
        REQUIRE(face_normal(tube, f).head<2>().dot(face_middle(tube, f).head<2>()) > 0);
}

TEST_CASE("The sheet is flat, of squares, and its middle can be lifted between the corners that hold it") {
    const Shape sheet = make_shape("sheet:vertices=600,aspect=1.5");
    const Positions& p = sheet.net.rest_positions();
    CHECK(p.row(2).cwiseAbs().maxCoeff() == 0);
    CHECK(Topology(sheet.net).boundary_loops().size() == 1);
    CHECK(corner_angle_range(sheet.net, p).smallest == Approx(std::numbers::pi / 2));
    CHECK(p.row(1).maxCoeff() - p.row(1).minCoeff() ==
          Approx(1.5 * (p.row(0).maxCoeff() - p.row(0).minCoeff())).epsilon(0.05));

    REQUIRE(sheet.suggested_handles.size() == 3);
    const int crown = sheet.suggested_handles.back();
    for (const int corner : {sheet.suggested_handles[0], sheet.suggested_handles[1]}) {
        const Eigen::Vector3d way = p.col(crown) - p.col(corner);
        CHECK(way.norm() < 0.8 * way.lpNorm<1>());  // the net lines between them are longer than the way
    }
}

TEST_CASE("The saddle curves up along one direction and down along the other, and no corner is sharp") {
    const Net saddle = make_shape("saddle:vertices=441").net;
    const Positions& p = saddle.rest_positions();
    const auto height = [&](int column, int row) { return p(2, row * 21 + column); };
    REQUIRE(saddle.vertex_count() == 441);
    CHECK(height(10, 10) > height(0, 10) + 1);
    CHECK(height(10, 10) < height(10, 0) - 1);
    CHECK(height(0, 0) == Approx(height(10, 10)));
    CHECK(corner_angle_range(saddle, p).smallest > 60 * std::numbers::pi / 180);
}

TEST_CASE("The canopy rises from a foot to its crest, falls, and ends level, higher than it began") {
    const Net canopy = make_shape("canopy:vertices=961,aspect=1").net;
    const Positions& p = canopy.rest_positions();
    const auto height = [&](int column, int row) { return p(2, row * 31 + column); };
    REQUIRE(canopy.vertex_count() == 961);
    const auto slope = [&](int row) { return (height(15, row + 1) - height(15, row)) / canopy.mean_length(); };
    CHECK(slope(0) == Approx(std::sin(40 * std::numbers::pi / 180)).epsilon(0.01));
    CHECK(std::abs(slope(13)) < 0.05);
    CHECK(slope(21) < -0.3);
    CHECK(std::abs(slope(29)) < 0.05);
    CHECK(height(15, 30) > height(15, 0) + 0.2);
    for (const int row : {0, 13, 30}) CHECK(height(15, row) > height(0, row) + 1);  // an arch across
    CHECK(corner_angle_range(canopy, p).smallest > 60 * std::numbers::pi / 180);
}

TEST_CASE(
    "The vase is round in each ring, wide at its belly and narrow at its neck, with wires that wind up both ways") {
    const Shape vase = make_shape("vase:vertices=2000,waist=0.5");
    const Positions& p = vase.net.rest_positions();
    CHECK(Topology(vase.net).boundary_loops().size() == 2);
    CHECK(Topology(vase.net).singular_vertices().empty());
    for (int f = 0; f < vase.net.face_count(); ++f)
        REQUIRE(face_normal(vase.net, f).head<2>().dot(face_middle(vase.net, f).head<2>()) > 0);

    std::map<long, std::pair<double, double>> radii;  // smallest and largest of each height
    for (int v = 0; v < p.cols(); ++v) {
        const double radius = (p.col(v) - p.rowwise().mean()).head<2>().norm();
        const auto at = radii.try_emplace(std::lround(p(2, v) * 1e6), radius, radius).first;
        at->second = {std::min(at->second.first, radius), std::max(at->second.second, radius)};
    }
    double widest = 0, narrowest = 1e9;
    for (const auto& [height, range] : radii) {
        REQUIRE(range.second - range.first < 1e-9);
        widest = std::max(widest, range.first);
        narrowest = std::min(narrowest, range.first);
    }
    CHECK(narrowest / widest == Approx(0.5).epsilon(0.01));
    const AngleRange corners = corner_angle_range(vase.net, p);
    CHECK(corners.smallest > 40 * std::numbers::pi / 180);
    CHECK(corners.largest > 130 * std::numbers::pi / 180);  // steep at the neck
}

TEST_CASE(
    "The waves rise as often as asked for in either direction, from a border that is lowest, and no corner is sharp") {
    for (const int waves : {1, 2, 5}) {
        INFO(waves);
        const int n = 41;
        const Net wave =
            make_shape("wave:vertices=" + std::to_string(n * n) + ",slope=45,waves=" + std::to_string(waves)).net;
        const Positions& p = wave.rest_positions();
        REQUIRE(wave.vertex_count() == n * n);
        for (const bool is_along : {false, true}) {
            const auto height = [&](int i) { return p(2, is_along ? i * n : i); };
            int crests = 0;
            for (int i = 1; i + 1 < n; ++i) crests += height(i) > height(i - 1) && height(i) >= height(i + 1);
            CHECK(crests == waves);
        }
        CHECK(p(2, 0) == Approx(0).margin(1e-9));
        CHECK(p.row(2).minCoeff() == Approx(0).margin(1e-9));
        CHECK(corner_angle_range(wave, p).smallest > 59 * std::numbers::pi / 180);
    }
}

TEST_CASE("The scroll is a rectangle rolled up, with as many turns as asked for that do not touch") {
    const Net scroll = make_shape("scroll:vertices=8000,turns=2.5").net;
    const Positions& p = scroll.rest_positions();
    const int columns = static_cast<int>(((p.row(1).array() - p(1, 0)).abs() < 1e-9).count());
    CHECK(corner_angle_range(scroll, p).smallest == Approx(std::numbers::pi / 2));
    double turned = 0, distance = 1e9;
    for (int i = 1; i + 1 < columns; ++i) {
        const Eigen::Vector3d before = p.col(i) - p.col(i - 1), after = p.col(i + 1) - p.col(i);
        turned += std::acos(before.dot(after) / (before.norm() * after.norm()));
        for (int j = i + columns / 8; j < columns; ++j) distance = std::min(distance, (p.col(j) - p.col(i)).norm());
    }
    CHECK(turned / (2 * std::numbers::pi) == Approx(2.5).epsilon(0.05));
    CHECK(distance > 1.5 * scroll.mean_length());
}

TEST_CASE("The torus is closed, of genus one and without singular vertices") {
    const Net torus = make_shape("torus").net;
    CHECK(is_closed_manifold(torus));
    CHECK(samples::euler_characteristic(torus) == 0);
    CHECK(Topology(torus).singular_vertices().empty());
}

TEST_CASE("The dome lies on a sphere") {
    const Net dome = make_shape("dome:reach=70,vertices=3000").net;
    const Positions& p = dome.rest_positions();
    // Centre and radius from the crown and two opposite corners, which lie in one plane with the axis.
    const Eigen::Vector3d corner = p.col(0), crown = p.col(dome.vertex_count() / 2);
    const double drop = crown.z() - corner.z(), radius = (corner.head<2>().squaredNorm() + drop * drop) / (2 * drop);
    const Eigen::Vector3d centre = crown - radius * Eigen::Vector3d::UnitZ();
    CHECK((p.colwise() - centre).colwise().norm().maxCoeff() == Approx(radius).epsilon(1e-12));
    CHECK((p.colwise() - centre).colwise().norm().minCoeff() == Approx(radius).epsilon(1e-12));
}

TEST_CASE("No shape of a smooth family is folded flat, whatever its parameters") {
    for (const std::string name : {"vault", "sheet", "dome", "tube", "torus"})
        for (const ShapeInfo& shape : shape_table())
            for (const double vertices : {100, 3000})
                for (const std::string& recipe : extreme_recipes(shape, vertices)) {
                    if (name != shape.name) continue;
                    INFO(recipe);
                    const Net net = make_shape(recipe).net;
                    CHECK(corner_angle_range(net, net.rest_positions()).smallest > 10 * 3.14159 / 180);
                }
}

TEST_CASE("The closed figures have the singular vertices that their sentences name") {
    const Net jack = make_shape("jack").net, steps = make_shape("steps:steps=3").net,
              elephant = make_shape("elephant").net;
    for (const Net* net : {&jack, &steps, &elephant}) {
        CHECK(is_closed_manifold(*net));
        CHECK(samples::euler_characteristic(*net) == 2);
        CHECK(volume(*net) > 0);
    }
    using Valences = std::map<int, int>;
    CHECK(Topology(jack).singular_vertices() == Valences{{3, 24}, {6, 8}});
    CHECK(Topology(steps).singular_vertices() == Valences{{3, 16}, {5, 8}});
    const Valences elephants = Topology(elephant).singular_vertices();
    CHECK(elephants.size() == 3);
    for (const int valence : {3, 5, 6}) CHECK(elephants.count(valence) == 1);
}

TEST_CASE("The smooth bodies have the handles and openings that they show") {
    for (const auto& [recipe, characteristic] :
         {std::pair{"teddy", 2}, {"rabbit", 2}, {"horse", -2}, {"elephant:smooth=1", 2}, {"jack:smooth=1", 2}}) {
        INFO(recipe);
        const Net net = make_shape(recipe).net;
        CHECK(is_closed_manifold(net));
        CHECK(Topology(net).component_count() == 1);
        CHECK(samples::euler_characteristic(net) == characteristic);
        CHECK(volume(net) > 0);
        CHECK(Topology(net).singular_vertices().size() >= 2);
    }
    for (const auto& [recipe, openings, handles] : {std::tuple{"jug", 1, 1}, {"shirt", 4, 0}}) {
        INFO(recipe);
        const Net net = make_shape(recipe).net;
        CHECK(Topology(net).component_count() == 1);
        CHECK(Topology(net).boundary_loops().size() == static_cast<std::size_t>(openings));
        CHECK(samples::euler_characteristic(net) == 2 - 2 * handles - openings);
    }
}

TEST_CASE("Rounded bodies have the faces of those with sharp cones, and softer folds", "[large]") {
    struct Case {
        std::string name;
        double largest_fold;  // rounded, degrees; of the horse, whose limbs are thin, more
    };
    for (const auto& [name, largest_fold] :
         {Case{"teddy", 70}, Case{"rabbit", 70}, Case{"jug", 65}, Case{"horse", 76}}) {
        const Net sharp = make_shape(name).net, round = make_shape(name + ":rounding=1").net;
        INFO(name << ": " << largest_fold_of(sharp) << ", " << largest_fold_of(round));
        CHECK(sharp.faces().vertices == round.faces().vertices);
        CHECK(edge_length_spread(round) < 1e-12);
        CHECK(largest_fold_of(sharp) > 80);
        CHECK(largest_fold_of(round) < largest_fold);
        CHECK(corner_angle_range(round, round.rest_positions()).smallest > 50 * std::numbers::pi / 180);
        CHECK(make_shape(name + ":rounding=0").net.rest_positions() == sharp.rest_positions());
    }
}

TEST_CASE("Smooth figures have the faces of those of blocks") {
    for (const std::string name : {"elephant", "jack"}) {
        const Net blocks = make_shape(name).net, smooth = make_shape(name + ":smooth=1").net;
        CHECK(Topology(blocks).singular_vertices() == Topology(smooth).singular_vertices());
        CHECK(blocks.vertex_count() == smooth.vertex_count());
        CHECK(volume(smooth) > 0.7 * volume(blocks));
        CHECK(volume(smooth) < 1.5 * volume(blocks));
    }
}

TEST_CASE(
    "A smooth shape is the same at every number of vertices, its net lines turn the more gently the more there are",
    "[large]") {
    for (const std::string& recipe : smooth_shapes()) {
        const Shape coarse = make_shape(with_vertices(recipe, 1000)), fine = make_shape(with_vertices(recipe, 8000));
        const Turns few_turns = turns(coarse.net), many_turns = turns(fine.net);
        INFO(recipe << ": " << few_turns.root_mean_square << ", " << many_turns.root_mean_square << ", "
                    << many_turns.largest);
        CHECK(few_turns.root_mean_square < 0.52);
        CHECK(many_turns.root_mean_square < 0.23);
        CHECK(many_turns.root_mean_square < 0.56 * few_turns.root_mean_square);
        CHECK(many_turns.largest < 0.6);

        const double edge = coarse.net.mean_length();
        const Positions &few = coarse.net.rest_positions(), &many = fine.net.rest_positions();
        for (int v = 0; v < few.cols(); ++v)
            REQUIRE(std::sqrt((many.colwise() - few.col(v)).colwise().squaredNorm().minCoeff()) < 2.5 * edge);
        REQUIRE(coarse.suggested_handles.size() == fine.suggested_handles.size());
        for (std::size_t i = 0; i < fine.suggested_handles.size(); ++i)
            CHECK((few.col(coarse.suggested_handles[i]) - many.col(fine.suggested_handles[i])).norm() < 2.5 * edge);
    }
    // The edges of a block stay as sharp.
    const Turns of_blocks = turns(make_shape("elephant:vertices=8000").net);
    CHECK(of_blocks.root_mean_square > 0.35);
    CHECK(of_blocks.largest > 1.4);
}

TEST_CASE("A smooth shape has as many vertices as one of the paper, and no narrow corner", "[large]") {
    const auto check = [](const std::string& shape, int vertices) {
        INFO(with_vertices(shape, vertices));
        const Net net = make_shape(with_vertices(shape, vertices)).net;
        CHECK(net.vertex_count() == Approx(vertices).epsilon(0.15));
        CHECK(corner_angle_range(net, net.rest_positions()).smallest > 45 * 3.14159 / 180);
    };
    for (const std::string& shape : smooth_shapes())
        for (const int vertices : {400, 972, 1488, 3462, 4011}) check(shape, vertices);
    for (const std::string shape : {"teddy", "shirt"})
        for (const int vertices : {3895, 6777, 9062}) check(shape, vertices);
    check("teddy", 17699);
}

TEST_CASE("The boundary of any solid is a closed manifold that encloses its cubes") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int trial = 0; trial < k_solids; ++trial) {
        CAPTURE(trial);
        const VoxelSolid solid = random_solid(random);
        if (filled_count(solid) == 0) continue;
        const Net net = boundary_net(solid);
        REQUIRE(is_closed_manifold(net));
        REQUIRE(edge_length_spread(net) == 0);
        REQUIRE(volume(net) == Approx(filled_count(solid)));
    }
}

TEST_CASE("Cubes that touch in an edge or a vertex alone are parted") {
    const Net at_edge = net_of_cells({{0, 0, 0}, {1, 1, 0}}), at_vertex = net_of_cells({{0, 0, 0}, {1, 1, 1}});
    for (const Net* net : {&at_edge, &at_vertex}) {
        CHECK(is_closed_manifold(*net));
        CHECK(net->vertex_count() == 16);
        CHECK(Topology(*net).component_count() == 2);
    }
}

TEST_CASE("Cubes that touch in an edge whose ends join them anyway are joined along it") {
    // Two opposite pillars between full slabs: parted, the pillars' common edge would be there twice.
    std::vector<Eigen::Vector3i> cells{{0, 0, 1}, {1, 1, 1}};
    for (const int z : {0, 2})
        for (const int y : {0, 1})
            for (const int x : {0, 1}) cells.push_back({x, y, z});
    const Net net = net_of_cells(cells);
    CHECK(is_closed_manifold(net));
    CHECK(volume(net) == Approx(10));
}

TEST_CASE("A hollow solid has an inner boundary") {
    std::vector<Eigen::Vector3i> cells;
    for (int cell = 0; cell < 27; ++cell)
        if (cell != 13) cells.push_back({cell % 3, cell / 3 % 3, cell / 9});
    const Net net = net_of_cells(cells);
    CHECK(is_closed_manifold(net));
    CHECK(Topology(net).component_count() == 2);
    CHECK(volume(net) == Approx(26));
}

TEST_CASE("The same recipe gives the same bits, however it is spaced") {
    const Net a = make_shape("vault:rise=0.4,vertices=500").net,
              b = make_shape(" vault : vertices = 500 , rise=.4 ").net;
    CHECK(a.rest_positions() == b.rest_positions());
    CHECK(a.faces().vertices == b.faces().vertices);
}

TEST_CASE("The gallery is complete") {
    std::set<std::string> names;
    for (const ShapeInfo& shape : shape_table()) {
        INFO(shape.name);
        CHECK(names.insert(shape.name).second);
        CHECK(std::string(shape.sentence).back() == '.');
        REQUIRE(!shape.parameters.empty());
        CHECK(std::string(shape.parameters[0].name) == "vertices");
        CHECK(shape.parameters[0].smallest == 100);
        CHECK(shape.parameters[0].largest == 100000);
        for (const ShapeParameter& parameter : shape.parameters) {
            CHECK(parameter.smallest <= parameter.value);
            CHECK(parameter.value <= parameter.largest);
            CHECK(std::string(parameter.sentence).back() == '.');
        }
    }
}

TEST_CASE("A recipe that makes no shape is refused with what is wrong and what is known") {
    const std::string form = "; a recipe is NAME or NAME:key=value,key=value";
    const std::string known =
        "; known are dome, saddle, canopy, vault, wave, sheet, scroll, tube, vase, shirt, teddy, rabbit, horse, jug, "
        "steps, elephant, jack, torus";
    CHECK(recipe_refusal("") == "bad_syntax: the recipe names no shape" + form);
    CHECK(recipe_refusal(":vertices=100") == "bad_syntax: the recipe names no shape" + form);
    CHECK(recipe_refusal("ball") == "bad_option: there is no shape \"ball\"" + known);
    CHECK(recipe_refusal("Dome").rfind("bad_option: there is no shape \"Dome\"", 0) == 0);
    CHECK(recipe_refusal("dome:rise=1") == "bad_option: dome has no parameter \"rise\"; known are vertices, reach");
    CHECK(recipe_refusal("dome:vertices=99") == "bad_option: vertices is \"99\", but goes from 100 to 100000");
    CHECK(recipe_refusal("dome:vertices=100001") == "bad_option: vertices is \"100001\", but goes from 100 to 100000");
    CHECK(recipe_refusal("dome:reach=90") == "bad_option: reach is \"90\", but goes from 10 to 70");
    CHECK(recipe_refusal("vault:rise=-0.1") == "bad_option: rise is \"-0.1\", but goes from 0.02 to 0.6");
    CHECK(recipe_refusal("dome:reach=nan") == "bad_option: reach is \"nan\", but goes from 10 to 70");
    CHECK(recipe_refusal("dome:reach=inf") == "bad_option: reach is \"inf\", but goes from 10 to 70");
    CHECK(recipe_refusal("dome:reach=1e999") == "bad_option: reach is \"1e999\", but goes from 10 to 70");
    CHECK(recipe_refusal("dome:reach=wide") == "bad_syntax: reach is \"wide\", which is not a number" + form);
    CHECK(recipe_refusal("dome:reach=50deg") == "bad_syntax: reach is \"50deg\", which is not a number" + form);
    CHECK(recipe_refusal("dome:reach=") == "bad_syntax: reach is \"\", which is not a number" + form);
    CHECK(recipe_refusal("dome:") == "bad_syntax: \"\" is not key=value" + form);
    CHECK(recipe_refusal("dome:reach") == "bad_syntax: \"reach\" is not key=value" + form);
    CHECK(recipe_refusal("dome:reach=50,") == "bad_syntax: \"\" is not key=value" + form);
    CHECK(recipe_refusal("dome:reach=50=60") == "bad_syntax: \"reach=50=60\" is not key=value" + form);
    CHECK(recipe_refusal("dome:reach=50,reach=60") == "bad_syntax: reach is given twice" + form);
    CHECK(recipe_refusal(std::string(100000, 'x')) == "bad_syntax: the recipe is longer than 1000 characters" + form);
    CHECK(recipe_refusal("d\xF6me\n") == "bad_option: there is no shape \"d?me?\"" + known);
}
