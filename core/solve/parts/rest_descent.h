#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/options.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/free_part.h"
#include "solve/parts/net_constraints.h"
#include "solve/parts/path_extrapolation.h"
#include "solve/parts/rest_energy.h"
#include "solve/parts/tangent_newton.h"
#include "solve/pull.h"
#include "solve/rest_state.h"
#include "solve/slide.h"
#include "solve/trace.h"

namespace chebnet {

class PullWalk;

/// The descent from net to net until one is at rest: Newton steps for the energy among nets (TangentNewton), each
/// turning the net where it turns (TurnedMove), projected onto the lengths and out of corners that are too sharp
/// (NetConstraints), until the gradient that these leave is below Options::rest_tolerance. Where steps follow a valley
/// of the energy, they are carried on along it (PathExtrapolation). What stiff soft handles pull towards from afar
/// comes there in steps of an edge length at most, with a Newton step each (PullWalk). A net towards whose bending
/// nothing pushes to first order, flat or with straight lines, is given a bow where it would lose energy by it.
class RestDescent {
public:
    /// Another net, of which nothing is known. Keeps references.
    void set_net(const Net& net, const Topology& topology);
    /// Other handles: what Newton's method knows of those of before is of no use.
    void forget_handles();

    /// Whether an energy is chosen, which Options like these would choose again.
    bool has_energy_of(const Options& options) const;
    void forget_energy() { m_rest_energy.forget(); }
    /// Takes another energy, see RestEnergy::choose(), and if it is to be kept another limit of the corners.
    void choose_energy(const Positions& rest_shape, const Options& options, std::span<const Pull> pulls,
                       const Guide* guide, double unit, const std::vector<bool>& weightless, RestEnergy::Limit is,
                       CornerLimit limit);
    void set_options(const Options& options) { m_options = options; }
    /// What it takes to make steps with these handles, and the energy's pulls at their targets. Keeps a reference to
    /// the part. Throws Error too_large where the systems for it would be. `positions`: near where it begins.
    void prepare(const FreePart& part, const std::vector<bool>& is_free, std::span<const Slide> slides,
                 std::span<const Pull> pulls, const Positions& positions);
    bool is_prepared() const { return m_constraints && m_newton; }
    /// What steps of before have left does not count in those that follow.
    void forget_multipliers() { m_newton->forget_multipliers(); }
    /// The net is not at rest with the pulls of before.
    void forget_pulls() { m_pulls_are_known = false; }

    /// How free vertices follow if what is held moves by these columns, as smoothly as the energy's bound allows.
    void extend(Eigen::Matrix3Xd& moves) { m_newton->extend(moves); }
    /// Moves that squeeze a flat net get what makes it bow out of its plane, in the shape in which an even load bends
    /// it, to the side to which they lead it, or else weight, soft handles, a guide or rods that are bent when free.
    void add_bow(const Positions& positions, Eigen::Matrix3Xd& moves);
    /// Onto the lengths and out of corners that are too sharp. If that fails, the corners are held that were before.
    bool project(Positions& positions);

    /// A solve begins; where the last one has left the net, or elsewhere.
    void begin_solve(bool is_as_left);
    /// The next step is again the first of a solve: handles are still moving.
    void begin_steps() { m_steps = 0; }
    /// Takes this net.
    void enter(const Positions& positions);
    /// At the net entered: pieces of it in which nothing is held, and that hang on one soft handle alone, go along with
    /// that as they are, where this is less energy for all of them together.
    void follow_lone_pulls(std::span<const std::vector<int>> loose_pieces, std::span<const Pull> pulls,
                           Positions& positions);
    /// One Newton step, within the trust region that the steps before have left. Only where is_linearised().
    void take_step(Positions& positions, TraceRow& row);
    /// One step to rest from the net that the last one ended with, or from a bow.
    Status relax(Positions& positions, TraceRow& row);
    /// The end of a way that leads no farther, at these positions: `exact`, or `stalled` where they are beyond a
    /// constraint.
    Status end_at(const Positions& positions);

    // At the net last entered or come to by a step:
    bool is_linearised() const { return m_is_linearised; }
    bool is_at_rest() const { return m_is_still && !m_pulls_walk && is_balanced(); }
    double energy() const { return m_energy; }
    double deviation() const { return m_max_deviation; }  ///< max dL
    /// What is said of it, at `positions`; nullopt if no multipliers are known. Keeps references to these and `pulls`.
    std::optional<RestState> state(const Positions& positions, std::span<const Pull> pulls) const;

private:
    bool project(Positions& positions, double threshold);
    bool is_net() const;
    bool is_balanced() const;
    Status stuck() const;
    Status step_to_rest(Positions& positions, TraceRow& row);
    bool is_idle(double energy_before, double force_before);
    bool give_way(Positions& positions);
    bool goes_on_beside_taut_lines(Positions& positions);
    bool find_bow(const Eigen::Vector3d& normal, Eigen::Matrix3Xd& bow);
    void give_way_to(const Eigen::Vector3d& load, Eigen::Matrix3Xd& moves) const;
    bool rises_along(const Positions& positions, const Eigen::Matrix3Xd& move);
    void refine_lengths(Positions& positions);
    bool follow_path(Positions& positions);
    bool linearise(const Positions& positions);
    double gradient_norm() const;
    double motion_left() const;
    void take_pulls(std::span<const Pull> pulls);
    std::span<const Pull> pulls_on_their_way() const;
    void begin_pull_walk(const Positions& positions);
    void walk_pulls_to(double part, const Positions& positions);
    Status follow_pulls(Positions& positions, TraceRow& row);
    Eigen::Matrix3Xd follow(std::span<const Pull> moves) const;
    void renew_factor(TraceRow& row);
    double find_move_beside_corners(const Positions& positions);
    double find_move();
    double improve_move();
    int inner_iterations() const;
    double step_along(Positions& positions, double slope, double whole);
    double error_cost();

    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    Options m_options;
    RestEnergy m_rest_energy;
    bool m_is_guided = false;  // by one of its terms
    CornerLimit m_limit;
    std::unique_ptr<NetConstraints> m_constraints;  // whatever the handles
    std::unique_ptr<TangentNewton> m_newton;        // for these handles
    bool m_has_metric = false;                      // of the terms as they are
    std::vector<bool> m_is_loose;                   // V, see loose_vertices()
    std::shared_ptr<PullWalk> m_pull_walk;          // the last one; null: none so far
    // Whether it tells where the net has pulls; a new one begins with the next step, if any is far; it is under way.
    bool m_pulls_are_known = false, m_pulls_wait = false, m_pulls_walk = false;

    int m_steps = 0;               // Newton steps of this solve, or since handles have moved
    double m_radius = 0;           // no vertex moves farther in the next step
    bool m_has_given_way = false;  // in this solve
    int m_beginnings = 0;          // likewise, beside taut lines
    bool m_is_linearised = false;  // where it is, as m_newton is
    bool m_is_still = false;       // the last step was a whole one, and short
    bool m_is_careful = false;     // corners are let go one by one: together they led nowhere
    int m_idle_steps = 0;          // one after the other
    double m_gradient_before = 0,
           m_moved = 0;  // of the last step: the norm before, and how far it went in edge lengths
    PathExtrapolation m_path;
    // Where it is:
    double m_energy = 0;
    Eigen::Matrix3Xd m_gradient;
    double m_max_deviation = 0;
    double m_lack = 0;  // of the limit

    Eigen::Matrix3Xd m_direction, m_next_gradient;
    Positions m_origin;    // of a step; while a path is followed, its next point
    Positions m_farthest;  // where such a path led with the least energy
};

}  // namespace chebnet
