#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "solve/parts/alternating_step.h"

namespace chebnet {

/// As-rigid-as-possible editing (Sorkine & Alexa 2007). The cell of a vertex is the edges at it; each cell turns by a
/// rotation R_v of its own from its rest shape p:
///
///     E = ½ Σ_v Σ_{e at v} ‖d_e − R_v p_e‖²,
///
/// with d_e and p_e the vectors of edge e now and at rest. Weights are uniform; the ½ lets an edge, being in two cells,
/// count once. Cells start from their rotations of the iteration before.
class ArapStep : public AlternatingStep {
public:
    /// Rotations start as identity.
    explicit ArapStep(LaplacianPart& part);

    /// Turns each cell as its edges ask for; t_e = ½ (R_a + R_b) p_e.
    void project(const Positions& positions) override;
    double energy(const Positions& positions) const override;

private:
    std::vector<Eigen::Quaterniond> m_quaternions;  // V
    std::vector<Eigen::Matrix3d> m_rotations;       // V, the same as matrices
    std::vector<Eigen::Matrix3d> m_covariances;     // V
    Eigen::Matrix3Xd m_rest;                        // 3×E, p_e
};

}  // namespace chebnet
