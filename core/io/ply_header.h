#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace chebnet::ply {

enum class Encoding { text, little_endian, big_endian };

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
    std::string name;
    Scalar type;                       ///< of the value, or of each value of a list
    std::optional<Scalar> count_type;  ///< of the number that precedes a list; nothing if this is not a list
};

struct Element {
    std::string name;
    std::int64_t count;
    std::vector<Property> properties;

    /// Place of the property of that name, nothing if there is none.
    std::optional<std::size_t> find(std::string_view property_name) const;
};

/// What a file holds, in order; names of elements, and of the properties of one, differ.
struct Header {
    Encoding encoding{};
    std::vector<Element> elements;

    /// Nothing if there is none of that name.
    const Element* find(std::string_view element_name) const;
};

/// Takes the header off the front of the lines of a PLY file. Throws Error bad_syntax, too_large, with
/// `name:line: what`.
Header read_header(Lines& lines, std::string_view name);

}  // namespace chebnet::ply
