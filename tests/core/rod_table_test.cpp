#include "fabricate/rod_table.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "change/change.h"
#include "change/coarsen.h"
#include "change/refine.h"
#include "csv_cells.h"
#include "drape/drape.h"
#include "net/measures.h"
#include "net/rods.h"
#include "sample_drapes.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "shapes/shapes.h"
#include "surface/gallery.h"

using namespace chebnet;

namespace {

std::string table_of(const Net& net, const Positions& positions) { return rod_table(net, Topology(net), positions); }

}  // namespace

TEST_CASE("A rod table has a header, and a line a rod with its length, its vertices and how far along it they are") {
    Positions x(3, 6);
    x << 0, 1, 2, 0, 1, 2,  //
        0, 0, 0, 1, 1, 1,   //
        0, 0, 0, 0, 0, 0;
    Faces faces;
    faces.add({0, 1, 4, 3});
    faces.add({1, 2, 5, 4});
    const Net net(x, faces, RestLengths::own);
    CHECK(table_of(net, 2 * x) ==
          "rod,edges,length,closed,vertices,marks\n"
          "0,2,4,0,0 1 2,0 2 4\n"
          "1,1,2,0,0 3,0 2\n"
          "2,1,2,0,1 4,0 2\n"
          "3,1,2,0,2 5,0 2\n"
          "4,2,4,0,3 4 5,0 2 4\n");
}

TEST_CASE("Every edge of a net that nothing has cut lies on one rod, and those around a tube are closed") {
    const Net tube = make_shape("tube:vertices=300").net;
    int edges = 0, closed = 0;
    for (const std::vector<std::string>& row : samples::cells_of(table_of(tube, tube.rest_positions()))) {
        REQUIRE(row.size() == 6);
        edges += std::stoi(row[1]);
        closed += std::stoi(row[3]);
        CHECK(std::stod(row[2]) == Approx(std::stoi(row[1]) * tube.mean_length()).epsilon(1e-4));
    }
    CHECK(edges == tube.edge_count());
    CHECK(closed > 0);
}

TEST_CASE("Rods around a tube are told to be closed where they pass inward corners, too") {
    // Every second ring of faces has a window of one of them, where rods begin.
    const int around = 12, along = 8;
    const Mesh tube = samples::cylinder(around, along, 2);
    Faces faces;
    for (int f = 0; f < tube.faces.size(); ++f)
        if (f % around != 0 || f / around % 2 == 0) faces.add(tube.faces[f]);
    const Net net(tube.positions, faces, RestLengths::equal);
    int closed = 0, loops = 0;
    for (const std::vector<std::string>& row : samples::cells_of(table_of(net, net.rest_positions()))) {
        closed += std::stoi(row[3]);
        loops += std::stoi(row[1]) == around ? 1 : 0;
    }
    CHECK(closed == along);
    CHECK(loops == along);
}

TEST_CASE("Where the border of a surface has cut a net, the edges along it are of no rod") {
    const Surface hemisphere = make_own_surface("hemisphere");
    const SurfaceTree tree(hemisphere);
    DrapeOptions options = suggested_drape(hemisphere, tree, 300);
    options.border = DrapeOptions::Border::cut;
    const Net net = drape(hemisphere, tree, options).net;
    const DrapeReport report = measure_drape(hemisphere, tree, net);
    const auto rows = samples::cells_of(table_of(net, net.rest_positions()));
    CHECK(std::ssize(rows) == report.rods);
    CHECK(std::ssize(rows) < std::ssize(Topology(net).net_lines()));
    CHECK(is_cut(net, Topology(net)));
    CHECK(shared_length(net).value() == Approx(options.length));
    CHECK_THROWS_WITH(refined(net, {}), Catch::Matchers::Contains("half the length"));
    CHECK_THROWS_WITH(coarsened(net, {}), Catch::Matchers::Contains("twice the length"));
    double length = 0;
    for (const std::vector<std::string>& row : rows) length += std::stod(row[2]);
    CHECK(length == Approx(report.rod_length));
}

TEST_CASE("Along a straight border rods keep their cut ends, and what joins the ends of others is no rod") {
    // Rods end 0.015 behind the last that crosses them; up and down the border is too near for another edge.
    const auto rectangle = [](double width, double height) {
        Mesh mesh{Positions::Zero(3, 4), {}};
        mesh.positions.row(0) << -width / 2, width / 2, width / 2, -width / 2;
        mesh.positions.row(1) << -height / 2, -height / 2, height / 2, height / 2;
        mesh.faces.add({0, 1, 2});
        mesh.faces.add({0, 2, 3});
        return Surface(mesh);
    };
    const Surface panel = rectangle(1.03, 1.006);
    const SurfaceTree tree(panel);
    DrapeOptions options;
    options.length = 0.1;
    options.border = DrapeOptions::Border::cut;
    const Net net = drape(panel, tree, options).net;
    int level = 0, upright = 0;
    for (const std::vector<std::string>& row : samples::cells_of(table_of(net, net.rest_positions()))) {
        const double length = std::stod(row[2]);
        level += length == Approx(1.03) ? 1 : 0;
        upright += length == Approx(1.0) ? 1 : 0;
        CHECK(row[3] == "0");
    }
    CHECK(level == 11);
    CHECK(upright == 11);
    CHECK(rods(net, Topology(net)).size() == 22);
}

TEST_CASE("A rod ends where a rim goes on from it, and is whole where rims join it at its ends") {
    // Three whole cells in a row. Beyond the last the border cuts from one corner to the middle of the far side, and
    // before the first both rods go on a little.
    Positions x = Positions::Zero(3, 11);
    x.leftCols(8).row(0) << 0, 1, 2, 3, 0, 1, 2, 3;
    x.leftCols(8).row(1) << 0, 0, 0, 0, 1, 1, 1, 1;
    x.col(8) << -0.4, 0, 0;
    x.col(9) << -0.4, 1, 0;
    x.col(10) << 3.6, 0, 0;
    Faces faces;
    for (int k = 0; k < 3; ++k) faces.add({k, k + 1, k + 5, k + 4});
    faces.add({8, 0, 4, 9});
    faces.add({3, 10, 7});
    const Net net(x, faces, RestLengths::own);
    const auto lines = rods(net, Topology(net));
    const auto has = [&](const std::vector<int>& rod) {
        const std::vector<int> backwards(rod.rbegin(), rod.rend());
        return std::count(lines.begin(), lines.end(), rod) + std::count(lines.begin(), lines.end(), backwards) == 1;
    };
    CHECK(has({8, 0, 1, 2, 3, 10}));
    CHECK(has({9, 4, 5, 6, 7}));
    for (int k = 0; k < 4; ++k) CHECK(has({k, k + 4}));
    CHECK(lines.size() == 6);
}

TEST_CASE("Rims are of no rod where a border has cut most edges of a net of few cells") {
    const Surface hemisphere = make_own_surface("hemisphere");
    const SurfaceTree tree(hemisphere);
    for (const int cells : {8, 10, 12, 15}) {
        DrapeOptions options = suggested_drape(hemisphere, tree, cells);
        options.border = DrapeOptions::Border::cut;
        const Net net = drape(hemisphere, tree, options).net;
        const Topology topology(net);
        REQUIRE_FALSE(shared_length(net));
        CHECK(whole_length(net) == Approx(options.length));
        CHECK(is_cut(net, topology));
        const auto lines = rods(net, topology);
        CHECK(lines == rods(net, topology, options.length));
        // Every edge between two faces is of one; of the others none is of length L here.
        int edges = 0, between = 0;
        for (const std::vector<int>& line : lines) edges += static_cast<int>(line.size()) - 1;
        for (int e = 0; e < net.edge_count(); ++e) between += net.edge_face_counts()[e] == 2 ? 1 : 0;
        CHECK(edges >= between);
        CHECK(edges < net.edge_count());
        CHECK(lines.size() < topology.net_lines(InwardCorners::pass).size());
    }
}

TEST_CASE("Every whole edge of a net that was cut is of a rod, and no edge from one end to another is") {
    std::mt19937 random(11);  // NOLINT(cert-msc51-cpp): the same nets each time
    std::uniform_int_distribution<int> cells(20, 200);
    int whole = 0, rims = 0;
    for (const char* const name : {"hemisphere", "shell", "hypar"}) {
        const Surface surface = make_own_surface(name);
        const SurfaceTree tree(surface);
        for (int k = 0; k < 60; ++k) {
            DrapeOptions options = suggested_drape(surface, tree, cells(random));
            options.seed = surface.position_at(samples::random_place(surface, random));
            options.direction = samples::random_point(1, random);
            options.border = DrapeOptions::Border::cut;
            const std::optional<Drape> draped = samples::drape_if_any(surface, tree, options);
            if (!draped) continue;
            const Net& net = draped->net;
            const Topology topology(net);
            std::vector<bool> is_of_rod(static_cast<std::size_t>(net.edge_count()));
            for (const std::vector<int>& rod : rods(net, topology, options.length))
                for (std::size_t i = 1; i < rod.size(); ++i)
                    is_of_rod[topology.edge_between(rod[i - 1], rod[i])] = true;
            const int first_end = net.vertex_count() - draped->cut_ends;
            for (int e = 0; e < net.edge_count(); ++e) {
                const int a = net.edges()(0, e), b = net.edges()(1, e);
                const int steps = (draped->places.col(a) - draped->places.col(b)).cwiseAbs().sum();
                if (b < first_end && steps == 1) {
                    CHECK(is_of_rod[e]);
                    ++whole;
                } else if (a >= first_end) {
                    CHECK_FALSE(is_of_rod[e]);
                    ++rims;
                }
            }
        }
    }
    CHECK(whole > 10'000);
    CHECK(rims > 1000);
}

TEST_CASE("A side that is as long as whole edges is of a rod where another may be the rim, though less square") {
    // A sliver along a whole edge, joined to a cut cell by a rod that ends 0.085 behind it.
    Positions x = Positions::Zero(3, 5);
    x.col(1) << 1, 0, 0;
    x.col(2) << 0.085 * std::cos(85 * k_degree), 0.085 * std::sin(85 * k_degree), 0;
    x.col(3) << -0.9, 0, 0;
    x.col(4) << -0.9, 0.2, 0;
    Faces faces;
    faces.add({0, 1, 2});
    faces.add({3, 0, 2, 4});
    const Net net(x, faces, RestLengths::own);
    const Topology topology(net);
    REQUIRE(net.rest_lengths()[topology.edge_between(1, 2)] < 1);
    const std::vector<bool> is_rod = rod_edges(net, topology, 1);
    CHECK(is_rod[topology.edge_between(0, 1)]);
    CHECK_FALSE(is_rod[topology.edge_between(1, 2)]);
}

TEST_CASE("What is a rod of a net that a border has cut is one also where the net is cut apart beside it") {
    int cuts = 0;
    for (const char* const name : {"hypar", "hemisphere"}) {
        const Surface surface = make_own_surface(name);
        const SurfaceTree tree(surface);
        for (const int cells : {60, 100, 150}) {
            DrapeOptions options = suggested_drape(surface, tree, cells);
            options.direction = {1, 1, 0};
            options.border = DrapeOptions::Border::cut;
            const Net net = drape(surface, tree, options).net;
            const Topology topology(net);
            const std::vector<bool> before = rod_edges(net, topology, options.length);
            for (const std::vector<int>& line : topology.net_lines()) {
                ChangePlace place;
                for (std::size_t k = 1; k < line.size(); ++k)
                    if (const int e = topology.edge_between(line[k - 1], line[k]); net.edge_face_counts()[e] == 2)
                        place.edges.push_back(e);
                if (place.edges.empty()) continue;
                const ChangedMesh changed = find_change("cut").make(net, place);
                const Net parts(changed.mesh.positions, changed.mesh.faces, RestLengths::own);
                const std::vector<bool> after = rod_edges(parts, Topology(parts), options.length);
                int misread = 0;
                for (int e = 0; e < parts.edge_count(); ++e) {
                    const int a = changed.origins[parts.edges()(0, e)], b = changed.origins[parts.edges()(1, e)];
                    misread += after[e] != before[topology.edge_between(a, b)] ? 1 : 0;
                }
                INFO(name << " of " << cells << " cells, cut from vertex " << line.front() << " to " << line.back());
                CHECK(misread == 0);
                ++cuts;
            }
        }
    }
    CHECK(cuts > 100);
}

TEST_CASE("Rims are of no rod in a ribbon about as wide as an edge is long, though nothing says that length") {
    int narrow = 0;
    for (const double width : {0.9, 1.1, 1.3, 1.5, 1.8, 2.1, 2.4, 2.8}) {
        const Surface ribbon(samples::quads(49, 5, false, false, [&](int i, int j) {
            return Eigen::Vector3d(12 * (i / 48. - 0.5), width * (j / 4. - 0.5), 0);
        }));
        const SurfaceTree tree(ribbon);
        for (int degrees = 5; degrees < 90; degrees += 8) {
            DrapeOptions options;
            options.length = 1;
            options.border = DrapeOptions::Border::cut;
            options.direction = {std::cos(degrees * k_degree), std::sin(degrees * k_degree), 0};
            const Net net = drape(ribbon, tree, options).net;
            const Topology topology(net);
            INFO(width << " wide, " << degrees << " degrees");
            CHECK(rods(net, topology) == rods(net, topology, options.length));
            narrow += shared_length(net) ? 0 : 1;
        }
    }
    CHECK(narrow > 20);
}

TEST_CASE("Net lines along the border of a strip of two lengths stay rods, also where triangles end it") {
    // Two rows of rectangles, their long sides along the strip, and in each row a triangle behind the last one.
    Positions x = Positions::Zero(3, 16);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 5; ++column) x.col(5 * row + column) << 1.3 * column, row, 0;
    x.col(15) << 6, 1, 0;
    Faces faces;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 4; ++column) {
            const int corner = 5 * row + column;
            faces.add({corner, corner + 1, corner + 6, corner + 5});
        }
    faces.add({4, 15, 9});
    faces.add({9, 15, 14});
    const Net net(x, faces, RestLengths::own);
    const Topology topology(net);
    REQUIRE_FALSE(shared_length(net));
    CHECK_FALSE(is_cut(net, topology));
    CHECK(rods(net, topology) == topology.net_lines(InwardCorners::pass));
}

TEST_CASE("Edges that have no length in common leave every net line a rod, also along the border") {
    std::mt19937 random(3);  // NOLINT(cert-msc51-cpp): the same mesh each time
    const Net even = samples::patch(5, 4);
    const Net uneven(samples::shaken(even.rest_positions(), 0.1, random), even.faces(), RestLengths::own);
    CHECK_FALSE(shared_length(uneven));
    CHECK_FALSE(is_cut(uneven, Topology(uneven)));
    CHECK(rods(uneven, Topology(uneven)) == Topology(uneven).net_lines());
    CHECK(shared_length(even).value() == even.mean_length());
    CHECK(rods(even, Topology(even)) == Topology(even).net_lines());
}
