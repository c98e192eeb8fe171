#include "net/repair.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "mesh_files.h"
#include "sample_nets.h"

using namespace chebnet;
using samples::faces_of;
using FaceList = std::vector<std::vector<int>>;

namespace {

/// A strip of 2 × (columns + 1) vertices: 2i below, 2i + 1 above. Quad i lies between columns i and i + 1.
Mesh strip(int columns) {
    Mesh mesh{Positions::Zero(3, 2 * (columns + 1)), {}};
    for (int v = 0; v < mesh.positions.cols(); ++v) mesh.positions.col(v) << v / 2, v % 2, 0;
    for (int i = 0; i < columns; ++i) mesh.faces.add({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    return mesh;
}

/// Every quad with corners of its own, as programs for drawing keep it.
Mesh exploded(const Mesh& mesh) {
    Mesh loose{Positions(3, mesh.faces.vertices.size()), mesh.faces};
    for (std::size_t k = 0; k < mesh.faces.vertices.size(); ++k) {
        loose.positions.col(k) = mesh.positions.col(mesh.faces.vertices[k]);
        loose.faces.vertices[k] = static_cast<int>(k);
    }
    return loose;
}

Mesh with_vertex(Mesh mesh, double x, double y, double z) {
    mesh.positions.conservativeResize(3, mesh.positions.cols() + 1);
    mesh.positions.rightCols(1) << x, y, z;
    return mesh;
}

std::vector<std::string> sentences(const RepairedMesh& result) {
    std::vector<std::string> lines;
    for (const Finding& finding : result.findings) lines.push_back(to_sentence(finding));
    return lines;
}

std::vector<std::string> found_in(const Mesh& mesh) { return sentences(repair(mesh, {})); }

using SentenceList = std::vector<std::string>;

}  // namespace

TEST_CASE("A sound mesh is left as it is") {
    const Mesh mesh = strip(3);
    const RepairedMesh result = repair(mesh, k_all_defects);
    CHECK(result.findings.empty());
    CHECK(samples::same_bits(result.mesh, mesh));
    CHECK(result.new_vertex == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
}

TEST_CASE("Coinciding vertices are found as by the repair of all, without it") {
    CHECK_FALSE(find_duplicate_vertices(strip(3)));
    const std::optional<Finding> found = find_duplicate_vertices(exploded(strip(3)));
    REQUIRE(found);
    CHECK(to_sentence(*found) == found_in(exploded(strip(3))).front());
    CHECK_FALSE(found->repaired);
    CHECK(samples::refusal_of([] { find_duplicate_vertices(strip(1), 0); }).starts_with("bad_option"));
}

TEST_CASE("What is not chosen is found and left") {
    const Mesh mesh = samples::with_face(with_vertex(strip(2), 0, 0, 0), {1, 3, 2, 0});
    const RepairedMesh result = repair(mesh, {});
    CHECK(samples::same_bits(result.mesh, mesh));
    CHECK(sentences(result) == SentenceList{"1 vertex at the place of an earlier one: 6",
                                            "1 face with the edges of an earlier one: 2",
                                            "1 face third or later at an edge: 2", "1 vertex of no face: 6"});
    for (const Finding& finding : result.findings) CHECK_FALSE(finding.repaired);
}

TEST_CASE("Duplicate vertices are merged into the earliest") {
    const RepairedMesh result = repair(exploded(strip(3)), k_all_defects);
    CHECK(sentences(result) == SentenceList{"4 vertices at the place of an earlier one, merged: 4, 7, 8, 11"});
    CHECK(result.new_vertex == std::vector<int>{0, 1, 2, 3, 1, 4, 5, 2, 4, 6, 7, 5});
    CHECK(faces_of(result.mesh) == FaceList{{0, 1, 2, 3}, {1, 4, 5, 2}, {4, 6, 7, 5}});
    CHECK(result.mesh.positions.col(6) == Eigen::Vector3d(3, 0, 0));
}

TEST_CASE("A whole net falls apart and is merged again") {
    const Net net = samples::patch(40, 30);
    const Mesh whole{net.rest_positions(), net.faces()};
    std::mt19937 random(7);
    Mesh loose = exploded(whole);
    loose.positions = samples::shaken(loose.positions, 1e-5, random);
    const RepairedMesh result = repair(loose, k_all_defects);
    REQUIRE(result.findings.size() == 1);
    CHECK(result.findings[0].count == loose.positions.cols() - whole.positions.cols());
    CHECK(result.findings[0].examples.size() == 5);
    const Net merged(result.mesh.positions, result.mesh.faces);
    CHECK(merged.vertex_count() == net.vertex_count());
    CHECK(merged.edge_count() == net.edge_count());
}

TEST_CASE("The tolerance of a merge is a fraction of the mean edge length") {
    for (const double scale : {1e-6, 1., 1e6}) {
        Mesh mesh = samples::with_face(with_vertex(strip(2), 0, 1.002, 0), {0, 1, 6});
        mesh.positions *= scale;
        CHECK(repair(mesh, {Defect::duplicate_vertices}, 1e-2).findings.size() == 2);  // then a face is degenerate
        CHECK(repair(mesh, {Defect::duplicate_vertices}).findings.empty());
    }
    for (const double tolerance : {0., -1., std::nan(""), HUGE_VAL})
        CHECK(samples::refusal_of([&] { repair(strip(1), {}, tolerance); }) ==
              "bad_option the tolerance for merging vertices must be a number above 0");
}

TEST_CASE("A million vertices at one place are merged in no time") {
    Mesh mesh{Positions::Zero(3, 1'000'000), {}};
    mesh.positions.col(1).x() = 1;
    mesh.positions.col(2).y() = 1;
    mesh.faces.add({0, 1, 2});
    CHECK(repair(std::move(mesh), k_all_defects).mesh.positions.cols() == 3);
}

TEST_CASE("Vertices that coincide are merged at any scale") {
    const double scale = GENERATE(1e-320, 1e-300, 1e-170, 1.0, 1e170, 1e300);
    CAPTURE(scale);
    Mesh mesh = exploded(strip(5));
    mesh.positions *= scale;
    CHECK(repair(mesh, k_all_defects).mesh.positions.cols() == 12);
}

TEST_CASE("Vertices that coincide are merged even if the mean edge is too short for a number") {
    const double tiny = 2 * std::numeric_limits<double>::denorm_min();
    Mesh mesh{Positions::Zero(3, 4), {}};
    mesh.positions.col(2) << tiny, 0, 0;
    mesh.positions.col(3) << 0, tiny, 0;
    mesh.faces.add({0, 1, 2, 3});
    for (int shortening = 0; shortening < 5; ++shortening) mesh.faces.add({0, 0, 0, 0});
    CHECK(faces_of(repair(mesh, k_all_defects).mesh) == FaceList{{0, 1, 2}});
}

TEST_CASE("A tolerance beyond all numbers merges everything") {
    CHECK(repair(strip(5), k_all_defects, 1e308).findings.front().count == 11);
}

TEST_CASE("A tolerance may be so small that its square is no number") {
    const Mesh mesh = with_vertex(strip(1), 0, 0, 1e-200);
    CHECK(repair(mesh, k_all_defects, 1e-199).findings.front().defect == Defect::duplicate_vertices);
    CHECK(repair(mesh, k_all_defects, 1e-201).findings.front().defect == Defect::unused_vertices);
}

TEST_CASE("Many vertices are merged in no time, also far beyond the net") {
    const int count = GENERATE(80'000, 200'000);
    const double distance = GENERATE(0.0, 1.0, 1e300);
    CAPTURE(count, distance);
    Mesh mesh{distance * Positions::Random(3, count), {}};
    mesh.positions.leftCols(3) = 1e-20 * Eigen::Matrix3d::Identity();
    mesh.faces.add({0, 1, 2});
    CHECK(repair(std::move(mesh), k_all_defects).mesh.positions.cols() == 3);
}

TEST_CASE("A quad with two corners at one place becomes a triangle") {
    Mesh mesh = strip(2);
    mesh.positions.col(5) = mesh.positions.col(4);
    const RepairedMesh result = repair(mesh, k_all_defects);
    CHECK(sentences(result) == SentenceList{"1 vertex at the place of an earlier one, merged: 5",
                                            "1 face with coinciding corners, simplified or removed: 1"});
    CHECK(faces_of(result.mesh) == FaceList{{0, 2, 3, 1}, {2, 4, 3}});
}

TEST_CASE("Faces that cannot be simplified are removed") {
    Mesh mesh = strip(2);
    for (const auto& face : {std::vector{0, 2}, {0, 2, 0}, {0, 2, 0, 3}, {1, 1, 1, 1}, {3, 3, 2, 2}})
        mesh.faces.add(face);
    const RepairedMesh result = repair(mesh, k_all_defects);
    CHECK(sentences(result) == SentenceList{"5 faces with coinciding corners, simplified or removed: 2, 3, 4, 5, 6"});
    CHECK(faces_of(result.mesh) == faces_of(strip(2)));
}

TEST_CASE("Duplicate faces are removed, however they begin and turn, others on the same vertices stay") {
    Mesh mesh = strip(1);
    for (const auto& face : {std::vector{2, 3, 1, 0}, {1, 3, 2, 0}, {0, 3, 2, 1}}) mesh.faces.add(face);
    const RepairedMesh result = repair(mesh, {Defect::duplicate_faces});
    CHECK(sentences(result)[0] == "2 faces with the edges of an earlier one, removed: 1, 2");
    CHECK(faces_of(result.mesh) == FaceList{{0, 2, 3, 1}, {0, 3, 2, 1}});
}

TEST_CASE("The third face at an edge is removed, and what only it used") {
    const Mesh mesh = samples::with_face(with_vertex(strip(2), 1, 0.5, 1), {2, 3, 6});
    const RepairedMesh result = repair(mesh, k_all_defects);
    CHECK(sentences(result) ==
          SentenceList{"1 face third or later at an edge, removed: 2", "1 vertex of no face, dropped: 6"});
    CHECK(faces_of(result.mesh) == faces_of(strip(2)));
    CHECK(result.new_vertex.back() == -1);
}

TEST_CASE("Faces are turned round with the fewest changes, piece by piece, keeping their first corner") {
    Mesh mesh = strip(3);
    mesh.faces = {};
    for (const auto& face : {std::vector{0, 1, 3, 2}, {2, 4, 5, 3}, {4, 6, 7, 5}}) mesh.faces.add(face);
    const RepairedMesh result = repair(mesh, k_all_defects);
    CHECK(sentences(result) == SentenceList{"1 face wound against the others, turned round: 0"});
    CHECK(faces_of(result.mesh) == faces_of(strip(3)));
}

TEST_CASE("Pieces that do not touch keep their sides, and a Moebius strip its one") {
    Mesh apart = strip(3);
    apart.faces = {};
    apart.faces.add({0, 2, 3, 1});
    apart.faces.add({4, 5, 7, 6});
    CHECK(found_in(apart).empty());

    Mesh moebius = samples::with_face(strip(4), {8, 1, 0, 9});
    for (int v = 0; v < moebius.positions.cols(); ++v) moebius.positions.col(v).z() = v * v;
    CHECK(found_in(moebius).empty());
    CHECK(has_one_side(moebius.faces));
    CHECK_FALSE(has_one_side(strip(4).faces));
}

TEST_CASE("Unused vertices are dropped and the others keep their order") {
    Mesh mesh = strip(2);
    mesh.faces = {};
    mesh.faces.add({2, 4, 5, 3});
    const RepairedMesh result = repair(mesh, k_all_defects);
    CHECK(sentences(result) == SentenceList{"2 vertices of no face, dropped: 0, 1"});
    CHECK(result.new_vertex == std::vector<int>{-1, -1, 0, 1, 2, 3});
    CHECK(faces_of(result.mesh) == FaceList{{0, 2, 3, 1}});
}

TEST_CASE("A line names the first five and says if there are more") {
    const Finding finding{Defect::unused_vertices, false, 9, {1, 2, 3, 4, 5}};
    CHECK(to_sentence(finding) == "9 vertices of no face: 1, 2, 3, 4, 5, ...");
    CHECK(std::string(to_string(finding.defect)) == "unused_vertices");
}

TEST_CASE("A mesh that no repair helps is refused") {
    CHECK(samples::refusal_of([] {
              repair(samples::with_face(strip(1), {0, 1, 9}), {});
          }) == "index_out_of_range face 1 names vertex 9, but there are only 4");
    CHECK(samples::refusal_of([] { repair(with_vertex(strip(1), 0, std::nan(""), 0), {}); }) ==
          "non_finite vertex 4 has a coordinate that is not finite");
    Mesh far = strip(1);
    far.positions *= 1e308;
    CHECK(samples::refusal_of([&] { repair(far, {}); }) == "non_finite the edges are too long to be measured");
}

TEST_CASE("Meshes without faces or without any length are repaired as far as they can be") {
    CHECK(repair({}, k_all_defects).findings.empty());
    Mesh point = strip(1);
    point.positions.setZero();
    CHECK(repair(point, k_all_defects).findings.empty());
    CHECK(repair(with_vertex({Positions(3, 0), {}}, 1, 2, 3), k_all_defects).mesh.positions.cols() == 0);
}

TEST_CASE("Whatever is wrong with a mesh, a Net takes it once repaired") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto pick = [&random](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
    for (int trial = 0; trial < 500; ++trial) {
        Mesh mesh{Positions(3, 12), {}};
        for (double& x : mesh.positions.reshaped()) x = pick(3) + 1e-6 * pick(3);
        for (int f = 0; f < 10; ++f) {
            std::vector<int> face;
            for (int corner = 2 + pick(4); corner > 0; --corner) face.push_back(pick(12));
            mesh.faces.add(face);
        }
        const RepairedMesh result = repair(mesh, k_all_defects);
        CHECK(repair(result.mesh, {}).findings.empty());
        if (result.mesh.faces.size() > 0) CHECK_NOTHROW(Net(result.mesh.positions, result.mesh.faces));
        for (int v = 0; v < 12; ++v) {
            const int now = result.new_vertex[v];
            if (now >= 0) CHECK((result.mesh.positions.col(now) - mesh.positions.col(v)).norm() < 1e-3);
        }
    }
}
