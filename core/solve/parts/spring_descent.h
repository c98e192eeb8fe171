#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "net/net.h"
#include "solve/parts/laplacian_part.h"
#include "solve/parts/lbfgs_history.h"
#include "solve/slide.h"

namespace chebnet {

/// Quasi-Newton descent on the energy of springs
///
///     E = Σ_e (ℓ_e − L_e)² + Σ_h w_h ‖x_h − c_h‖²
///
/// with the uniform Laplacian as the first guess of its Hessian (Liu, Bouaziz, Kavan 2017): the local–global iteration
/// is its first step, and what the steps teach about the curvature makes the following ones many times longer. Steps
/// are as smooth as the Laplacian's. h are the part's pulls, which draw to where the solve has brought them rather than
/// to their targets. Nothing is allocated once the history is full. Keeps a reference to the part.
class SpringDescent {
public:
    /// `slides`: free vertices that keep some of their coordinates.
    explicit SpringDescent(LaplacianPart& part, std::span<const Slide> slides = {});

    /// Begins at `positions` (3×V). `centres` (3×V, kept by reference): c_h is the column of the pull's vertex.
    void start(const Positions& positions, const Positions& centres);
    /// One iteration with Armijo backtracking. False if no step lowers the energy; then the positions stay.
    bool iterate(Positions& positions);

    double energy() const { return m_energy; }  ///< at the present positions, in the net's own unit squared
    double gradient_norm() const { return m_gradient.norm(); }
    double step() const { return m_step; }  ///< of the last iteration

private:
    template <typename Moves>
    void keep_what_slides(Moves& moves) const;
    /// E and, 4×nodes, ∇E at some positions.
    double evaluate(const Positions& positions, Eigen::Matrix4Xd& gradient) const;

    LaplacianPart& m_part;
    std::vector<Slide> m_slides;
    const Positions* m_centres = nullptr;
    LbfgsHistory<Eigen::Matrix4Xf> m_history{6};
    double m_energy = 0, m_step = 0;
    Eigen::Matrix4Xd m_gradient, m_next_gradient;  // the fourth row is zero
    // Single precision is enough to learn from and to go along: minus the gradient, the move, the change of gradient.
    Eigen::Matrix4Xf m_descent, m_direction, m_gradient_change;
    Positions m_origin;
};

}  // namespace chebnet
