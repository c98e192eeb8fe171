#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/free_part.h"
#include "solve/parts/neighbour_pairs.h"
#include "solve/parts/neighbour_system.h"
#include "solve/terms/term.h"

namespace chebnet {

/// Descends on a sum of terms without constraints: Newton steps by the terms' convex curvature, with Armijo
/// backtracking. Keeps references to net and part.
class TermDescent {
public:
    /// Throws Error too_large.
    TermDescent(const Net& net, const Topology& topology, const FreePart& part);

    /// One step, in which no vertex moves farther than `radius`. Returns how far the one moved that moved most; 0: no
    /// step lowers the energy, and the positions stay.
    double step(std::span<const std::unique_ptr<Term>> terms, double radius, Positions& positions);

private:
    double evaluate(std::span<const std::unique_ptr<Term>> terms, const Positions& x);

    const Net& m_net;
    const FreePart& m_part;
    NeighbourPairs m_pairs;
    NeighbourSystem m_system;
    Eigen::Matrix3Xd m_gradient;  // of the last evaluation
};

}  // namespace chebnet
