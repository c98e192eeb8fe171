#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/options.h"
#include "solve/parts/coordinate_metric.h"
#include "solve/parts/free_part.h"
#include "solve/parts/length_projection.h"
#include "solve/parts/neighbour_form.h"
#include "solve/parts/neighbour_pairs.h"
#include "solve/parts/neighbour_system.h"
#include "solve/parts/turned_move.h"
#include "solve/pull.h"
#include "solve/slide.h"
#include "solve/terms/term.h"

namespace chebnet {

class FreeMotions;

/// Newton's method for the least energy among nets whose edges have their lengths: at a net x,
///
///     minimise  ∇E·d + ½ d·H d   subject to  J d = 0,
///
/// where J is the Jacobian of the lengths and H the curvature of the energy and of the lengths, Σ λ_e ∇²c_e. Solved by
/// projected conjugate gradients (Gould, Hribar, Nocedal 2001), cut short: what the first tens of iterations leave is
/// the next step's to correct. The preconditioner is Π M⁻¹ Πᵀ, with M a fixed form that treats the coordinates alike,
/// factored once for a set of handles (for each coordinate, where vertices slide), and Π the projection onto J d = 0 by
/// the factor of the system of lengths, in which what is pulled hard moves little, as it does in H. Where many
/// iterations are left, H itself with stiff lengths, factored in single precision, takes M's place.
class TangentNewton {
public:
    /// Keeps references to net, topology and part, of which some vertices may slide.
    TangentNewton(const Net& net, const Topology& topology, const FreePart& part, std::span<const Slide> slides = {});
    ~TangentNewton();

    /// Moves have nothing of what nothing resists from now on, see FreeMotions. A guide resists everything.
    void find_free_motions(bool is_guided, std::span<const Pull> pulls, const Options& options);
    /// Takes over the bounds of these terms, and factors M anew.
    void set_metric(std::span<const std::unique_ptr<Term>> terms);
    /// How free vertices follow if fixed ones move by the columns of `moves` (3×V), and those that slide by what they
    /// have there across their axes: as smoothly as M allows. Fills in the rest.
    void extend(Eigen::Matrix3Xd& moves);
    /// How what is free gives way to a load of these forces (3×V), by M; 0 where it is held.
    void give_way(const Eigen::Matrix3Xd& load, Eigen::Matrix3Xd& moves) const;

    /// Turns a move d that keeps lengths to first order towards where H curves least beside M, by so many steps to
    /// d − M⁻¹ H d at most, at the net of the last linearise(). True as soon as d·H d < 0.
    bool find_negative_curvature(std::span<const std::unique_ptr<Term>> terms, int most_steps, Eigen::Matrix3Xd& d);

    /// A move with d·H d < 0 that keeps lengths to first order, by so many conjugate gradients at most from how the net
    /// gives way to a load that favours nothing. False if no edge pushes, or none is found. Only at the net of the last
    /// linearise().
    bool find_buckling(std::span<const std::unique_ptr<Term>> terms, int most_iterations, Eigen::Matrix3Xd& d);

    /// Takes a net and the gradient of its energy there, and finds the multipliers λ of ∇E + Jᵀλ = 0 that fit best.
    /// False if that cannot be done.
    /// `lengths` is kept, its system is assembled and factored for x. It may have rows beside the edges.
    bool linearise(const Positions& x, const Eigen::Matrix3Xd& gradient, LengthProjection& lengths);
    /// Moves from now on make the rows of the system shorter by these, in edge lengths, until the next linearise().
    /// False if that cannot be done.
    bool shorten(const Eigen::VectorXd& rows);
    /// Whether linearise() finds λ however slowly: else it takes a part from the tension of lines that are nearly
    /// straight, and leaves a force that no move takes off.
    void find_whole_tension(bool on);
    /// λ of each row of the system: positive where it pulls.
    const Eigen::VectorXd& multipliers() const { return m_multipliers; }
    /// Those of before are what the search for new ones begins with, and so a trace of the way here.
    void forget_multipliers() { m_multipliers.setZero(); }
    /// ‖∇E + Jᵀλ‖ over what may move.
    double gradient_norm() const { return m_gradient_norm; }
    /// What the errors of lengths cost at the net of the last linearise(), λ·c. E + λ·c differs from the energy of the
    /// exact net by the square of the errors only.
    double error_cost() const { return m_error_cost; }
    double factorisation_ms() const { return m_factorisation_ms; }  ///< of the last linearise()

    /// Factors H itself, with stiff lengths, at the net of the last linearise(): from now on it takes M's place, also
    /// at other nets, which is worth more iterations than it costs where they are many. False if that cannot be done.
    bool factorize(std::span<const std::unique_ptr<Term>> terms);
    /// Back to M.
    void put_factor_away() { m_factor_is_used = false; }
    /// Uses the last factor again, of whatever net it is. False if there is none for the terms as they are.
    bool take_last_factor() { return m_factor_is_used = m_has_factor; }
    bool uses_factor() const { return m_factor_is_used; }

    /// A move that lowers the energy, zero on fixed vertices and across the axes of those that slide, by so many
    /// iterations at most; fewer if they have brought the residual to this part. No vertex moves farther than `radius`:
    /// where the minimum is farther, or where there is none since the curvature along the way is negative, the move
    /// ends at that distance (Steihaug 1983). Returns its slope ∇E·d, negative unless there is none.
    double find_move(std::span<const std::unique_ptr<Term>> terms, Curvature kind, int most_iterations,
                     double tolerance, double radius, Eigen::Matrix3Xd& move);
    /// The same, beginning with what the rows as they are now leave of a move that was found, inside of the radius, for
    /// the rows of before. The tolerance is of what there was to do then.
    double improve_move(std::span<const std::unique_ptr<Term>> terms, Curvature kind, int most_iterations,
                        double radius, Eigen::Matrix3Xd& move);
    /// What is left of a move beside the rows as they are now. Returns its slope.
    double restrict(Eigen::Matrix3Xd& move);

    /// Takes a move of the net at x; both must last.
    void begin_way(const Positions& x, const Eigen::Matrix3Xd& move) { m_way.begin(m_net, m_topology, x, move); }
    /// This part of it, as a turn where the net turns (TurnedMove), as near to that as the norm M can tell. What is
    /// fixed goes straight, and so does what slides across its axes.
    void go(double part, Positions& to);
    bool ended_at_radius() const { return m_ended_at_radius; }                ///< whether the last move did
    bool met_negative_curvature() const { return m_met_negative_curvature; }  ///< likewise
    int inner_iterations() const { return m_inner_iterations; }               ///< of the last move

private:
    double descend(std::span<const std::unique_ptr<Term>> terms, Curvature kind, int most_iterations, double radius,
                   Eigen::Matrix3Xd& move);
    void find_residual(std::span<const std::unique_ptr<Term>> terms, Curvature kind, const Eigen::Matrix3Xd& move);
    double part_to_radius(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& along, double most,
                          double radius) const;
    void mask(Eigen::Matrix3Xd& vectors) const;
    void project(Eigen::Matrix3Xd& moves);
    void project_forces(Eigen::Matrix3Xd& forces);
    void weigh(int power, Eigen::Matrix3Xd& vectors) const;
    void precondition(const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to);
    void apply_hessian(std::span<const std::unique_ptr<Term>> terms, Curvature kind, const Eigen::Matrix3Xd& d);
    void add_tension(const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const;

    const Net& m_net;
    const Topology& m_topology;
    const FreePart& m_part;
    LengthProjection* m_lengths = nullptr;
    std::vector<int> m_fixed;  // vertices
    std::vector<Slide> m_slides;
    std::vector<std::pair<int, double>> m_firm;  // vertices where the W of lengths is below 1, and it
    std::shared_ptr<FreeMotions> m_free_motions;
    bool m_is_free = false;  // to move as a whole, as these say
    // M as links and weights at vertices.
    NeighbourPairs m_pairs;
    NeighbourForm m_form;
    std::vector<std::unique_ptr<CoordinateMetric>> m_metrics;
    std::unique_ptr<NeighbourSystem> m_blocks;  // made when needed
    bool m_has_factor = false, m_factor_is_used = false;

    LengthProjection::Accuracy m_accuracy;  // of λ
    Eigen::VectorXd m_multipliers;
    bool m_ended_at_radius = false, m_met_negative_curvature = false;
    int m_inner_iterations = 0;
    double m_gradient_norm = 0, m_error_cost = 0, m_factorisation_ms = 0;
    double m_enough = 0;         // of the squared residual in the norm of the preconditioner
    Eigen::Matrix3Xd m_descent;  // −(∇E + Jᵀλ)
    Eigen::Matrix3Xd m_normal;   // the shortest move that shortens rows as asked
    double m_normal_slope = 0;   // −λ·J m_normal
    TurnedMove m_way;
    Eigen::Matrix3Xd m_residual, m_preconditioned, m_search, m_image;
    Eigen::VectorXd m_changes, m_pulls;
};

}  // namespace chebnet
