#pragma once

#include <memory>
#include <vector>

#include "remesh/singular_wishes.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// Where a surface whose pieces all have a border wants singular vertices for cells of one size to fit between them.
///
/// Laid flat with its angles kept, but for cones, and its border as long as it is, a surface is stretched by e^u with
/// Δu = K − Σ π/2 · index at the cones (Ben-Chen, Gotsman & Bunin, Conformal Flattening by Curvature Prescription and
/// Metric Scaling, 2008). Cones are placed one by one where each lessens ∫ u² most, and then moved while that lessens
/// it.
class Cones {
public:
    /// `tree` is of the surface.
    Cones(const Surface& surface, const SurfaceTree& tree);
    ~Cones();

    /// As few as leave a stretch of e^`most_stretch`, root mean square over the surface; none where that is so without
    /// any, or a piece of the surface is closed, or it is thin all over.
    std::vector<WishedSingular> placed(double most_stretch) const;

private:
    class Placement;
    std::unique_ptr<const Placement> m_bare;  // without any
};

}  // namespace chebnet
