#pragma once

#include <array>

#include "net/net.h"

namespace chebnet {

/// Where the path of a descent leads: the parabola through its last three points, a second order extrapolation. A
/// descent along a narrow, bent valley makes many short steps, of which each leaves the floor and the next comes back
/// to it; the floor itself is a smooth curve. In plain loops, which weigh little in WebAssembly.
class PathExtrapolation {
public:
    /// As if there had been no path.
    void clear() { m_count = 0; }
    /// The path's next point, 3×V.
    void add(const Positions& x);
    /// Whether there are three points, no two that follow each other the same.
    bool is_known() const;
    /// `x` (3×V) becomes what is from the last point `t` times as far as that is from the one before; t = 0 and −1 are
    /// these two, and the curve passes through the first at the distance that the points have from each other (chord
    /// length).
    void go(double t, Positions& x) const;
    /// The farthest that a vertex of `x` is from where the last point has it.
    double farthest(const Positions& x) const;

private:
    std::array<Positions, 3> m_points;  // the last one first
    int m_count = 0;
};

}  // namespace chebnet
