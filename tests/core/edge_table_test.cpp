#include "fabricate/edge_table.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/number.h"
#include "csv_cells.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

Net square(double size) {
    Positions positions(3, 4);
    positions << 0, size, size, 0,  //
        0, 0, size, size,           //
        0, 0, 0, 0;
    Faces faces;
    faces.add({0, 1, 2, 3});
    return Net(std::move(positions), std::move(faces));
}

/// The numbers of each line but the header.
std::vector<std::vector<double>> rows(const std::string& table) {
    std::vector<std::vector<double>> rows;
    for (const std::vector<std::string>& cells : samples::cells_of(table)) {
        rows.emplace_back();
        for (const std::string& cell : cells) rows.back().push_back(parse_number(cell).value());
    }
    return rows;
}

}  // namespace

TEST_CASE("An edge table has a header, and a line an edge with its ends, lengths and deviation") {
    const Net net = square(2);
    Positions positions = net.rest_positions();
    positions(0, 1) = 0.5;  // vertex 1 moves towards vertex 0
    CHECK(edge_table(net, positions) ==
          "edge,vertex_a,vertex_b,length,rest_length,deviation\n"
          "0,0,1,0.5,2,2.25\n"
          "1,0,3,2,2,0\n"
          "2,1,2,2.5,2,0.05\n"
          "3,2,3,2,2,0\n");
}

TEST_CASE("An edge table brings every number back exactly") {
    const Net net = make_shape("dome:vertices=300").net;
    const Positions positions = net.rest_positions() * (1 + 1 / 3.0);
    const auto table = rows(edge_table(net, positions));
    REQUIRE(static_cast<int>(table.size()) == net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = net.edges()(0, e), b = net.edges()(1, e);
        const double length = (positions.col(a) - positions.col(b)).stableNorm(), rest = net.rest_lengths()(e);
        CHECK(table[e] == std::vector<double>{double(e), double(a), double(b), length, rest, deviation(length / rest)});
    }
}

TEST_CASE("An edge table measures edges that are tiny, huge or without length") {
    for (const double size : {1e-140, 1e140}) {
        const Net net = square(size);
        for (const auto& row : rows(edge_table(net, net.rest_positions()))) {
            CHECK(row[3] == Approx(size));
            CHECK(row[5] < 1e-15);
        }
    }
    const Net net = square(1);
    const auto table = rows(edge_table(net, Positions::Zero(3, 4)));
    for (const auto& row : table) {
        CHECK(row[3] == 0);
        CHECK(row[5] == std::numeric_limits<double>::infinity());
    }
}
