#include "remesh/border_sides.h"

#include <algorithm>

namespace chebnet {

namespace {

constexpr double k_outer = 0.5;

}  // namespace

std::vector<bool> border_sides(const Surface& surface) {
    std::vector<bool> sides(3 * static_cast<std::size_t>(surface.face_count()));
    for (int s = 0; s < 3 * surface.face_count(); ++s) sides[s] = surface.opposite(s) < 0;
    return sides;
}

std::vector<bool> outer_border_sides(const Surface& surface) {
    const std::vector<std::vector<int>> loops = surface.boundary_loops();
    const std::vector<int> pieces = surface.components();
    const auto piece_of = [&](const std::vector<int>& loop) { return pieces[Surface::face_of(loop.front())]; };
    std::vector<double> longest(static_cast<std::size_t>(surface.face_count()), 0);  // of each piece
    for (const std::vector<int>& loop : loops)
        longest[piece_of(loop)] = std::max(longest[piece_of(loop)], surface.length_of(loop));
    std::vector<bool> sides(3 * static_cast<std::size_t>(surface.face_count()), false);
    for (const std::vector<int>& loop : loops)
        if (surface.length_of(loop) >= k_outer * longest[piece_of(loop)])
            for (const int s : loop) sides[s] = true;
    return sides;
}

}  // namespace chebnet
