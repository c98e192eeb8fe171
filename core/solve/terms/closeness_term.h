#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "net/net.h"
#include "solve/terms/term.h"
#include "surface/guide.h"

namespace chebnet {

/// Closeness to a surface, E = w Σ_v d_v² / L², d_v being the distance of a vertex from the nearest point of the
/// surface, or from where it would go on beyond its border as flat as it is there; L is the net's mean length. The
/// nearest point moves along with the vertex, so that ∇d² = 2 (x − nearest) and the Hessian is 2 w / L² times a
/// projection: onto the normal above a triangle, across it above an edge, and all of space above a vertex.
class ClosenessTerm : public Term {
public:
    /// Which vertices count: all, or those below the surface (contact): inside of a closed piece, or where the
    /// normals of an open one do not point.
    enum class Side { both, below };

    /// `unit`: of the net, in the guide's. Keeps a reference to the guide.
    ClosenessTerm(const Net& net, const Guide& guide, double unit, double weight, Side side);

    const char* name() const override { return "closeness"; }
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) override;
    void add_curvature(Curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const override;
    void add_blocks(BlockForm& form) const override;
    void add_bound(QuadraticForm& form) const override;

private:
    const Guide& m_guide;
    double m_unit, m_scale;  // w / L²
    Side m_side;
    std::vector<int> m_faces;                // V, where the nearest points were
    std::vector<Eigen::Matrix3d> m_changes;  // V, of the last evaluation; zero for what does not count
};

/// The same for those who may do without surfaces. Throws Error left_out in a build that does.
std::unique_ptr<Term> make_closeness_term(const Net& net, const Guide& guide, double unit, double weight,
                                          ClosenessTerm::Side side);

}  // namespace chebnet
