// A surface that JavaScript has opened.
#pragma once

#include <memory>
#include <utility>

#include "surface/guide.h"
#include "surface/smoothed_surface.h"

namespace chebnet {

/// What one JavaScript surface owns; editors and equalizers that it guides share it.
struct OpenSurface {
    explicit OpenSurface(Surface opened)
        : guide(std::make_shared<const Guide>(std::move(opened))), surface(guide->surface()), tree(guide->tree()) {}

    /// What a net with edges of this length is laid on (see without_roughness), kept for the next one.
    const std::shared_ptr<const Guide>& laid_on(double length) const {
        if (!m_laid_on || length != m_length) m_laid_on = without_roughness(guide, length);
        m_length = length;
        return m_laid_on;
    }

    std::shared_ptr<const Guide> guide;
    const Surface& surface;
    const SurfaceTree& tree;

private:
    mutable std::shared_ptr<const Guide> m_laid_on;
    mutable double m_length = 0;
};

}  // namespace chebnet
