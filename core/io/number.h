#pragma once

#include <optional>
#include <string_view>

namespace chebnet {

/// The number that the whole of `text` spells, whatever the locale; nothing if it spells none. "nan", "inf" and numbers
/// too large for a double are numbers here, but not finite ones.
std::optional<double> parse_number(std::string_view text);

}  // namespace chebnet
