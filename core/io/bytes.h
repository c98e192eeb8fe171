#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace chebnet {

/// The number whose sizeof(T) bytes stand at `bytes`, in the byte order `order`.
template <class T>
T number_at(const char* bytes, std::endian order) {
    std::array<char, sizeof(T)> copy{};
    std::copy_n(bytes, sizeof(T), copy.begin());
    if (order != std::endian::native) std::reverse(copy.begin(), copy.end());
    T number;
    std::memcpy(&number, copy.data(), sizeof(T));
    return number;
}

/// Adds the bytes of `number` to `bytes`, the least significant first.
template <class T>
void append_little_endian(std::string& bytes, T number) {
    std::array<char, sizeof(T)> copy{};
    std::memcpy(copy.data(), &number, sizeof(T));
    if (std::endian::native == std::endian::big) std::reverse(copy.begin(), copy.end());
    bytes.append(copy.data(), copy.size());
}

}  // namespace chebnet
