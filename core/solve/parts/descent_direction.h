#pragma once

#include <Eigen/Core>

#include "energy/edge_energy.h"
#include "net/net.h"
#include "solve/parts/free_part.h"
#include "solve/trace.h"

namespace chebnet {

/// What a direction of descent may be made from.
struct DescentPoint {
    const Net& net;
    const FreePart& part;
    const EdgeEnergy& energy;
    const Positions& positions;
    const Eigen::VectorXd& ratios;     ///< E, at `positions`
    const Eigen::Matrix3Xd& gradient;  ///< 3×nodes, of the energy's sum over the part's edges
};

/// How a descent chooses where to go.
class DescentDirection {
public:
    virtual ~DescentDirection() = default;

    /// Does the symbolic work for the free vertices of a solve; parts of them may come later. `whole` stays alive.
    virtual void prepare(const FreePart& whole) = 0;
    /// Forgets what was learned so far: another solve or another energy begins.
    virtual void restart() = 0;
    /// Fills `direction`, 3×nodes, and adds to the times of `row`. False if there is none.
    virtual bool find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) = 0;
    /// The line search has gone this part of the last direction.
    virtual void accepted(double step) = 0;
};

}  // namespace chebnet
