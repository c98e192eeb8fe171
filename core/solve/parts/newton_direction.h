#pragma once

#include <memory>

#include "linear/graph_system.h"
#include "solve/parts/descent_direction.h"

namespace chebnet {

/// No curvature weight of an edge is let below this part of the mean radial one: the small shift that majorizers want
/// which are singular where edges have their length or are compressed. It acts as a weak Laplacian there. Between 1e-6
/// and 1e-3 iterations differ by a tenth; less than 1e-6 costs more, and nothing at all fails. The paper's majorizer is
/// definite, and in its workflow the shift never reaches it.
inline constexpr double k_smallest_weight = 1e-5;

/// Newton steps with the energy's stand-in for the Hessian (EdgeEnergy::curvature): H d = −∇E, one numeric
/// factorisation each. The symbolic factorisation is kept; a reduced part takes over the whole's order of elimination.
class NewtonDirection : public DescentDirection {
public:
    void prepare(const FreePart& whole) override;
    void restart() override {}
    bool find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) override;
    void accepted(double) override {}

private:
    const FreePart* m_whole = nullptr;
    std::unique_ptr<BlockSystem> m_system;    // of the whole
    std::vector<EdgeCurvature> m_curvatures;  // of the part's edges
};

}  // namespace chebnet
