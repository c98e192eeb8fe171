#pragma once

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"

namespace chebnet::fuzz {

/// Ends the program, which libFuzzer takes for a finding and keeps the input, unless what is required holds.
inline void require(bool holds, const std::string& otherwise) {
    if (holds) return;
    std::fprintf(stderr, "VIOLATED: %s\n", otherwise.c_str());
    std::abort();
}

/// An input may be refused, but with a message that a person can read: one line, not long, of printable characters.
inline void require_readable(const Error& error) {
    const std::string_view message = error.what();
    require(!message.empty() && message.size() < 500, "a message of " + std::to_string(message.size()) + " characters");
    for (const unsigned char c : message)
        require(c >= ' ' && c != 127, "a message with the character " + std::to_string(c));
}

}  // namespace chebnet::fuzz
