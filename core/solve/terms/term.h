#pragma once

#include <Eigen/Core>

#include "net/net.h"

namespace chebnet {

/// Collects a fixed quadratic form of positions that treats the three coordinates alike,
///
///     dᵀ M d = Σ w_ab ‖d_a − d_b‖² + Σ w_a ‖d_a‖².
class QuadraticForm {
public:
    virtual ~QuadraticForm() = default;
    virtual void add_link(int vertex_a, int vertex_b, double weight) = 0;
    virtual void add_vertex(int vertex, double weight) = 0;
};

/// Collects a symmetric matrix of 3×3 blocks.
class BlockForm {
public:
    virtual ~BlockForm() = default;
    /// `B`: symmetric.
    virtual void add_vertex(int vertex, const Eigen::Matrix3d& B) = 0;
    /// The block in the rows of the one and the columns of the other vertex, and its transpose in its mirror place.
    virtual void add_pair(int row_vertex, int column_vertex, const Eigen::Matrix3d& B) = 0;

    /// Adds [[B, −B], [−B, B]], B symmetric.
    void add_link(int vertex_a, int vertex_b, const Eigen::Matrix3d& B) {
        add_vertex(vertex_a, B);
        add_vertex(vertex_b, B);
        add_pair(vertex_a, vertex_b, -B);
    }
};

/// Which second derivative: the Hessian itself, which may be indefinite, or a positive semidefinite one in its place.
enum class Curvature { exact, convex };

/// A part of an energy of positions; energies add up. A term knows which vertices it is about and nothing else of the
/// net. Evaluating remembers what the other functions are about.
class Term {
public:
    virtual ~Term() = default;
    virtual const char* name() const = 0;

    /// Its energy at `x` (3×V). Adds its gradient to `gradient` (3×V).
    virtual double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) = 0;

    /// Adds H d to `product` (both 3×V), where H is the Hessian at the positions of the last evaluate(), or a positive
    /// semidefinite matrix in its place that is the same where nothing is strained.
    virtual void add_curvature(Curvature curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const = 0;

    /// Adds the convex H itself. It may join two vertices only if they are neighbours or have a common neighbour.
    virtual void add_blocks(BlockForm& form) const = 0;

    /// Adds a form M with dᵀ H d ≤ dᵀ M d everywhere, as tight as treating all directions alike allows.
    virtual void add_bound(QuadraticForm& form) const = 0;
};

}  // namespace chebnet
