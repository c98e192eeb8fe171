#pragma once

#include <string>
#include <string_view>

namespace chebnet {

/// Largest size of a file that is read, 1 GiB: two million vertices and faces fit in any format, even at 17 digits with
/// textures and normals.
inline constexpr std::size_t k_max_file_bytes = std::size_t{1} << 30;

/// Largest number of vertices or faces a file may have.
inline constexpr int k_max_file_elements = 2'000'000;

/// The whole of a file, byte for byte. Throws Error file_access, too_large.
std::string read_file(const std::string& path);
/// Throws Error file_access.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace chebnet
