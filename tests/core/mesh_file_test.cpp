#include "io/mesh_file.h"

#include <Eigen/Geometry>
#include <array>
#include <catch2/catch.hpp>
#include <map>

#include "io/bytes.h"
#include "io/file.h"
#include "mesh_files.h"
#include "shapes/shapes.h"

using namespace chebnet;
using Catch::Matchers::EndsWith, Catch::Matchers::StartsWith;

namespace {

std::string refusal(const std::string& bytes, const std::string& name) {
    return samples::refusal_of([&] { read_mesh(bytes, name); });
}

const std::string k_obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string k_off_triangle = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

using StlTriangle = std::array<Eigen::Vector3d, 4>;

/// Normal and corners of each triangle of a binary STL.
std::vector<StlTriangle> stl_triangles(const std::string& bytes) {
    const auto count = number_at<std::uint32_t>(bytes.data() + 80, std::endian::little);
    REQUIRE(bytes.size() == 84 + 50 * std::size_t{count});
    std::vector<StlTriangle> triangles(count);
    for (std::size_t t = 0; t < count; ++t)
        for (std::size_t k = 0; k < 12; ++k)
            triangles[t][k / 3][k % 3] = number_at<float>(bytes.data() + 84 + 50 * t + 4 * k, std::endian::little);
    return triangles;
}

std::vector<StlTriangle> stl_of(const std::vector<Eigen::Vector3d>& corners) {
    Mesh mesh{Positions(3, corners.size()), {}};
    std::vector<int> face;
    for (const Eigen::Vector3d& corner : corners) {
        mesh.positions.col(face.size()) = corner;
        face.push_back(static_cast<int>(face.size()));
    }
    mesh.faces.add(face);
    return stl_triangles(find_format("stl").write(mesh.positions, mesh.faces));
}

/// True if a triangle has both points as corners.
bool joins(const StlTriangle& t, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::find(t.begin() + 1, t.end(), a) != t.end() && std::find(t.begin() + 1, t.end(), b) != t.end();
}

}  // namespace

TEST_CASE("Every format but STL keeps quads, order and every bit of a net") {
    const Net net = make_shape("dome:vertices=500").net;
    const Mesh mesh{net.rest_positions(), net.faces()};
    for (const FormatInfo& format : format_table()) {
        CAPTURE(format.name);
        if (&format == &find_format("stl")) continue;
        for (WriteMesh* const write : {format.write, format.write_text})
            if (write != nullptr) CHECK(samples::same_bits(read_mesh(write(mesh.positions, mesh.faces), "net"), mesh));
    }
}

TEST_CASE("The table of formats names every one, with its reader and writers") {
    for (const FormatInfo& format : format_table()) {
        CAPTURE(format.name);
        CHECK(&find_format(format.name) == &format);
        CHECK(&format_of_name(std::string("net.") + format.name) == &format);
        CHECK(format.read != nullptr);
        CHECK(format.write != nullptr);
        CHECK(*format.title != 0);
        CHECK(*format.sentence != 0);
        CHECK(std::string(format.media_type).find('/') != std::string::npos);
    }
    const FormatInfo& last = format_table().back();
    CHECK_THAT(samples::refusal_of([] { find_format("dxf"); }),
               StartsWith("bad_option no format is called \"dxf\"; known are obj, ply, off, ") && EndsWith(last.name));
    CHECK_THAT(titles_read("and"), StartsWith("OBJ, PLY, OFF") && EndsWith(std::string(" and ") + last.title));
    CHECK_THAT(titles_binary_or_text("and"), StartsWith("PLY"));
    CHECK_THAT(extensions_written("or"), StartsWith(".obj, .ply, .off") && EndsWith(std::string(" or .") + last.name));
}

TEST_CASE("The content of a file says its format, then its extension") {
    const Mesh mesh = read_mesh(k_obj_triangle, "net.obj");
    const std::string ply = find_format("ply").write(mesh.positions, mesh.faces);
    for (const char* name : {"net", "net.obj", "net.OBJ", "net.txt", "a.b/net"})
        for (const std::string& bytes : {k_obj_triangle, k_off_triangle, ply})
            CHECK(samples::same_bits(read_mesh(bytes, name), mesh));
    CHECK(samples::same_bits(read_mesh(k_off_triangle.substr(4), "net.off"), mesh));
    CHECK(samples::same_bits(read_mesh(ply, "net.off"), mesh));
    CHECK(samples::same_bits(read_mesh(k_off_triangle, "net.ply"), mesh));
    CHECK(read_mesh("", "net.obj").positions.cols() == 0);

    CHECK(refusal("x", "net.Ply") == "bad_syntax net.Ply:1: a PLY file begins with a line \"ply\"");
    CHECK(refusal("x", "net.off") == "bad_syntax net.off:1: \"x\" is not a number of vertices");
    CHECK_THAT(refusal("x", "net.STL"), StartsWith("bad_syntax net.STL: neither text STL"));
    const std::string unknown = ": not a mesh of a format that is read, which are " + titles_read("and");
    for (const std::string name : {"net", "net.3dm", ".obj", "net.obj/file"})
        CHECK(refusal("x", name) == "bad_syntax " + name + unknown);
}

TEST_CASE("A file that is something else under the name of a mesh is called what it is") {
    using namespace std::string_literals;
    const std::map<std::string, std::string> beginnings{
        {"PK\3\4\24\0\0\0"s, "a ZIP archive"},
        {"\x1f\x8b\x08"s, "a gzip archive"},
        {"\x89PNG\r\n\x1a\n"s, "a PNG picture"},
        {"\xff\xd8\xff\xe0"s, "a JPEG picture"},
        {"%PDF-1.7\n"s, "a PDF document"},
        {"glTF\2\0\0\0"s, "a GLB model"},
        {"3D Geometry File Format        8"s, "a 3DM model"},
        {"\xff\xfev\0 \0"s, "a text in UTF-16"},
        {"<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"\nv 1 2 3\"/></svg>"s, "an SVG drawing"},
        {"\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!-- made by hand -->\n<SVG/>"s, "an SVG drawing"},
        {"\n<!DOCTYPE html><title>404</title>"s, "a web page"},
        {"<?xml version=\"1.0\"?><kml/>"s, "an XML document"},
        {" {\"asset\": {}}"s, "a JSON document"}};
    for (const auto& [bytes, kind] : beginnings)
        for (const std::string name : {"net.obj", "net.ply", "net.off", "net"})
            CHECK(refusal(bytes, name) ==
                  "bad_syntax " + name + ": this is " + kind + "; meshes are read from " + titles_read("and"));
}

TEST_CASE("A binary STL file is one whatever it begins with") {
    const Net net = make_shape("dome:vertices=500").net;
    const std::string stl = find_format("stl").write(net.rest_positions(), net.faces());
    for (const std::string header :
         {"{exported by x}", "<made by y>", "GIF89a", "ply\n", "OFF x", "solid", "v 0 0 0\n"}) {
        std::string bytes = stl;
        bytes.replace(0, header.size(), header);
        CAPTURE(header);
        CHECK(read_mesh(bytes, "net.stl").faces.size() == 2 * net.face_count());
    }
}

TEST_CASE("The name of a file says how it is written") {
    CHECK(&format_of_name("net.obj") == &find_format("obj"));
    CHECK(&format_of_name("a/net.PLY") == &find_format("ply"));
    CHECK(&format_of_name("net.v2.off") == &find_format("off"));
    CHECK(&format_of_name("net.Stl") == &find_format("stl"));
    CHECK(&format_of_name("/dev/stdout") == &find_format("obj"));
    CHECK(samples::refusal_of([] { format_of_name("net.3dm"); }) ==
          "bad_option net.3dm: nets are written as " + extensions_written("or") + ", not as \".3dm\"");
    CHECK(has_mesh_extension("no/such.OFF"));
    CHECK_FALSE(has_mesh_extension("dome"));
    CHECK_FALSE(has_mesh_extension("net.json"));
}

TEST_CASE("A normal of STL has the length 1 however small its triangle") {
    const double scale = GENERATE(1.0, 1e-30, 1e-44);
    CAPTURE(scale);
    const Eigen::Vector3d normal =
        stl_of({Eigen::Vector3d::Zero(), scale * Eigen::Vector3d(0, 1, 1), scale * Eigen::Vector3d(1, 0, 0)})[0][0];
    CHECK(normal.norm() == Approx(1));
}

TEST_CASE("STL holds the triangles of the faces, wound and facing as they are") {
    const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), e(-1, 0.5, 0);
    CHECK(stl_of({a, b, c}) == std::vector<StlTriangle>{{Eigen::Vector3d(0, 0, 1), a, b, c}});
    CHECK(stl_of({c, b, a})[0][0] == Eigen::Vector3d(0, 0, -1));
    CHECK(stl_of({a, b, c, d, e}).size() == 3);

    const Net net = make_shape("dome:vertices=500").net;
    CHECK(stl_triangles(find_format("stl").write(net.rest_positions(), net.faces())).size() ==
          2 * static_cast<std::size_t>(net.face_count()));
}

TEST_CASE("STL cuts a quad along its shorter diagonal") {
    const Eigen::Vector3d left(-2, 0, 0), low(0, -1, 0), right(2, 0, 0), high(0, 1, 0);
    for (const auto& rhombus : {std::vector{left, low, right, high}, std::vector{low, right, high, left}})
        for (const StlTriangle& triangle : stl_of(rhombus)) CHECK(joins(triangle, low, high));
}

TEST_CASE("STL cuts a quad with a corner that points inwards through that corner") {
    const Eigen::Vector3d tip(0, 5, 0), left(-1, 0, 0), notch(0, 1, 0), right(1, 0, 0);
    for (const auto& dart : {std::vector{tip, left, notch, right}, std::vector{left, notch, right, tip}})
        for (const StlTriangle& triangle : stl_of(dart)) CHECK(joins(triangle, tip, notch));
}

TEST_CASE("What does not fit the floats of STL is refused") {
    CHECK(samples::refusal_of([] {
              stl_of({{0, 0, 0}, {1e39, 0, 0}, {0, 1, 0}});
          }) == "too_large vertex 1 has a coordinate that is too large for STL");
    const std::vector<Eigen::Vector3d> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto refusal_of_triangle = [&](double size, const Eigen::Vector3d& at) {
        std::vector<Eigen::Vector3d> corners;
        for (const Eigen::Vector3d& corner : triangle) corners.push_back(at + size * corner);
        return samples::refusal_of([&] { stl_of(corners); });
    };
    for (const std::string& refusal :
         {refusal_of_triangle(1e-50, Eigen::Vector3d::Zero()), refusal_of_triangle(1, {1e12, 1e12, -1e12})})
        CHECK_THAT(refusal, Catch::StartsWith("bad_scale vertices 0, 1 and 2 become one in STL"));
    CHECK(refusal_of_triangle(1e-40, Eigen::Vector3d::Zero()) == "none");
    CHECK(refusal_of_triangle(0, Eigen::Vector3d::Zero()) == "none");  // no triangle before either
}
