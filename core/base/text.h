#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/number.h"

namespace chebnet {

/// The count, an integer ≥ 0, that the whole of `text` spells; one above 2⁶³ − 1 becomes 2⁶³ − 1. Nothing if it spells
/// none.
std::optional<std::int64_t> parse_count(std::string_view text);

/// `text` fit for a message: in printable ASCII, and of no more than `longest` characters before an ellipsis.
std::string printable(std::string_view text, std::size_t longest);

/// `text` in quotation marks, fit for a message.
std::string quoted(std::string_view text);

/// True for a space or tab, false for the end of a line.
bool is_blank(char c);

/// Takes the next word off the front of `line`; an empty one at its end.
std::string_view take_word(std::string_view& line);

/// `line` up to a comment that begins with `#`.
std::string_view without_comment(std::string_view line);

/// The lines of a text, one after the other. LF, CRLF and CR end a line; a byte order mark at the front is passed over.
class Lines {
public:
    explicit Lines(std::string_view text);

    bool at_end() const { return m_rest.empty(); }
    /// The next line, without its end; an empty one at the end of the text.
    std::string_view take();
    /// Which line was taken last, from 1.
    int number() const { return m_number; }
    /// What follows the line that was taken last. Behind lines that ended with CR alone an LF is no part of the line's
    /// end, but the first byte of what follows, as it may be of binary data.
    std::string_view rest() const;

private:
    std::string_view m_rest;
    bool m_ends_with_pair = false;  // of the line that was taken last: CR and LF
    bool m_has_lone_cr = false;     // a line ended with CR alone
    int m_number = 0;
};

/// Throws the error of a text called `name`, its message `name:line: what`.
[[noreturn]] void fail_at_line(ErrorCode code, std::string_view name, int line, const std::string& what);

/// The finite number that `word`, on that line of the text called `name`, spells. Throws Error bad_syntax, non_finite.
double read_coordinate(std::string_view word, std::string_view name, int line);

/// The numbers with a space between them.
std::string row_text(std::span<const double> numbers, int digits);

}  // namespace chebnet
