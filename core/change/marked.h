#pragma once

#include <vector>

namespace chebnet {

/// Of so many numbers, from 0 on, which are among these.
inline std::vector<bool> marked(const std::vector<int>& numbers, int count) {
    std::vector<bool> marks(static_cast<std::size_t>(count), false);
    for (const int number : numbers) marks[number] = true;
    return marks;
}

}  // namespace chebnet
