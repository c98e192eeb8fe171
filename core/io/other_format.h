#pragma once

#include <optional>
#include <string_view>

namespace chebnet {

/// What a file is that begins with these bytes, in words for a message such as "a ZIP archive", if it is one of the
/// kinds that come under the name of a mesh: archives, pictures, documents, models of formats that are not read. No
/// OBJ, PLY or OFF file is taken for one.
std::optional<std::string_view> other_format(std::string_view bytes);

}  // namespace chebnet
