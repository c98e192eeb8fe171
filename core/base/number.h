#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace chebnet {

/// The number that the whole of `text` spells, whatever the locale; nothing if it spells none. "nan", "inf" and numbers
/// too large for a double are numbers here, but not finite ones.
std::optional<double> parse_number(std::string_view text);

/// `number` with `digits` significant digits whatever the locale; 17 keep every double exactly. No stream of the
/// standard library: they would make up a quarter of the WebAssembly module.
std::string number_text(double number, int digits);

/// With as many digits, 15 to 17, as bring it back exactly.
std::string exact_text(double number);

}  // namespace chebnet
