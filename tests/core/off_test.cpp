#include "io/off.h"

#include <catch2/catch.hpp>

#include "io/file.h"
#include "mesh_files.h"

using namespace chebnet;
using samples::faces_of;
using FaceList = std::vector<std::vector<int>>;

namespace {

Mesh read_off_data(const std::string& name) {
    const std::string path = CHEBNET_TEST_DATA "/off/" + name;
    return read_off(read_file(path), path);
}

std::string off_refusal(const std::string& text) {
    return samples::refusal_of([&] { read_off(text, "a.off"); });
}

/// Three corners and the beginning of their face, lines 1 to 5.
const std::string k_off_corners = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";

}  // namespace

TEST_CASE("OFF as Geomview has it: comments, counts on a line of their own, colours of faces") {
    const Mesh mesh = read_off_data("geomview.off");
    CHECK(mesh.positions.cols() == 8);
    CHECK(mesh.positions.col(1) == Eigen::Vector3d(0, 1, 1.4142));
    CHECK(faces_of(mesh) ==
          FaceList{{0, 1, 2, 3}, {7, 4, 0, 3}, {4, 5, 1, 0}, {5, 6, 2, 1}, {3, 2, 6, 7}, {6, 5, 4, 7}});
}

TEST_CASE("OFF as MeshLab writes it: colours of vertices, CRLF") {
    const Mesh mesh = read_off_data("meshlab.off");
    CHECK(mesh.positions.cols() == 4);
    CHECK(mesh.positions.col(2) == Eigen::Vector3d(1, 1, 0.25));
    CHECK(faces_of(mesh) == FaceList{{0, 1, 2, 3}});
}

TEST_CASE("OFF habits that all mean the same triangle") {
    const std::string head = GENERATE("OFF\n3 1 3\n", "OFF 3 1 0\n", "OFF3 1 0\n", "3 1 0\n", "OFF\n3 1\n",
                                      "\xEF\xBB\xBFOFF\n3 1 0\n", "# made by hand\n\n  OFF # v f e\n\n3 1 0 # counts\n",
                                      "COFF\n3 1 0\n", "NOFF\n3 1 0\n", "STCNOFF\n3 1 0\n");
    const Mesh mesh = read_off(head + "0 0 0\n\n+1 0 0 # corner\r\n0\t1 0 255 0 0 255\n3 0 1 2", "");
    CHECK(mesh.positions.col(1) == Eigen::Vector3d(1, 0, 0));
    CHECK(faces_of(mesh) == FaceList{{0, 1, 2}});
}

TEST_CASE("What is wrong in an OFF is named with its line") {
    CHECK(off_refusal("") == "bad_syntax a.off:1: the file ends before its numbers of vertices and faces");
    CHECK(off_refusal("OFF\n# empty\n") ==
          "bad_syntax a.off:2: the file ends before its numbers of vertices and faces");
    CHECK(off_refusal("OFF\nthree 1 0\n") == "bad_syntax a.off:2: \"three\" is not a number of vertices");
    CHECK(off_refusal("OFF 3\n") == "bad_syntax a.off:1: \"\" is not a number of faces");
    CHECK(off_refusal("OFF -3 1 0\n") == "bad_syntax a.off:1: \"-3\" is not a number of vertices");
    CHECK(off_refusal("OFF BINARY\n") == "bad_syntax a.off:1: OFF is read as text only, this one is binary");
    CHECK(off_refusal("4OFF\n") == "bad_syntax a.off:1: only OFF files with three coordinates a vertex are read");
    CHECK(off_refusal("nOFF\n4\n") == "bad_syntax a.off:1: only OFF files with three coordinates a vertex are read");
    CHECK(off_refusal("OFF\n2000001 1 0\n") == "too_large a.off:2: more than 2000000 vertices");
    CHECK(off_refusal("OFF\n3 99999999999999999999 0\n") == "too_large a.off:2: more than 2000000 faces");

    CHECK(off_refusal("OFF\n3 1 0\n0 0\n") == "bad_syntax a.off:3: a vertex needs three coordinates, this one has 2");
    CHECK(off_refusal("OFF\n3 1 0\n0 0 x\n") == "bad_syntax a.off:3: \"x\" is not a number");
    CHECK(off_refusal("OFF\n3 1 0\n0 0 inf\n") == "non_finite a.off:3: the coordinate \"inf\" is not finite");
    CHECK(off_refusal("OFF\n3 1 0\n0 0 0\n") ==
          "bad_syntax a.off:3: the file ends after 1 of the 3 vertices it declares");
    CHECK(off_refusal(k_off_corners) == "bad_syntax a.off:5: the file ends after 0 of the 1 faces it declares");

    CHECK(off_refusal(k_off_corners + "x 0 1 2\n") ==
          "bad_syntax a.off:6: \"x\" is not the number of vertices of a face");
    CHECK(off_refusal(k_off_corners + "2 0 1\n") ==
          "small_face a.off:6: a face needs at least three vertices, this one has 2");
    CHECK(off_refusal(k_off_corners + "4 0 1 2\n") == "bad_syntax a.off:6: a face of 4 vertices names only 3");
    CHECK(off_refusal(k_off_corners + "9223372036854775807 0 1 2\n") ==
          "bad_syntax a.off:6: a face of 9223372036854775807 vertices names only 3");
    CHECK(off_refusal(k_off_corners + "3 0 1 -1\n") ==
          "bad_syntax a.off:6: \"-1\" is not the number of a vertex, counted from 0");
    CHECK(off_refusal(k_off_corners + "3 0 1 3\n") ==
          "index_out_of_range a.off:6: a face names vertex 3, but the 3 vertices are counted from 0");
    CHECK(off_refusal(k_off_corners + "3 0 1 2\n3 2 1 0\n") ==
          "bad_syntax a.off:7: the file has more lines than its numbers of vertices and faces, 3 and 1, declare");
}

TEST_CASE("OFF returns faces and every bit") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const Mesh mesh = samples::wild_mesh(random);
    CHECK(samples::same_bits(read_off(write_off(mesh.positions, mesh.faces), ""), mesh));
}

TEST_CASE("OFF is written as other programs expect it") {
    const Mesh mesh = read_off(k_off_corners + "3 0 1 2\n", "");
    CHECK(write_off(mesh.positions, mesh.faces) == "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

TEST_CASE("Random OFF texts end in a mesh or in a named error") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::vector<std::string> words = {"OFF", "COFF", "4OFF", "3", "1",  "0", "2",
                                            "-1",  "1.5",  "nan",  "#", "\n", "\n"};
    for (int trial = 0; trial < 3000; ++trial) {
        std::string text = trial % 2 ? "OFF 3 1 0\n0 0 0\n1 0 0\n" : "";
        for (unsigned count = random() % 30; count > 0; --count) text += words[random() % words.size()] + " ";
        CAPTURE(text);
        try {
            const Mesh mesh = read_off(text, "random.off");
            CHECK(mesh.positions.allFinite());
            for (const int vertex : mesh.faces.vertices) CHECK((vertex >= 0 && vertex < mesh.positions.cols()));
        } catch (const Error& error) {
            CHECK(std::string(error.what()).rfind("random.off:", 0) == 0);
        }
    }
}
