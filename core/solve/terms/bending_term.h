#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/terms/term.h"

namespace chebnet {

/// Bending of net lines. With t_i = (x_i − x_b) / L_i for the edges at a vertex b, t_i⁰ the same at rest, and (i, j)
/// the pairs of edges by which net lines go through b,
///
///     E = w Σ_b min over rotations R_b of  Σ_(i,j) ‖t_i + t_j − R_b (t_i⁰ + t_j⁰)‖² + k Σ_i ‖t_i − R_b t_i⁰‖².
///
/// t_i + t_j is the second difference of the line's positions in edge lengths. The second sum, as rigid as possible
/// (Sorkine & Alexa 2007) with the small weight k, says how b's neighbourhood has turned where its lines are straight
/// or where there is no pair. R_b is the minimiser, so E is a function of positions alone, a rigid motion costs
/// nothing, and the gradient is that for R_b held (envelope theorem).
///
/// A line goes on by the edge that shares no face with the one it came by: through inner vertices of valence 4, along
/// the border through those of valence 3, and through those of valence 4 where the border turns inwards. Lines end at
/// other singular vertices, at corners, and at the border when they come from inside: nothing bends there but what k
/// holds together.
///
/// Edges may be stiffer or softer than others, as those of the two families of a net are: w and k count so many times.
class BendingTerm : public Term {
public:
    enum class Reference {
        rest,      ///< as above
        straight,  ///< rods that are straight when free: E = w Σ ‖t_i + t_j‖²
        curved,    ///< rods that were bent beforehand: as `rest`, with another t_i⁰, see bend_rest_lines()
    };

    /// `rest`: 3×V, the shape of t_i⁰. `weight`: w. `stiffness`: E, how many times it counts for each edge, alike for
    /// the two of a pair; empty: once. `curvature`: of rods that are `curved`. Keeps nothing of the arguments.
    BendingTerm(const Net& net, const Topology& topology, const Positions& rest, double weight, Reference reference,
                std::span<const double> stiffness = {}, double curvature = 0);

    const char* name() const override { return "bending"; }
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) override;
    /// With R_b free to turn along; the convex one as in a rest shape that has turned by R_b.
    void add_curvature(Curvature curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const override;
    void add_blocks(BlockForm& form) const override;
    void add_bound(QuadraticForm& form) const override;

private:
    /// An edge as seen from one of its ends, its place in the lists of vertex b being from m_start[b] on.
    struct Spoke {
        int vertex;   // the other end
        int partner;  // the spoke by which the net line goes on; −1: it ends
        double inverse_length;
        double weight;  // w, of this edge
    };

    void remember_rest_shape(const Net& net, const Positions& rest, double curvature);
    /// Net lines that go on through a vertex bend there, in the plane of their direction and the normal of the faces,
    /// as edges do whose ends lie on a circle of this curvature: above 0 away from where faces show their front, as the
    /// circles of a ball that is seen from outside. Not beyond a right angle.
    void bend_rest_lines(const Net& net, const Positions& rest, double curvature);
    void turn_cells();
    void find_compliances();
    /// Σ_j M_ij v_j for spoke i, M the form of E in the tangents of one vertex.
    Eigen::Vector3d formed(const Eigen::Matrix3Xd& v, int i) const {
        const Eigen::Vector3d own = v.col(i);
        const auto& [vertex, partner, inverse_length, weight] = m_spokes[i];
        return partner < 0 ? Eigen::Vector3d(m_cell_stiffness * weight * own)
                           : Eigen::Vector3d(m_cell_stiffness * weight * own + weight * (own + v.col(partner)));
    }
    Eigen::Vector3d tangent(const Eigen::Matrix3Xd& x, int b, int i) const {
        return m_spokes[i].inverse_length * (x.col(m_spokes[i].vertex) - x.col(b));
    }

    double m_weight;
    double m_cell_stiffness;   // k / w
    bool m_turns;              // whether there are rotations
    std::vector<int> m_start;  // V + 1, into the spokes
    std::vector<Spoke> m_spokes;
    Eigen::Matrix3Xd m_rest;                           // spokes: t_i⁰
    Eigen::Matrix3Xd m_rest_formed;                    // spokes: Σ_j M_ij t_j⁰
    std::vector<Eigen::Matrix3d> m_rest_compliance;    // V: inverse of the inertia of Σ M_ij t_i⁰ t_j⁰
    std::vector<Eigen::Matrix3d> m_turned_compliance;  // V: that turned by R_b
    std::vector<Eigen::Matrix3d> m_compliance;         // V: the same of Σ M_ij t_i (R_b t_j⁰)
    std::vector<Eigen::Quaterniond> m_quaternions;
    std::vector<Eigen::Matrix3d> m_rotations, m_covariances;
    Eigen::Matrix3Xd m_tangents;  // of the last evaluation, then differences from R t⁰
    Eigen::Matrix3Xd m_levers;    // spokes: R_b Σ_j M_ij t_j⁰
};

}  // namespace chebnet
