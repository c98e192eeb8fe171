#pragma once

#include <optional>
#include <string_view>

namespace chebnet {

/// The kind of a file that begins with these bytes, as text for a message such as "a ZIP archive", if it is one that is
/// often mistaken for a mesh: archives, pictures, documents, models of formats that are not read. No
/// OBJ, PLY, OFF or STL file is taken for one.
std::optional<std::string_view> other_format(std::string_view bytes);

}  // namespace chebnet
