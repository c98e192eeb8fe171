#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// What happens at the boundary of a surface while heat spreads over it.
enum class HeatBoundary {
    insulated,  ///< none gets out, and its sum remains
    held        ///< boundary vertices keep what they have
};

/// One implicit step of heat over a surface for a time t, (M + t W)⁻¹ M, with M the areas of vertices and W the
/// cotangent Laplacian (Pinkall & Polthier 1993), whose negative weights are set to 0.
class HeatStep {
public:
    HeatStep(const Surface& surface, double t, HeatBoundary boundary = HeatBoundary::insulated);

    /// Of amounts at vertices (V), M times a density, those after the step.
    Eigen::VectorXd spread(const Eigen::VectorXd& amounts) const;
    /// By how much values at vertices (V) change in the step.
    Eigen::VectorXd change(const Eigen::VectorXd& values) const;

private:
    struct Link {
        int a, b;
        double weight;
    };

    /// x with (M + t W) x = b, by conjugate gradients; where values are held x is 0.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    Eigen::VectorXd precondition(const Eigen::VectorXd& residual) const;
    void multiply(const Eigen::VectorXd& from, Eigen::VectorXd& to) const;

    Eigen::VectorXd m_areas, m_diagonal;
    std::vector<Link> m_links;
    std::vector<bool> m_is_held;
};

/// Of the angle across from a side; of one that is nearly 0 or π, no more than 100 in size.
double cotangent(const Surface& surface, int side);

/// The mean length of the triangles' sides, in which times of heat that is to cross noise are counted.
double mean_edge(const Surface& surface);

}  // namespace chebnet
