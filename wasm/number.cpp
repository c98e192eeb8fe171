// Of chebnet_editor: numbers by JavaScript, which are as exact. The tables of a parser would be a tenth of the module,
// and what prints numbers almost as much.

#include "base/number.h"

#include <emscripten/val.h>

#include <cmath>
#include <string>

namespace chebnet {

/// But for "nan" and "inf", which are none here.
std::optional<double> parse_number(std::string_view text) {
    // To JavaScript, blanks and other bases than ten are numbers too.
    if (text.empty() || text.find_first_not_of("+-.0123456789eE") != text.npos) return std::nullopt;
    const double number = emscripten::val::global("Number")(std::string(text)).as<double>();
    if (std::isnan(number)) return std::nullopt;
    return number;
}

std::string number_text(double number, int digits) {
    const auto rounded = emscripten::val(number).call<emscripten::val>("toPrecision", digits);
    return emscripten::val::global("Number")(rounded).call<std::string>("toString");
}

}  // namespace chebnet
