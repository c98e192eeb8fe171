#include "io/ply.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "io/bytes.h"
#include "io/file.h"
#include "mesh_files.h"

using namespace chebnet;
using samples::faces_of;
using FaceList = std::vector<std::vector<int>>;

namespace {

Mesh read_ply_data(const std::string& name) {
    const std::string path = CHEBNET_TEST_DATA "/ply/" + name;
    return read_ply(read_file(path), path);
}

std::string ply_refusal(const std::string& bytes) {
    return samples::refusal_of([&] { read_ply(bytes, "a.ply"); });
}

const std::string k_text = "ply\nformat ascii 1.0\n";
const std::string k_binary = "ply\nformat binary_little_endian 1.0\n";
const std::string k_xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string k_corner_list = "property list uchar int vertex_indices\n";

/// The header of a triangle, ten lines.
std::string triangle_header(const std::string& format, int vertices = 3, int faces = 1) {
    return format + "element vertex " + std::to_string(vertices) + "\n" + k_xyz + "element face " +
           std::to_string(faces) + "\n" + k_corner_list + "end_header\n";
}

const std::string k_text_triangle = triangle_header(k_text) + "0 0 0\n1 0 0\n0 1 0\n";

template <class... Numbers>
std::string bytes_of(Numbers... numbers) {
    std::string bytes;
    (append_little_endian(bytes, numbers), ...);
    return bytes;
}

const std::string k_binary_triangle = triangle_header(k_binary) + bytes_of(0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f);

}  // namespace

TEST_CASE("PLY as Blender writes it: normals, textures, colours, loose edges, as text") {
    const Mesh mesh = read_ply_data("blender.ply");
    CHECK(mesh.positions.cols() == 5);
    CHECK(mesh.positions.col(2) == Eigen::Vector3d(1, 1, 0.1));
    CHECK(mesh.positions.col(4) == Eigen::Vector3d(0, 2.5, -1e-3));
    CHECK(faces_of(mesh) == FaceList{{0, 1, 2, 3}, {3, 2, 4}});
}

TEST_CASE("PLY as MeshLab writes it: flags, colours, quality, textures of corners, little endian") {
    const Mesh mesh = read_ply_data("meshlab.ply");
    CHECK(mesh.positions.cols() == 4);
    CHECK(mesh.positions.col(2) == Eigen::Vector3d(0.5, 0.5, 0.1f));
    CHECK(mesh.positions.col(3) == Eigen::Vector3d(-0.5, 0.5, 0.125));
    CHECK(faces_of(mesh) == FaceList{{0, 1, 2, 3}});
}

TEST_CASE("PLY as scanners write it: big endian, CRLF, faces before vertices, coordinates in any order") {
    const Mesh mesh = read_ply_data("scanner.ply");
    CHECK(mesh.positions.cols() == 5);
    CHECK(mesh.positions.col(2) == Eigen::Vector3d(1, 1, 0.1));
    CHECK(mesh.positions.col(3) == Eigen::Vector3d(0, 1, 1e-300));
    CHECK(faces_of(mesh) == FaceList{{0, 1, 2, 3}, {3, 2, 4}});
}

TEST_CASE("PLY numbers of every type are read") {
    const auto [type, bytes] = GENERATE(table<std::string, std::string>({
        {"char", bytes_of(std::int8_t{-3})},
        {"int8", bytes_of(std::int8_t{-3})},
        {"short", bytes_of(std::int16_t{-3})},
        {"int16", bytes_of(std::int16_t{-3})},
        {"int", bytes_of(std::int32_t{-3})},
        {"int32", bytes_of(std::int32_t{-3})},
        {"float", bytes_of(-3.f)},
        {"float32", bytes_of(-3.f)},
        {"double", bytes_of(-3.)},
        {"float64", bytes_of(-3.)},
    }));
    const std::string header =
        "element vertex 1\nproperty " + type + " x\nproperty uchar y\nproperty uint z\nend_header\n";
    const Mesh mesh = read_ply(k_binary + header + bytes + bytes_of(std::uint8_t{200}, std::uint32_t{4000000000u}), "");
    CHECK(mesh.positions.col(0) == Eigen::Vector3d(-3, 200, 4e9));
    CHECK(read_ply(k_text + header + "-3 200 4e9", "").positions == mesh.positions);
}

TEST_CASE("PLY lists of every type are read") {
    const auto [types, bytes] = GENERATE(table<std::string, std::string>({
        {"uchar int", bytes_of(std::uint8_t{3}, 2, 1, 0)},
        {"char uint", bytes_of(std::int8_t{3}, 2u, 1u, 0u)},
        {"uint8 uint8", bytes_of(std::uint8_t{3}, std::uint8_t{2}, std::uint8_t{1}, std::uint8_t{0})},
        {"ushort uint16", bytes_of(std::uint16_t{3}, std::uint16_t{2}, std::uint16_t{1}, std::uint16_t{0})},
        {"int short", bytes_of(3, std::int16_t{2}, std::int16_t{1}, std::int16_t{0})},
        {"uint32 float", bytes_of(3u, 2.f, 1.f, 0.f)},
    }));
    const std::string header = k_binary + "element face 1\nproperty list " + types +
                               " vertex_index\nelement vertex 3\n" + k_xyz + "end_header\n";
    CHECK(faces_of(read_ply(header + bytes + std::string(36, '\0'), "")) == FaceList{{2, 1, 0}});
}

TEST_CASE("PLY habits that all mean the same triangle") {
    const FaceList triangle{{0, 1, 2}};
    CHECK(faces_of(read_ply(k_text_triangle + "3 0 1 2", "")) == triangle);
    CHECK(faces_of(read_ply(k_text_triangle + "\n \t\n  3\t0 1.0  +2 \r\n\n", "")) == triangle);
    CHECK(faces_of(read_ply("\xEF\xBB\xBF" + k_text_triangle + "3 0 1 2\n", "")) == triangle);
    CHECK(faces_of(read_ply("ply\ncomment\n\nobj_info x\n" + k_text_triangle.substr(4) + "3 0 1 2\n", "")) == triangle);
    const std::string face = bytes_of(std::uint8_t{3}, 0, 1, 2);
    CHECK(faces_of(read_ply(k_binary_triangle + face, "")) == triangle);
    CHECK(faces_of(read_ply(k_binary_triangle + face + "\nwhat follows", "")) == triangle);
}

TEST_CASE("The first byte of a PLY's data belongs to no line, also behind lines that end with CR alone") {
    std::string header =
        k_binary + "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n";
    const std::string ten = bytes_of(std::uint8_t{10}, std::uint8_t{13}, std::uint8_t{10});
    const auto read_point = [&] { return Eigen::Vector3d(read_ply(header + ten, "").positions.col(0)); };
    CHECK(read_point() == Eigen::Vector3d(10, 13, 10));
    std::replace(header.begin(), header.end(), '\n', '\r');
    CHECK(read_point() == Eigen::Vector3d(10, 13, 10));
    for (std::size_t k = header.find('\r'); k != std::string::npos; k = header.find('\r', k + 2))
        header.replace(k, 1, "\r\n");
    CHECK(read_point() == Eigen::Vector3d(10, 13, 10));
}

TEST_CASE("A PLY of points is a mesh without faces") {
    const Mesh points = read_ply(k_text + "element vertex 1\n" + k_xyz + "end_header\n1 2 3\n", "");
    CHECK(points.positions.col(0) == Eigen::Vector3d(1, 2, 3));
    CHECK(points.faces.size() == 0);
    CHECK(read_ply(triangle_header(k_text, 0, 0), "").positions.cols() == 0);
}

TEST_CASE("What is wrong in the header of a PLY is named with its line") {
    CHECK(ply_refusal("") == "bad_syntax a.ply:1: a PLY file begins with a line \"ply\"");
    CHECK(ply_refusal("solid\n") == "bad_syntax a.ply:1: a PLY file begins with a line \"ply\"");
    CHECK(ply_refusal("ply\n") == "bad_syntax a.ply:1: the file ends within its header, before a line \"end_header\"");
    CHECK(ply_refusal("ply\nformat\n") ==
          "bad_syntax a.ply:2: the format is ascii, binary_little_endian or binary_big_endian, not \"\"");
    CHECK(ply_refusal("ply\nend_header\n") ==
          "bad_syntax a.ply:2: the header names no format, such as \"format ascii 1.0\"");
    CHECK(ply_refusal(k_text + "vertex 3\n") == "bad_syntax a.ply:3: \"vertex\" is not a statement of a PLY header");
    CHECK(ply_refusal(k_text + "element vertex\n") == "bad_syntax a.ply:3: \"\" is not a number of elements");
    CHECK(ply_refusal(k_text + "element vertex -1\n") == "bad_syntax a.ply:3: \"-1\" is not a number of elements");
    CHECK(ply_refusal(k_text + "element vertex 1\nelement vertex 1\n") ==
          "bad_syntax a.ply:4: the element \"vertex\" is declared twice");
    CHECK(ply_refusal(k_text + "property float x\n") ==
          "bad_syntax a.ply:3: a property stands before the first element");
    CHECK(ply_refusal(k_text + "element vertex 1\nproperty real x\n") ==
          "bad_syntax a.ply:4: \"real\" is not a type of PLY, such as uchar, int, float or double");
    CHECK(ply_refusal(k_text + "element vertex 1\nproperty list uchar x\n") ==
          "bad_syntax a.ply:4: \"x\" is not a type of PLY, such as uchar, int, float or double");
    CHECK(ply_refusal(k_text + "element vertex 1\nproperty float\n") == "bad_syntax a.ply:4: a property has no name");
    CHECK(ply_refusal(k_text + "element vertex 1\nproperty float x\nproperty int x\n") ==
          "bad_syntax a.ply:5: the property \"x\" is declared twice");
    CHECK(ply_refusal(k_text + "element rest 9223372036854775807\nend_header\n") ==
          "bad_syntax a.ply:4: the element \"rest\" has no properties");
    CHECK(ply_refusal(k_text + "end_header\n") == "bad_syntax a.ply:3: the header declares no element \"vertex\"");
    CHECK(ply_refusal(k_text + "element vertex 1\nproperty float x\nproperty float y\nend_header\n") ==
          "bad_syntax a.ply:6: the element \"vertex\" has no coordinate \"z\"");
    CHECK(ply_refusal(k_text + "element vertex 0\n" + k_xyz +
                      "element face 1\nproperty int vertex_indices\nend_header\n") ==
          "bad_syntax a.ply:9: the element \"face\" has no list \"vertex_indices\"");
    std::string many;
    for (int k = 0; k < 1001; ++k) many += "element e" + std::to_string(k) + " 0\n";
    CHECK(ply_refusal(k_text + many) == "too_large a.ply:1003: more than 1000 elements and properties");
    CHECK(ply_refusal(triangle_header(k_binary, 2000001)) == "too_large a.ply:9: more than 2000000 vertices");
    CHECK(ply_refusal(triangle_header(k_binary, 3, 2000001)) == "too_large a.ply:9: more than 2000000 faces");
}

TEST_CASE("What is wrong in a PLY text is named with its line") {
    const std::string header = triangle_header(k_text);
    CHECK(ply_refusal(header + "0 0\n") == "bad_syntax a.ply:10: this line has fewer values than the header declares");
    CHECK(ply_refusal(header + "0 0 0 0\n") ==
          "bad_syntax a.ply:10: this line has more values than the header declares");
    CHECK(ply_refusal(header + "0 0 zero\n") == "bad_syntax a.ply:10: \"zero\" is not a number");
    CHECK(ply_refusal(header + "0 nan 0\n") == "non_finite a.ply:10: the coordinate y is not finite");
    CHECK(ply_refusal(header + "0 0 1e999\n") == "non_finite a.ply:10: the coordinate z is not finite");
    CHECK(ply_refusal(header + "0 0 0\n1 0 0\n") ==
          "bad_syntax a.ply:11: the file ends after 2 of the 3 rows of \"vertex\" that its header declares");
    CHECK(ply_refusal(k_text_triangle + "2 0 1\n") ==
          "small_face a.ply:13: a face needs at least three vertices, this one has 2");
    CHECK(ply_refusal(k_text_triangle + "3 0 1\n") ==
          "bad_syntax a.ply:13: this line has fewer values than the header declares");
    CHECK(ply_refusal(k_text_triangle + "-3 0 1 2\n") ==
          "bad_syntax a.ply:13: the length of the list \"vertex_indices\" is not a count");
    CHECK(ply_refusal(k_text_triangle + "2.5 0 1 2\n") ==
          "bad_syntax a.ply:13: the length of the list \"vertex_indices\" is not a count");
    CHECK(ply_refusal(k_text_triangle + "1e300 0 1 2\n") ==
          "bad_syntax a.ply:13: this line has fewer values than the header declares");
    CHECK(ply_refusal(k_text_triangle + "3 0 1 1.5\n") == "bad_syntax a.ply:13: a face names a vertex by a fraction");
    CHECK(ply_refusal(k_text_triangle + "3 0 1 3\n") ==
          "index_out_of_range a.ply:13: a face names vertex 3, but the 3 vertices are counted from 0");
    CHECK(ply_refusal(k_text_triangle + "3 0 1 -1\n") ==
          "index_out_of_range a.ply:13: a face names vertex -1, but the 3 vertices are counted from 0");
    CHECK(ply_refusal(k_text_triangle + "3 0 1 2\n3 2 1 0\n") ==
          "bad_syntax a.ply:14: the file has more lines than its header declares");
}

TEST_CASE("What is wrong in a binary PLY is named with its vertex or face") {
    const std::string header = triangle_header(k_binary);
    CHECK(ply_refusal(header) ==
          "bad_syntax a.ply: vertex 0: the file ends here, but its header declares 3 rows of \"vertex\"");
    CHECK(ply_refusal(k_binary_triangle.substr(0, k_binary_triangle.size() - 1)) ==
          "bad_syntax a.ply: vertex 2: the file ends here, but its header declares 3 rows of \"vertex\"");
    CHECK(ply_refusal(header + bytes_of(0.f, std::numeric_limits<float>::infinity(), 0.f)) ==
          "non_finite a.ply: vertex 0: the coordinate y is not finite");
    CHECK(ply_refusal(k_binary_triangle + bytes_of(std::uint8_t{2}, 0, 1)) ==
          "small_face a.ply: face 0: a face needs at least three vertices, this one has 2");
    CHECK(ply_refusal(k_binary_triangle + bytes_of(std::uint8_t{255}, 0, 1, 2)) ==
          "bad_syntax a.ply: face 0: the file ends here, but its header declares 1 rows of \"face\"");
    CHECK(ply_refusal(k_binary_triangle + bytes_of(std::uint8_t{3}, 0, 1, -7)) ==
          "index_out_of_range a.ply: face 0: a face names vertex -7, but the 3 vertices are counted from 0");
    CHECK(ply_refusal(k_binary +
                      "element rest 9223372036854775807\nproperty list uint double many\nelement vertex 0\n" + k_xyz +
                      "end_header\n" + bytes_of(4294967295u, 1., 2.)) ==
          "bad_syntax a.ply: \"rest\" 0: the file ends here, but its header declares 9223372036854775807 rows of "
          "\"rest\"");
}

TEST_CASE("PLY of both encodings returns faces and every bit") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const Mesh mesh = samples::wild_mesh(random);
    for (const PlyEncoding encoding : {PlyEncoding::binary, PlyEncoding::text})
        CHECK(samples::same_bits(read_ply(write_ply(mesh.positions, mesh.faces, encoding), ""), mesh));
}

TEST_CASE("PLY is written as other programs expect it") {
    Mesh mesh = read_ply(k_text_triangle + "3 0 1 2\n", "");
    CHECK(write_ply(mesh.positions, mesh.faces, PlyEncoding::text) ==
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    CHECK(write_ply(mesh.positions, mesh.faces, PlyEncoding::binary).find("format binary_little_endian 1.0\n") == 4);
}

TEST_CASE("A face of more vertices than a byte can count survives PLY") {
    Mesh mesh{Positions::Random(3, 300), {}};
    std::vector<int> face(300);
    for (int k = 0; k < 300; ++k) face[k] = k;
    mesh.faces.add(face);
    for (const PlyEncoding encoding : {PlyEncoding::binary, PlyEncoding::text})
        CHECK(samples::same_bits(read_ply(write_ply(mesh.positions, mesh.faces, encoding), ""), mesh));
}

TEST_CASE("Damaged PLY files end in a mesh or in a named error") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto pick = [&random](std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    for (const char* name : {"blender.ply", "meshlab.ply", "scanner.ply"}) {
        const std::string whole = read_file(CHEBNET_TEST_DATA "/ply/" + std::string(name));
        for (int trial = 0; trial < 1000; ++trial) {
            std::string bytes = whole.substr(0, trial % 3 == 0 ? pick(whole.size()) : whole.size());
            for (std::size_t count = pick(4); count > 0 && !bytes.empty(); --count)
                bytes[pick(bytes.size())] = static_cast<char>(pick(256));
            try {
                const Mesh mesh = read_ply(bytes, "damaged.ply");
                CHECK(mesh.positions.allFinite());
                for (const int vertex : mesh.faces.vertices) CHECK((vertex >= 0 && vertex < mesh.positions.cols()));
            } catch (const Error& error) {
                CHECK(std::string(error.what()).rfind("damaged.ply:", 0) == 0);
            }
        }
    }
}
