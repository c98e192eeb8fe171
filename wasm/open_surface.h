// A surface that JavaScript has opened.
#pragma once

#include <memory>
#include <utility>

#include "surface/guide.h"

namespace chebnet {

/// What one JavaScript surface owns; editors and equalizers that it guides share it.
struct OpenSurface {
    explicit OpenSurface(Surface opened)
        : guide(std::make_shared<const Guide>(std::move(opened))), surface(guide->surface()), tree(guide->tree()) {}

    std::shared_ptr<const Guide> guide;
    const Surface& surface;
    const SurfaceTree& tree;
};

}  // namespace chebnet
