#include "io/number.h"

#include <fast_float/fast_float.h>

#include <system_error>

namespace chebnet {

std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = fast_float::from_chars(text.data(), end, number);
    if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
    return number;
}

}  // namespace chebnet
