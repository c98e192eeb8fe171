#include "edit/handle_graph.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <vector>

#include "edit/editor.h"
#include "sample_nets.h"

using namespace chebnet;

namespace {

std::vector<int> some_vertices(const Net& net, int count, std::mt19937& random) {
    std::vector<int> vertices(static_cast<std::size_t>(net.vertex_count()));
    std::iota(vertices.begin(), vertices.end(), 0);
    std::shuffle(vertices.begin(), vertices.end(), random);
    vertices.resize(static_cast<std::size_t>(count));
    return vertices;
}

/// A patch of quads, half of them cut into triangles, whose edges have the lengths a shaken patch has.
Net uneven_patch(int m, int n, std::mt19937& random) {
    const Net patch = samples::patch(m, n);
    Faces faces;
    for (int f = 0; f < patch.face_count(); ++f) {
        const std::span<const int> face = patch.faces()[f];
        if (random() % 2 == 0) {
            faces.add(face);
            continue;
        }
        faces.add({face[0], face[1], face[2]});
        faces.add({face[2], face[3], face[0]});
    }
    return Net(samples::shaken(patch.rest_positions(), 0.3, random), faces, RestLengths::own);
}

/// The largest |t_i − t_j| / d_ij over all pairs of handles.
double largest_strain(const Topology& topology, const std::vector<int>& vertices, const Positions& targets) {
    double largest = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::vector<double> distance = topology.distances_from(vertices[i]);
        for (std::size_t j = 0; j < vertices.size(); ++j)
            if (i != j)
                largest = std::max(
                    largest,
                    (targets.col(static_cast<Eigen::Index>(i)) - targets.col(static_cast<Eigen::Index>(j))).norm() /
                        distance[vertices[j]]);
    }
    return largest;
}

double largest_strain(const HandleGraph& graph, const Positions& targets) {
    double largest = 0;
    for (int i = 0; i < graph.size(); ++i)
        for (const auto& [j, distance] : graph.neighbours(i))
            largest = std::max(largest, (targets.col(i) - targets.col(j)).norm() / distance);
    return largest;
}

/// A pair is one of neighbours if an edge joins it or no third handle lies on a shortest path.
void check_against_all_pairs(const Net& net, const std::vector<int>& vertices) {
    const Topology topology(net);
    const HandleGraph graph(net, topology, vertices);
    REQUIRE(graph.size() == static_cast<int>(vertices.size()));
    std::vector<std::vector<double>> d;
    for (int v : vertices) d.push_back(topology.distances_from(v));
    for (int i = 0; i < graph.size(); ++i) {
        std::vector<int> expected;
        for (int j = 0; j < graph.size(); ++j) {
            if (i == j || !std::isfinite(d[i][vertices[j]])) continue;
            const auto is_between = [&](int k) {
                return k != i && k != j && d[i][vertices[k]] + d[k][vertices[j]] < (1 + 1e-9) * d[i][vertices[j]];
            };
            bool needed = std::ranges::count(topology.neighbours(vertices[i]), vertices[j]) > 0;
            if (!needed) {
                needed = true;
                for (int k = 0; k < graph.size() && needed; ++k) needed = !is_between(k);
            }
            if (needed) expected.push_back(j);
        }
        std::vector<int> found;
        for (const auto& [j, distance] : graph.neighbours(i)) {
            found.push_back(j);
            CHECK(distance == Approx(d[i][vertices[j]]).epsilon(1e-12));
        }
        CHECK(found == expected);
    }
}

}  // namespace

TEST_CASE("Neighbours of handles are those that all pairs of shortest paths say") {
    const unsigned seed = GENERATE(range(1u, 13u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const int count = 2 + static_cast<int>(random() % 60);
    for (const Net& net :
         {samples::patch(11, 9), samples::ring(12, 7, true), samples::mixed_mesh(), uneven_patch(11, 9, random)})
        check_against_all_pairs(net, some_vertices(net, std::min(count, net.vertex_count()), random));
}

TEST_CASE("Some pair of neighbours is strained as much as any pair of handles") {
    const unsigned seed = GENERATE(range(1u, 41u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = seed % 2 == 0 ? samples::patch(14, 11) : uneven_patch(14, 11, random);
    const Topology topology(net);
    const std::vector<int> vertices = some_vertices(net, 3 + static_cast<int>(random() % 50), random);
    const HandleGraph graph(net, topology, vertices);
    Positions targets(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i)
        targets.col(static_cast<Eigen::Index>(i)) = net.rest_positions().col(vertices[i]);
    targets = samples::shaken(targets, 4, random);
    CHECK(largest_strain(graph, targets) == Approx(largest_strain(topology, vertices, targets)).epsilon(1e-9));
}

TEST_CASE("Handles of several pieces, and those that bound nothing, are no one's neighbours") {
    const Net patch = samples::patch(5, 5);
    Positions x(3, 50);
    x << patch.rest_positions(), patch.rest_positions();
    Faces faces = patch.faces();
    for (int f = 0; f < patch.face_count(); ++f) {
        std::vector<int> face(patch.faces()[f].begin(), patch.faces()[f].end());
        for (int& v : face) v += 25;
        faces.add(face);
    }
    const Net net(x, faces);
    const HandleGraph graph(net, Topology(net), std::vector{0, -1, 24, 25});
    REQUIRE(graph.neighbours(0).size() == 1);
    CHECK(graph.neighbours(0)[0].handle == 2);
    CHECK(graph.neighbours(1).empty());
    CHECK(graph.neighbours(3).empty());
}

TEST_CASE("Twenty thousand handles on a large net are bounded in a moment and little memory") {
    // All pairs of their distances would fill 3.2 GB.
    std::mt19937 random(5);
    Editor editor(samples::patch(320, 320));
    editor.set_handles(samples::handles_at_rest(editor.net(), some_vertices(editor.net(), 20'000, random)));
    const HandleGraph& graph = editor.handle_graph();
    std::size_t neighbours = 0;
    for (int i = 0; i < graph.size(); ++i) {
        CHECK_FALSE(graph.neighbours(i).empty());
        neighbours += graph.neighbours(i).size();
    }
    CHECK(neighbours < 50 * 20'000u);
    CHECK(editor.unreachable_pairs().empty());
    const Handle moved = editor.handles().front();
    editor.move_handle(moved.vertex, moved.target + Eigen::Vector3d(0, 0, 1000));
    REQUIRE_FALSE(editor.unreachable_pairs().empty());
    const UnreachablePair worst = editor.unreachable_pairs().front();
    CHECK((worst.vertex_a == moved.vertex || worst.vertex_b == moved.vertex));
}

TEST_CASE("Where every handle bounds every other, each keeps its nearest within the bounds of time and memory") {
    // The rim of a fan: two steps from anywhere to anywhere, by the hub.
    constexpr int rim = 20'000;
    Positions x = Positions::Zero(3, rim + 1);
    Faces faces;
    std::vector<int> vertices;
    for (int i = 1; i <= rim; ++i) {
        const double angle = 2 * EIGEN_PI * i / rim;
        x.col(i) << std::cos(angle), std::sin(angle), 0;
        faces.add({0, i, i % rim + 1});
        vertices.push_back(i);
    }
    const Net net(x, faces, RestLengths::equal);
    const HandleGraph graph(net, Topology(net), vertices);
    std::size_t neighbours = 0;
    for (int i = 0; i < graph.size(); ++i) {
        CHECK(graph.neighbours(i).size() >= 2);
        neighbours += graph.neighbours(i).size();
    }
    CHECK(neighbours <= 2 * (HandleGraph::k_most_neighbours + 2 * rim));
}
