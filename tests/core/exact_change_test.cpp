#include "edit/exact_change.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "net/topology.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

/// The largest dL of the mesh's edges against this length.
double deviation_from(double length, const Positions& positions, const ChangedMesh& changed) {
    const Net net(positions, changed.mesh.faces, RestLengths::own);
    const Eigen::ArrayXd ratio = net.rest_lengths().array() / length;
    return (ratio + 1 / ratio - 2).maxCoeff();
}

/// Without the net line that runs across a patch of m columns through this vertex of its first row.
ChangedMesh without_column(const Net& patch, int m, int column) {
    const Topology topology(patch);
    std::vector<int> edges;
    for (int v = column; v + m < patch.vertex_count(); v += m) edges.push_back(topology.edge_between(v, v + m));
    return find_change("remove_line").make(patch, {{}, edges});
}

}  // namespace

TEST_CASE("A changed net gets the length of before times the change's factor, and what is held stays") {
    const Net net = make_shape("dome:vertices=200").net;
    const ChangedMesh finer = find_change("refine").make(net, {});
    const std::vector<int> held = {0, 150};
    ExactChange exact(finer, {.length = net.mean_length(), .held = held});
    REQUIRE(exact.solve().status == Status::converged);
    CHECK(deviation_from(net.mean_length() / 2, exact.positions(), finer) < k_equal_deviation);
    for (const int vertex : held) CHECK(exact.positions().col(vertex) == net.rest_positions().col(vertex));
}

TEST_CASE("Where no net is found with what is held, all of it is free") {
    const int m = 6;
    const Net flat = samples::patch(m, 4, 0);
    const ChangedMesh narrower = without_column(flat, m, 2);
    // Two ends of a row, which is an edge shorter than they are apart.
    ExactChange exact(narrower, {.length = 1.0, .held = {0, m - 1}});
    REQUIRE(exact.solve().status == Status::converged);
    CHECK(deviation_from(1, exact.positions(), narrower) < k_equal_deviation);
    CHECK((exact.positions().col(0) - exact.positions().col(m - 2)).norm() < m - 2 + 1e-6);
}

TEST_CASE("What is held stays where only a net with corners sharper than the limit is found so") {
    const int m = 6;
    const double sharp = 25 * EIGEN_PI / 180;
    Positions x = samples::patch(m, m, 0).rest_positions();
    for (auto point : x.colwise()) point << point.x() + std::cos(sharp) * point.y(), std::sin(sharp) * point.y(), 0;
    const Net sheared(x, samples::patch(m, m, 0).faces());
    const ChangedMesh finer = find_change("refine").make(sheared, {});
    const std::vector<int> held = {14, 15, 20};  // one corner of a quad, of 155 degrees at 14
    ExactChange exact(finer, {.length = 1.0, .held = held});
    CHECK(exact.solve().status == Status::exact);
    CHECK(deviation_from(0.5, exact.positions(), finer) < k_equal_deviation);
    for (const int vertex : held) CHECK(exact.positions().col(vertex) == sheared.rest_positions().col(vertex));
}

TEST_CASE("A changed net whose edges have a length each stays as it is") {
    const Net net = samples::ring(6, 5, true);
    const ChangedMesh finer = find_change("refine").make(net, {});
    ExactChange exact(finer);
    const ExactChangeReport report = exact.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.iterations == 0);
    CHECK(exact.positions() == finer.mesh.positions);
}

TEST_CASE("A changed net is made exact bit by bit as in one go, and iterations go on being counted") {
    const int m = 6;
    const Net flat = samples::patch(m, 4, 0);
    const ChangedMesh narrower = without_column(flat, m, 2);
    const ExactChangeOptions options{.length = 1.0, .held = {0, m - 1}};
    ExactChange in_one_go(narrower, options), bit_by_bit(narrower, options);
    const ExactChangeReport expected = in_one_go.solve();
    ExactChangeReport report;
    while (report.status == Status::running) {
        const int before = report.iterations;
        report = bit_by_bit.solve({.iterations = 1});
        REQUIRE(report.iterations >= before);
    }
    CHECK(report.status == expected.status);
    CHECK(report.iterations == expected.iterations);
    CHECK(bit_by_bit.positions() == in_one_go.positions());
}
