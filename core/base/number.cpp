#include "base/number.h"

#include <fast_float/fast_float.h>

#include <array>
#include <cstdio>
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

std::string number_text(double number, int digits) {
    std::array<char, 32> buffer{};
    const int size = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, number);
    const std::string_view spelled(buffer.data(), static_cast<std::size_t>(size));
    // Any character but digits, signs and letters is the decimal point of the locale.
    constexpr std::string_view others = "+-0123456789einfa";
    const std::size_t point = spelled.find_first_not_of(others);
    std::string text(spelled.substr(0, point));
    if (point == std::string_view::npos) return text;
    text += '.';
    text += spelled.substr(spelled.find_last_not_of(others) + 1);
    return text;
}

std::string exact_text(double number) {
    for (int digits = 15; digits < 17; ++digits) {
        std::string text = number_text(number, digits);
        if (parse_number(text) == number) return text;
    }
    return number_text(number, 17);
}

}  // namespace chebnet
