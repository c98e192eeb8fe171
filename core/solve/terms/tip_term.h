#pragma once

#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/terms/term.h"

namespace chebnet {

/// What keeps a net flat about inner singular vertices. Net lines end there, so that nothing bends by BendingTerm, and
/// three quads with right angles make the corner of a cube. With t_i = (x_i − x_b) / L_i for the edges at such a b,
///
///     E = w Σ_b ‖Σ_i t_i‖².
///
/// It is 0 where they lie in a plane at equal angles, and 3 w at the corner of a cube.
class TipTerm : public Term {
public:
    /// `weight`: w. Keeps nothing of the arguments.
    TipTerm(const Net& net, const Topology& topology, double weight);

    const char* name() const override { return "tips"; }
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) override;
    void add_curvature(Curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const override;
    void add_blocks(BlockForm& form) const override;
    void add_bound(QuadraticForm& form) const override;

private:
    struct Spoke {
        int end;
        double inverse_length;
    };
    struct Hub {
        int vertex;
        std::vector<Spoke> spokes;
    };
    /// dᵀ M d = Σ w_ab ‖d_a − d_b‖², M half the Hessian: a, b and w of each pair.
    template <class AddLink>
    void add_links(const AddLink& add_link) const;
    /// Adds the Hessian times x, 2 M x, to `product`, and returns xᵀ M x.
    double multiply(const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& product) const;

    double m_weight;
    std::vector<Hub> m_hubs;  // the inner singular vertices
};

}  // namespace chebnet
