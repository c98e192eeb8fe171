#include "io/stl.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <limits>

#include "io/mesh_file.h"
#include "mesh_files.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

const std::string k_stl_text =
    "solid two triangles\r\n"
    " facet normal 0 0 1\r\n  outer loop\r\n   vertex 0 0 0\r\n   vertex 1 0 0\r\n   vertex 0 1e0 0\r\n  endloop\r\n"
    " endfacet\r\n"
    " facet normal 0 0 1\r\n  outer loop\r\n   vertex 1 0 0\r\n   vertex 1 1 0.125\r\n   vertex -0 1 0\r\n  endloop\r\n"
    " endfacet\r\nendsolid\r\n";

std::string stl_refusal(const std::string& bytes) {
    return samples::refusal_of([&] { read_mesh(bytes, "part.stl"); });
}

}  // namespace

TEST_CASE("Text STL is read, and corners at one place are one vertex") {
    const Mesh mesh = read_mesh(k_stl_text, "part");
    CHECK(mesh.faces.vertices == std::vector<int>{0, 1, 2, 1, 3, 2});
    CHECK(mesh.positions.col(3) == Eigen::Vector3d(1, 1, 0.125));
    CHECK(mesh.positions.cols() == 4);
    CHECK(read_stl("solid\nendsolid\n", "part").faces.size() == 0);

    std::string upper = k_stl_text;
    std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
    for (const std::string& text : {upper, "\n \r\n" + k_stl_text})
        CHECK(samples::same_bits(read_mesh(text, "part.stl"), mesh));
}

TEST_CASE("A net written as STL is read as its triangles, to the last bit of a float") {
    const Net net = make_shape("vault:vertices=300").net;
    const std::string bytes = write_stl(net.rest_positions(), net.faces());
    const Mesh mesh = read_mesh(bytes, "called.obj");
    CHECK(mesh.faces.size() == 2 * net.face_count());
    CHECK(mesh.positions.cols() == net.vertex_count());
    CHECK(samples::same_bits(read_stl(write_stl(mesh.positions, mesh.faces), "again"), mesh));
    // Some programs begin binary files as text does.
    const std::string solid = "solid" + bytes.substr(5);
    CHECK(samples::same_bits(read_mesh(solid, "part.stl"), mesh));
}

TEST_CASE("What is wrong with an STL is said") {
    const auto with = [](std::string text, const std::string& what, const std::string& instead) {
        return text.replace(text.find(what), what.size(), instead);
    };
    CHECK(stl_refusal(with(k_stl_text, "0 1e0 0", "0 1e0")) ==
          "bad_syntax part.stl:6: a vertex needs three coordinates");
    CHECK(stl_refusal(with(k_stl_text, "0 1e0 0", "0 nan 0")).starts_with("non_finite part.stl:6: "));
    CHECK(stl_refusal(with(k_stl_text, "facet", "fact")) ==
          "bad_syntax part.stl:2: \"fact\" is not a word of text STL");
    CHECK(stl_refusal(with(k_stl_text, "   vertex 1 0 0\r\n", "")) ==
          "bad_syntax part.stl:6: a triangle has three corners, this one has 2");
    CHECK(stl_refusal(k_stl_text.substr(0, k_stl_text.find("  endloop"))) ==
          "bad_syntax part.stl:6: the file ends within a triangle");

    const Net net = make_shape("vault:vertices=100").net;
    std::string bytes = write_stl(net.rest_positions(), net.faces());
    CHECK(stl_refusal(bytes.substr(0, bytes.size() - 1)).starts_with("bad_syntax part.stl: neither text STL"));
    const auto infinity = std::bit_cast<std::array<char, 4>>(std::numeric_limits<float>::infinity());
    std::copy(infinity.begin(), infinity.end(), bytes.begin() + 84 + 50 + 12);
    CHECK(stl_refusal(bytes) == "non_finite part.stl: triangle 1 has a coordinate that is not finite");
}
