#include "base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "base/number.h"

namespace chebnet {

namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

}  // namespace

std::optional<std::int64_t> parse_count(std::string_view text) {
    std::int64_t count = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, count);
    if (error == std::errc::invalid_argument || stop != end || text.front() == '-') return std::nullopt;
    return error == std::errc::result_out_of_range ? std::numeric_limits<std::int64_t>::max() : count;
}

std::string printable(std::string_view text, std::size_t longest) {
    std::string shown(text.substr(0, longest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.size() > longest ? shown + "..." : shown;
}

std::string quoted(std::string_view text) { return '"' + printable(text, 40) + '"'; }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string_view take_word(std::string_view& line) {
    const auto begin = std::find_if_not(line.begin(), line.end(), is_blank);
    const auto end = std::find_if(begin, line.end(), is_blank);
    const std::string_view word = line.substr(begin - line.begin(), end - begin);
    line.remove_prefix(end - line.begin());
    return word;
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

Lines::Lines(std::string_view text) : m_rest(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) m_rest.remove_prefix(byte_order_mark.size());
}

std::string_view Lines::take() {
    const auto end = std::find_if(m_rest.begin(), m_rest.end(), is_line_end);
    const std::string_view line = m_rest.substr(0, end - m_rest.begin());
    m_rest.remove_prefix(line.size());
    m_ends_with_pair = m_rest.substr(0, 2) == "\r\n";
    m_has_lone_cr = m_has_lone_cr || (m_rest.substr(0, 1) == "\r" && !m_ends_with_pair);
    m_rest.remove_prefix(m_ends_with_pair ? 2 : std::min<std::size_t>(1, m_rest.size()));
    ++m_number;
    return line;
}

std::string_view Lines::rest() const {
    return m_ends_with_pair && m_has_lone_cr ? std::string_view(m_rest.data() - 1, m_rest.size() + 1) : m_rest;
}

void fail_at_line(ErrorCode code, std::string_view name, int line, const std::string& what) {
    throw Error(code, std::string(name) + ":" + std::to_string(line) + ": " + what);
}

double read_coordinate(std::string_view word, std::string_view name, int line) {
    const std::optional<double> coordinate = parse_number(word);
    if (!coordinate) fail_at_line(ErrorCode::bad_syntax, name, line, quoted(word) + " is not a number");
    if (!std::isfinite(*coordinate))
        fail_at_line(ErrorCode::non_finite, name, line, "the coordinate " + quoted(word) + " is not finite");
    return *coordinate;
}

std::string row_text(std::span<const double> numbers, int digits) {
    std::string row;
    for (const double number : numbers) {
        if (!row.empty()) row += ' ';
        row += number_text(number, digits);
    }
    return row;
}

}  // namespace chebnet
