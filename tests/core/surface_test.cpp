#include "surface/surface.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

#include "constants.h"
#include "drape/surface_report.h"
#include "mesh_files.h"
#include "sample_surfaces.h"
#include "surface/inside_out.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using samples::refusal_of;

namespace {

/// Three triangles around vertex 0 of a tetrahedron without its floor.
Mesh tent() {
    Mesh mesh{Positions(3, 4), {}};
    mesh.positions << 0, 1, 0, -1,  //
        0, 0, 1, -1,                //
        1, 0, 0, 0;
    for (const auto& [a, b] : {std::pair(1, 2), std::pair(2, 3), std::pair(3, 1)}) mesh.faces.add({0, a, b});
    return mesh;
}

std::string refusal_of(const Mesh& mesh) {
    return samples::refusal_of([&] { Surface{mesh}; });
}

Mesh with_coordinate(Mesh mesh, double coordinate) {
    mesh.positions(0, 2) = coordinate;
    return mesh;
}

/// A strip that has been turned by half a turn before its ends were joined.
Mesh moebius_strip() {
    Mesh mesh = samples::quads(2, 12, false, false, [](int i, int j) {
        const double u = 2 * samples::k_pi * j / 12;
        const double across = 0.3 * (2 * i - 1);
        return Eigen::Vector3d((1 + across * std::cos(u / 2)) * std::cos(u),
                               (1 + across * std::cos(u / 2)) * std::sin(u), across * std::sin(u / 2));
    });
    mesh.faces.add({22, 23, 0, 1});
    return mesh;
}

}  // namespace

TEST_CASE("Neighbours are found across sides and around vertices") {
    const Surface surface(tent());
    CHECK(surface.face_count() == 3);
    int boundary_sides = 0;
    for (int side = 0; side < 9; ++side) {
        const int opposite = surface.opposite(side);
        if (opposite < 0) {
            ++boundary_sides;
            continue;
        }
        CHECK(surface.opposite(opposite) == side);
        CHECK(surface.from(opposite) == surface.to(side));
        CHECK(surface.to(opposite) == surface.from(side));
    }
    CHECK(boundary_sides == 3);
    CHECK_FALSE(surface.is_boundary(0));
    const int first = surface.first_side(0);
    CHECK(surface.around(surface.around(surface.around(first))) == first);
    for (int v = 1; v < 4; ++v) {
        CHECK(surface.is_boundary(v));
        CHECK(surface.from(surface.first_side(v)) == v);
        CHECK(surface.around(surface.around(surface.first_side(v))) == -1);
    }
    const auto loops = surface.boundary_loops();
    REQUIRE(loops.size() == 1);
    CHECK(loops[0].size() == 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(surface.to(loops[0][k]) == surface.from(loops[0][(k + 1) % 3]));
}

TEST_CASE("A walk around a vertex comes to each of its sides once, counterclockwise") {
    const Surface half(samples::sphere(6, true));
    std::vector<int> met(3 * static_cast<std::size_t>(half.face_count()), 0);
    for (int v = 0; v < half.vertex_count(); ++v) {
        int before = -1;
        std::vector<int> faces;
        for (const int side : half.sides_around(v)) {
            CHECK(half.from(side) == v);
            CHECK(side == (before < 0 ? half.first_side(v) : half.around(before)));
            ++met[side];
            faces.push_back(Surface::face_of(side));
            before = side;
        }
        CHECK(half.faces_around(v) == faces);
    }
    CHECK(std::count(met.begin(), met.end(), 1) == std::ssize(met));
}

TEST_CASE("A walk around a vertex may begin anywhere, and ends at the boundary") {
    const Surface surface(tent());
    for (int side = 0; side < 9; ++side) {
        std::vector<int> sides;
        for (const int s : surface.sides_from(side)) sides.push_back(s);
        CHECK(sides.front() == side);
        if (surface.from(side) == 0)
            CHECK(sides.size() == 3);
        else
            CHECK(sides.size() == (surface.first_side(surface.from(side)) == side ? 2 : 1));
    }
}

TEST_CASE("Polygons are cut, along the shorter diagonal of a quad") {
    Mesh mesh{Positions(3, 4), {}};
    mesh.positions << 0, 2, 3, 1,  //
        0, 0, 1, 1,                //
        0, 0, 0, 0;
    mesh.faces.add({0, 1, 2, 3});
    const Surface surface(mesh);
    CHECK(surface.face_count() == 2);
    CHECK(surface.area() == Approx(2));
    for (int f = 0; f < 2; ++f) {
        const Eigen::Vector3i t = surface.triangles().col(f);
        CHECK((t.array() == 1).any());
        CHECK((t.array() == 3).any());
        CHECK(surface.face_normals().col(f) == Eigen::Vector3d::UnitZ());
    }
}

TEST_CASE("Pieces that touch at a vertex only are parted there") {
    Mesh mesh{Positions(3, 5), {}};
    mesh.positions << 0, 1, 1, -1, -1,  //
        0, -1, 1, 1, -1,                //
        0, 0, 0, 0, 0;
    mesh.faces.add({0, 1, 2});
    mesh.faces.add({0, 3, 4});
    const Surface surface(mesh);
    CHECK(surface.vertex_count() == 6);
    CHECK(surface.positions().col(5) == surface.positions().col(0));
    CHECK(surface.components() == std::vector{0, 1});
    CHECK(surface.boundary_loops().size() == 2);
    CHECK(describe(surface).genus == 0);
}

TEST_CASE("Vertex normals of a sphere point outwards exactly") {
    const Surface surface(samples::sphere(6));
    CHECK((surface.vertex_normals() - surface.positions()).cwiseAbs().maxCoeff() < 1e-12);
    const SurfacePoint point{5, {0.2, 0.3, 0.5}};
    CHECK((surface.normal_at(point) - surface.position_at(point).normalized()).norm() < 1e-12);
}

TEST_CASE("A surface refuses what is none, and says where") {
    const double huge = 1e60, nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal_of(Mesh{Positions::Zero(3, 3), {}}) == "no_faces the surface has no face");
    CHECK_THAT(refusal_of(samples::with_face(tent(), {1, 2, 9})), Contains("index_out_of_range") && Contains("face 3"));
    CHECK_THAT(refusal_of(samples::with_face(Mesh{Positions(3, 0), {}}, {0, 1, 2})), Contains("index_out_of_range"));
    CHECK_THAT(refusal_of(samples::with_face(tent(), {1, 2, 1})), Contains("repeated_vertex") && Contains("vertex 1"));
    CHECK_THAT(refusal_of(samples::with_face(samples::with_face(tent(), {0, 1, 2, 3}), {0, 1, 0, 2})),
               Contains("face 4 names vertex 0 twice"));
    CHECK_THAT(refusal_of(samples::with_face(tent(), {1, 2})), Contains("small_face"));
    CHECK_THAT(refusal_of(with_coordinate(tent(), nan)), Contains("non_finite") && Contains("vertex 2"));
    CHECK_THAT(refusal_of(with_coordinate(tent(), huge)), Contains("bad_scale"));
    CHECK_THAT(refusal_of(samples::with_face(samples::with_face(tent(), {1, 2, 3}), {0, 1, 3})),
               Contains("non_manifold_edge"));
    CHECK_THAT(refusal_of(samples::with_face(tent(), {1, 2, 3})),
               Contains("wind against each other") && Contains("edge 1-2"));
    CHECK_THAT(refusal_of(samples::with_face(tent(), {1, 2, 3})), !Contains("one side"));
    CHECK_THAT(refusal_of(moebius_strip()), Contains("wind against each other") && Contains("one side only"));
    Mesh loose = tent();
    loose.positions.conservativeResize(3, 5);
    loose.positions.col(4).setOnes();
    CHECK_THAT(refusal_of(loose), Contains("unused_vertex") && Contains("vertex 4"));
    Mesh collapsed = tent();
    collapsed.positions.col(2) = collapsed.positions.col(1);
    CHECK_THAT(refusal_of(collapsed), Contains("zero_length_edge") && Contains("1-2"));
}

TEST_CASE("A surface is repaired only as asked for, and all of it is told") {
    Mesh loose = tent();
    loose.faces = {};
    loose.faces.add({0, 1, 2});
    loose.faces.add({0, 3, 2});
    loose.faces.add({0, 3, 1});
    CHECK_THAT(samples::refusal_of([&] { repaired_surface(loose, {Defect::unused_vertices}); }),
               Contains("wind against each other"));
    const RepairedSurface repaired = repaired_surface(loose, k_all_defects);
    CHECK(repaired.surface.face_count() == 3);
    REQUIRE(repaired.findings.size() == 1);
    CHECK(repaired.findings[0].defect == Defect::inconsistent_winding);
    CHECK(repaired.findings[0].examples == std::vector{1});
}

TEST_CASE("A hole stays a hole") {
    Mesh mesh = samples::sphere(4);
    Faces open;
    for (int f = 1; f < mesh.faces.size(); ++f) open.add(mesh.faces[f]);
    mesh.faces = open;
    const RepairedSurface repaired = repaired_surface(mesh, k_all_defects);
    CHECK(repaired.findings.empty());
    CHECK(repaired.surface.boundary_loops().size() == 1);
}

TEST_CASE("Closed pieces that wind with their normals inwards are found, each with what lies within it") {
    const auto ball = [](double radius, double x, bool turned) {
        Mesh mesh = samples::sphere(4);
        mesh.positions *= radius;
        mesh.positions.row(0).array() += x;
        Faces faces;
        for (int f = 0; f < mesh.faces.size(); ++f) {
            const std::span<const int> face = mesh.faces[f];
            turned ? faces.add({face[2], face[1], face[0]}) : faces.add(face);
        }
        return Mesh{mesh.positions, faces};
    };
    // Of each piece whether it is found.
    const auto found = [](const std::vector<Mesh>& pieces) {
        Mesh all{Positions(3, 0), {}};
        std::vector<int> last;  // triangles
        for (const Mesh& piece : pieces) {
            const auto count = static_cast<int>(all.positions.cols());
            all.positions.conservativeResize(3, count + piece.positions.cols());
            all.positions.rightCols(piece.positions.cols()) = piece.positions;
            for (int f = 0; f < piece.faces.size(); ++f)
                all.faces.add({piece.faces[f][0] + count, piece.faces[f][1] + count, piece.faces[f][2] + count});
            last.push_back(all.faces.size() - 1);
        }
        const std::vector<bool> faces = faces_inside_out(Surface(all));
        std::vector<bool> result;
        for (const int f : last) result.push_back(!faces.empty() && faces[f]);
        return result;
    };
    CHECK(faces_inside_out(Surface(samples::sphere(4))).empty());
    CHECK(found({ball(1, 0, true)}) == std::vector{true});
    CHECK(found({ball(1, 0, false), ball(1, 3, true)}) == std::vector{false, true});
    CHECK(found({ball(0.5, 0, true), ball(1, 0, false)}) == std::vector{false, false});
    CHECK(found({ball(1, 0, true), ball(0.5, 0, false)}) == std::vector{true, true});
    CHECK(found({ball(1, 0, true), ball(0.5, 0, true)}) == std::vector{true, true});
    Mesh open = ball(1, 0, true);
    open.faces = {};
    for (int f = 1; f < ball(1, 0, true).faces.size(); ++f) open.faces.add(ball(1, 0, true).faces[f]);
    CHECK(found({open}) == std::vector{false});
}
