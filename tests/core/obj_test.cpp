#include "io/obj.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "io/file.h"
#include "mesh_files.h"

using namespace chebnet;
using samples::faces_of;

namespace {

using Face = std::vector<int>;

Mesh read_obj_data(const std::string& name) {
    const std::string path = CHEBNET_TEST_DATA "/obj/" + name;
    return read_obj(read_file(path), path);
}

/// Four corners of a square, for tests that are about faces.
const std::string k_square_corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<Face> faces_on_square(const std::string& text) {
    return faces_of(read_obj(k_square_corners + text, "square.obj"));
}

std::string obj_refusal(const std::string& text) {
    return samples::refusal_of([&] { read_obj(text, "a.obj"); });
}

}  // namespace

TEST_CASE("OBJ as Blender writes it: texture and normal indices, objects, materials, loose edges") {
    const Mesh mesh = read_obj_data("blender.obj");
    CHECK(mesh.positions.cols() == 5);
    CHECK(mesh.positions.col(4) == Eigen::Vector3d(0, 0.5, -2));
    CHECK(faces_of(mesh) == std::vector<Face>{{0, 1, 3, 2}, {2, 3, 4}});
}

TEST_CASE("OBJ as Rhino writes it: CRLF, faces continued by a backslash, normals without textures") {
    const Mesh mesh = read_obj_data("rhino.obj");
    CHECK(mesh.positions.cols() == 5);
    CHECK(mesh.positions.col(2) == Eigen::Vector3d(1.5, 1.5, -2.5e-17));
    CHECK(faces_of(mesh) == std::vector<Face>{{0, 1, 2, 3}, {3, 2, 4}});
}

TEST_CASE("OBJ as MeshLab writes it: normals between the vertices, colours behind the coordinates") {
    const Mesh mesh = read_obj_data("meshlab.obj");
    CHECK(mesh.positions.cols() == 4);
    CHECK(mesh.positions.col(3) == Eigen::Vector3d(-0.5, 0.5, 0.125));
    CHECK(faces_of(mesh) == std::vector<Face>{{0, 1, 2, 3}});
}

TEST_CASE("OBJ habits that all mean the same square") {
    const std::vector<Face> square{{0, 1, 2, 3}};
    CHECK(faces_on_square("f 1 2 3 4") == square);
    CHECK(faces_on_square("f 1 2 3 4\n") == square);
    CHECK(faces_on_square("\tf\t1  2\t3 4 \t\n") == square);
    CHECK(faces_on_square("f -4 -3 -2 -1\n") == square);
    CHECK(faces_on_square("f 1/9 2/9 3/9 4/9\n") == square);
    CHECK(faces_on_square("f 1//9 2//9 3//9 4//9\n") == square);
    CHECK(faces_on_square("f 1/9/9 2/9/9 3/9/9 4/9/9\n") == square);
    CHECK(faces_on_square("f -4/-1/-1 2// 3/ 4/9/\n") == square);
    CHECK(faces_on_square("f 1 2 3 4 # a face\n") == square);
    CHECK(faces_on_square("f 1 2 3 4#a face\n") == square);
    CHECK(faces_on_square("f \\\n1 2 \\\n3 4\n") == square);
    CHECK(faces_on_square("f 1 2 \\ \r\n 3 4\\") == square);
    CHECK(faces_on_square("f 1 2 3 4\r# for old Macintoshes\r") == square);
    CHECK(faces_on_square("# C:\\nets\\\nf 1 2 3 4\n") == square);
    CHECK(faces_on_square("g f\nfoo 1 2\nvp 1\nvt 0\ncurv 0 1 1 2\nsurf 0 1 0 1 1 2\np 1\nl 1 2\nf 1 2 3 4\n") ==
          square);
    CHECK(faces_of(read_obj("\xEF\xBB\xBF" + k_square_corners + "f 1 2 3 4", "bom.obj")) == square);
    CHECK(faces_of(read_obj("f 1 2 3 4\n" + k_square_corners, "forward.obj")) == square);
}

TEST_CASE("OBJ numbers are read exactly, whatever their form") {
    const Mesh mesh = read_obj("v 1 +2.5 -.5\nv 1e3 1E-3 3.\nv 0.1 -0 1e-320\nf 1 2 3", "numbers.obj");
    CHECK(mesh.positions.col(0) == Eigen::Vector3d(1, 2.5, -0.5));
    CHECK(mesh.positions.col(1) == Eigen::Vector3d(1e3, 1e-3, 3));
    CHECK(mesh.positions.col(2) == Eigen::Vector3d(0.1, 0, 1e-320));
}

TEST_CASE("A text without vertices or faces reads as an empty mesh") {
    for (const std::string text : {"", "\n", "# nothing", "\\", "\xEF\xBB\xBF"}) {
        const Mesh mesh = read_obj(text, "empty.obj");
        CHECK(mesh.positions.cols() == 0);
        CHECK(mesh.faces.size() == 0);
    }
}

TEST_CASE("What is wrong in an OBJ is named with its line") {
    CHECK(obj_refusal("v 0 0 0\nv 1 2\n") == "bad_syntax a.obj:2: a vertex needs three coordinates, this one has 2");
    CHECK(obj_refusal("v\n") == "bad_syntax a.obj:1: a vertex needs three coordinates, this one has 0");
    CHECK(obj_refusal("v 0 0 zero\n") == "bad_syntax a.obj:1: \"zero\" is not a number");
    CHECK(obj_refusal("v 0,5 0 0\n") == "bad_syntax a.obj:1: \"0,5\" is not a number");
    CHECK(obj_refusal("v 1.0f 0 0\n") == "bad_syntax a.obj:1: \"1.0f\" is not a number");
    CHECK(obj_refusal("v +-1 0 0\n") == "bad_syntax a.obj:1: \"+-1\" is not a number");
    CHECK(obj_refusal("\n\nv 0 nan 0\n") == "non_finite a.obj:3: the coordinate \"nan\" is not finite");
    CHECK(obj_refusal("v 0 -inf 0\n") == "non_finite a.obj:1: the coordinate \"-inf\" is not finite");
    CHECK(obj_refusal("v 0 1e999 0\n") == "non_finite a.obj:1: the coordinate \"1e999\" is not finite");

    CHECK(obj_refusal(k_square_corners + "f\n") ==
          "small_face a.obj:5: a face needs at least three vertices, this one has 0");
    CHECK(obj_refusal(k_square_corners + "f 1 2\n") ==
          "small_face a.obj:5: a face needs at least three vertices, this one has 2");
    CHECK(obj_refusal(k_square_corners + "f 1 2 0\n") ==
          "index_out_of_range a.obj:5: a face names vertex 0, but vertices are counted from 1");
    CHECK(obj_refusal(k_square_corners + "f 1 2 99999999999\n") ==
          "index_out_of_range a.obj:5: the number in \"99999999999\" is too large");
    const std::string form = " is not a corner of a face, which is written v, v/vt, v//vn or v/vt/vn";
    CHECK(obj_refusal(k_square_corners + "f 1 2 x\n") == "bad_syntax a.obj:5: \"x\"" + form);
    CHECK(obj_refusal(k_square_corners + "f 1 2 3.0\n") == "bad_syntax a.obj:5: \"3.0\"" + form);
    CHECK(obj_refusal(k_square_corners + "f 1 2 /3\n") == "bad_syntax a.obj:5: \"/3\"" + form);
    CHECK(obj_refusal(k_square_corners + "f 1 2 3/x\n") == "bad_syntax a.obj:5: \"3/x\"" + form);
    CHECK(obj_refusal(k_square_corners + "f 1 2 3/1/1/1\n") == "bad_syntax a.obj:5: \"3/1/1/1\"" + form);
}

TEST_CASE("An OBJ index out of range is named with the line of its face") {
    CHECK(obj_refusal(k_square_corners + "f 1 2 5\nf 1 2 3\n") ==
          "index_out_of_range a.obj:5: a face names vertex 5, but 4 vertices are in the file");
    // Relative numbers count back from the face, so what follows it does not matter.
    CHECK(obj_refusal("v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 1 1 0\n") ==
          "index_out_of_range a.obj:3: a face names vertex -3, but 2 vertices stand before it");
    CHECK(obj_refusal(k_square_corners + "f -2147483648 1 2") ==
          "index_out_of_range a.obj:5: a face names vertex -2147483648, but 4 vertices stand before it");
}

TEST_CASE("OBJ lines are counted as an editor counts them") {
    CHECK(obj_refusal("# one\r\n\r\nv x 0 0\r\n").find("a.obj:3:") != std::string::npos);
    CHECK(obj_refusal("# one\r\rv x 0 0\r").find("a.obj:3:") != std::string::npos);
    CHECK(obj_refusal("v 0 \\\n0 \\\n0\nv x 0 0\n").find("a.obj:4:") != std::string::npos);
    // A continued statement is named by the line on which it begins.
    CHECK(obj_refusal("\nv 0 \\\n0 \\\nx\n").find("a.obj:2:") != std::string::npos);
}

TEST_CASE("A message shows a long or strange word safely") {
    CHECK(obj_refusal("v " + std::string(100000, 'x') + " 0 0") ==
          "bad_syntax a.obj:1: \"" + std::string(40, 'x') + "...\" is not a number");
    CHECK(obj_refusal("v \x01\xC3\xA9 0 0") == "bad_syntax a.obj:1: \"???\" is not a number");
}

TEST_CASE("An OBJ above the limits is refused, not attempted") {
    std::string text;
    for (int v = 0; v <= k_max_file_elements; ++v) text += "v 0 0 0\n";
    CHECK(obj_refusal(text) == "too_large a.obj:2000001: more than 2000000 vertices");
}

TEST_CASE("Seventeen digits return every coordinate bit for bit") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const Mesh mesh = samples::wild_mesh(random);
    CHECK(samples::same_bits(read_obj(write_obj(mesh.positions, mesh.faces), "written.obj"), mesh));
}

TEST_CASE("An OBJ is written with the digits asked for") {
    Positions positions(3, 3);
    positions << 0, 1. / 3, 1, 0, 0, -2e10, 0, 1e-7, 0.5;
    Faces faces;
    faces.add({0, 1, 2});
    CHECK(write_obj(positions, faces, 3) == "v 0 0 0\nv 0.333 0 1e-07\nv 1 -2e+10 0.5\nf 1 2 3\n");
    CHECK_THROWS_AS(write_obj(positions, faces, 0), Error);
    // Of several pieces each is a group, wherever its faces are.
    Positions apart(3, 6);
    apart.setZero();
    Faces three;
    for (const std::array<int, 3>& face : {std::array{0, 1, 2}, std::array{3, 4, 5}, std::array{0, 2, 1}})
        three.add(face);
    const std::string text = write_obj(apart, three);
    CHECK(text.substr(text.find('g')) == "g piece_1\nf 1 2 3\ng piece_2\nf 4 5 6\ng piece_1\nf 1 3 2\n");
    CHECK(samples::same_bits(read_obj(text, "written.obj"), {apart, three}));
    CHECK_THROWS_AS(write_obj(positions, faces, 18), Error);
}

TEST_CASE("Random and damaged OBJ texts end in a mesh or in a named error") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::vector<std::string> words = {"v",    "f",  "\n",  "\r\n", "\r", "\\\n", "#", "1",  "-1",  "2/3",
                                            "4//1", "/",  "1e5", "-",    "+",  "nan",  "0", "vt", "l",   "999999",
                                            "\t",   "\\", "1.",  ".",    "e",  "\xFF", "é", "//", "0x1", "v 1 2 3\n"};
    const auto pick = [&random](std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    for (int trial = 0; trial < 3000; ++trial) {
        std::string text;
        for (std::size_t count = pick(60); count > 0; --count) text += words[pick(words.size())] + (pick(3) ? " " : "");
        if (trial % 2) {
            text = k_square_corners + "f 1/1 2/2 3/3 4/4\n";
            for (std::size_t count = pick(4) + 1; count > 0; --count)
                text[pick(text.size())] = static_cast<char>(pick(256));
        }
        CAPTURE(trial, text);
        try {
            const Mesh mesh = read_obj(text, "random.obj");
            CHECK(mesh.positions.allFinite());
            for (const int vertex : mesh.faces.vertices) CHECK((vertex >= 0 && vertex < mesh.positions.cols()));
        } catch (const Error& error) {
            CHECK(std::string(error.what()).rfind("random.obj:", 0) == 0);
        }
    }
}

TEST_CASE("Files are read and written whole, or refused by name") {
    const std::string path = "obj_test_file.obj";
    const std::string text("v 1 2 3\r\n\0 \xFF", 12);
    write_file(path, text);
    CHECK(read_file(path) == text);
    std::remove(path.c_str());

    CHECK_THROWS_WITH(read_file("no/such/net.obj"), "no/such/net.obj: cannot be opened: No such file or directory");
    CHECK_THROWS_WITH(read_file("."), Catch::StartsWith(".: cannot be "));
    CHECK_THROWS_WITH(write_file("no/such/net.obj", ""), Catch::StartsWith("no/such/net.obj: cannot be opened"));
}
