#pragma once

#include <vector>

#include "edit/editor.h"

namespace chebnet {

/// What one JavaScript editor owns.
struct Session {
    Editor editor;
    std::vector<int> suggested_handles;
};

}  // namespace chebnet
