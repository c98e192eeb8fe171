#pragma once

#include <string>

namespace chebnet::bench {

/// A text as the content of an element of HTML or SVG.
inline std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '<')
            safe += "&lt;";
        else if (c == '&')
            safe += "&amp;";
        else
            safe += c;
    }
    return safe;
}

}  // namespace chebnet::bench
