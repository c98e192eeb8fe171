#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "net/net.h"
#include "solve/options.h"
#include "solve/pull.h"
#include "solve/slide.h"

namespace chebnet {

/// The turns and shifts of a whole net that nothing resists: no fixed vertex, no axis that a slide keeps, no pull and
/// no weight. A net whose feet slide on the ground and that is lifted at its middle turns freely about that. Its energy
/// stays the same, but a step of Newton's method away from rest may have a part of it, as M treats it like any other
/// way: the net would spin.
class FreeMotions {
public:
    /// Of a net without a guide. `pulls`: of soft handles; `options`: of gravity.
    FreeMotions(std::span<const int> fixed, std::span<const Slide> slides, std::span<const Pull> pulls,
                const Options& options);

    /// Takes those of a net that stands there (3×V).
    void begin(const Positions& x);
    /// Takes away from the columns (3×V) what they have of them.
    void take_out(Eigen::Matrix3Xd& vectors) const;

private:
    std::vector<int> m_held;                  // vertices
    Axes m_kept = k_no_axes;                  // by something that slides, or by weight
    std::vector<Eigen::Matrix3Xd> m_motions;  // orthonormal
};

}  // namespace chebnet
