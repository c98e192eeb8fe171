#include "remesh/creases.h"

#include <cmath>

namespace chebnet {

std::vector<bool> creases_of(const Surface& surface, double angle) {
    const Positions& normals = surface.face_normals();
    std::vector<bool> result(3 * static_cast<std::size_t>(surface.face_count()), false);
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        if (surface.opposite(s) < 0) continue;
        const auto here = normals.col(Surface::face_of(s)), there = normals.col(Surface::face_of(surface.opposite(s)));
        const bool has_area = here.squaredNorm() > 0 && there.squaredNorm() > 0;
        result[s] = has_area && here.dot(there) < std::cos(angle);
    }
    return result;
}

}  // namespace chebnet
