#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "net/mesh.h"
#include "require.h"

namespace chebnet::fuzz {

inline bool same_bits(const Positions& a, const Positions& b) {
    if (a.cols() != b.cols()) return false;
    for (Eigen::Index k = 0; k < a.size(); ++k)
        if (std::bit_cast<std::uint64_t>(a.reshaped()[k]) != std::bit_cast<std::uint64_t>(b.reshaped()[k]))
            return false;
    return true;
}

/// What a reader promises of a mesh: what its faces name is there, and every coordinate is finite.
inline void require_sound(const Mesh& mesh) {
    require(mesh.positions.allFinite(), "a coordinate that was read is not finite");
    for (int f = 0; f < mesh.faces.size(); ++f) {
        require(mesh.faces[f].size() >= 3, "a face that was read has fewer than three corners");
        for (const int v : mesh.faces[f])
            require(v >= 0 && v < mesh.positions.cols(), "a face that was read names vertex " + std::to_string(v));
    }
}

/// Whatever the bytes, `read` refuses them with a message that begins with the file's name, or gives a sound mesh that
/// comes back from `write` bit for bit.
template <class Read, class Write>
void fuzz_reader(std::string_view bytes, Read read, Write write) {
    const std::string name = "some file";
    Mesh mesh;
    try {
        mesh = read(bytes, name);
    } catch (const Error& error) {
        require_readable(error);
        require(std::string_view(error.what()).starts_with(name + ":"),
                "a message does not begin with the file's name");
        return;
    }
    require_sound(mesh);
    const Mesh again = read(write(mesh), name);
    require(same_bits(again.positions, mesh.positions), "coordinates do not come back");
    require(again.faces.start == mesh.faces.start && again.faces.vertices == mesh.faces.vertices,
            "faces do not come back");
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace chebnet::fuzz
