#pragma once

#include <span>
#include <vector>

#include "net/net.h"
#include "solve/pull.h"
#include "solve/terms/term.h"

namespace chebnet {

/// The pull of soft handles and of the border of a locality: E = Σ_h w_h ‖x_h − c_h‖² / L², L the net's mean length. Of
/// one that yields at r it is 2 w_h r² (√(1 + ‖x_h − c_h‖² / r²) − 1) / L², whose force is less than 2 w_h r / L².
class PullTerm : public Term {
public:
    PullTerm(const Net& net, std::span<const Pull> pulls);

    const char* name() const override { return "pull"; }
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) override;
    void add_curvature(Curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const override;
    void add_blocks(BlockForm& form) const override;
    void add_bound(QuadraticForm& form) const override;

private:
    double m_scale;  // 1 / L²
    std::vector<Pull> m_pulls;
    std::vector<Eigen::Matrix3d> m_curvatures;  // of each, at the last positions
};

/// The net's own weight, E = −g Σ_e L_e / L · down · (x_a + x_b) / 2L: edges are heavy, each by its length, and `g` is
/// the weight of one of mean length L in the units of the other energies. Pieces that nothing carries would fall for
/// ever.
class GravityTerm : public Term {
public:
    /// `down`: a unit vector. `weightless`: V, the vertices of whole pieces whose edges weigh nothing; empty: none do.
    GravityTerm(const Net& net, double g, const Eigen::Vector3d& down, const std::vector<bool>& weightless = {});

    const char* name() const override { return "gravity"; }
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) override;
    void add_curvature(Curvature, const Eigen::Matrix3Xd&, Eigen::Matrix3Xd&) const override {}
    void add_blocks(BlockForm&) const override {}
    void add_bound(QuadraticForm&) const override {}

private:
    Eigen::Matrix3Xd m_gradient;  // constant
};

}  // namespace chebnet
