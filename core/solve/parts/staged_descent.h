#pragma once

#include <array>
#include <memory>
#include <vector>

#include "energy/edge_energy.h"
#include "solve/method.h"
#include "solve/parts/descent_direction.h"
#include "solve/parts/free_part.h"

namespace chebnet {

/// The paper's workflow (Li et al. 2022, sections 3.2 and 3.3) for any energy of edge ratios and any direction of
/// descent: handles exact, Armijo backtracking, three stages:
///
///   1  exponent p_start, until max dL < switch_deviation;
///   2  exponent p_end, until max dL < reduction_deviation;
///   3  exponent p_end, only the vertices of edges with dL > active_fraction · threshold and their rings free.
///
/// A solve ends when max dL < threshold, or when the energy's relative change or the gradient falls below its
/// tolerance; that of energies which are flatter than quadratic at the solution is judged by what it is near the
/// threshold, see EdgeEnergy::relative_slope(). Where the paper is silent: a minimum in stage 1 goes on to stage 2,
/// since a larger exponent evens out what is left. Where this departs from it unless the option reduce_once is on:
/// stage 3 chooses its vertices anew each iteration, and a minimum there that is none of the whole net's frees all
/// vertices again for the rest of the solve.
class StagedDescent : public Method {
public:
    using MakeEnergy = std::unique_ptr<EdgeEnergy> (*)(double p, const Options& options);
    /// What a method fixes among the options.
    using Adjust = void (*)(Options& options);
    StagedDescent(
        MakeEnergy make_energy, std::unique_ptr<DescentDirection> direction, Adjust adjust = [](Options&) {});

    void prepare(const Problem& problem) override;
    Status start(const Problem& problem, Positions& positions, const Options& options) override;
    Status iterate(Positions& positions, TraceRow& row) override;

private:
    bool step(Positions& positions, TraceRow& row);
    void choose_stage();
    void enter_stage(int stage);
    std::vector<bool> vertices_near_bad_edges() const;
    Eigen::Matrix3Xd gradient(const FreePart& part, const Positions& positions) const;
    double energy(const FreePart& part, const Positions& positions) const;
    double search_line(const FreePart& part, Positions& positions, const Eigen::Matrix3Xd& direction,
                       double slope) const;
    void measure(const Positions& positions);
    Status at_minimum();
    void free_all_vertices();
    void reduce_if_needed();

    MakeEnergy m_make_energy;
    std::unique_ptr<DescentDirection> m_direction;
    Adjust m_adjust;

    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    std::vector<bool> m_is_free;
    std::unique_ptr<FreePart> m_all;      // every vertex but the handles
    std::unique_ptr<FreePart> m_reduced;  // of stage 3
    Options m_options;
    bool m_reachable = true;

    std::unique_ptr<EdgeEnergy> m_energy;  // with the stage's exponent
    double m_p = 0;
    int m_stage = 0;
    bool m_reduction_allowed = true;
    Eigen::VectorXd m_ratios;  // at the present positions
    double m_max_deviation = 0;
    double m_total_energy = 0;  // over all edges that can change, at the present positions
};

/// What its stages are called.
inline constexpr std::array k_staged_names{"Small exponent", "Large exponent", "Worst edges"};

/// For StagedDescent: an energy that needs to know its exponent only.
template <typename Energy>
std::unique_ptr<EdgeEnergy> make_energy(double p, const Options&) {
    return std::make_unique<Energy>(p);
}

/// For StagedDescent: no third stage. Where an iteration costs O(E) in any case, fewer variables gain nothing, and a
/// history of other variables is lost; where few iterations are needed, another factorisation's symbolic work is.
inline void keep_all_vertices(Options& options) { options.adaptive_reduction = false; }

}  // namespace chebnet
