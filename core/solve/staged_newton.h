#pragma once

#include <memory>
#include <vector>

#include "energy/edge_energy.h"
#include "linear/graph_system.h"
#include "solve/free_part.h"
#include "solve/method.h"

namespace chebnet {

/// The paper's solver (Li et al. 2022, sections 3.2 and 3.3) for any energy of edge ratios: Newton steps with the
/// energy's convex stand-in for the Hessian, handles exact, Armijo backtracking, in three stages:
///
///   1  exponent p_start, until max dL < switch_deviation;
///   2  exponent p_end, until max dL < reduction_deviation;
///   3  exponent p_end, only the vertices of edges with dL > active_fraction · threshold and their rings free.
///
/// A solve ends when max dL < threshold, or when the energy's relative change or the gradient falls below its
/// tolerance. Where the paper is silent: a minimum in stage 1 goes on to stage 2, since a larger exponent evens out
/// what is left; a minimum in stage 3 that is none of the whole net's frees all vertices again for the rest of the
/// solve.
class StagedNewton : public Method {
public:
    using MakeEnergy = std::unique_ptr<EdgeEnergy> (*)(double p);
    explicit StagedNewton(MakeEnergy make_energy) : m_make_energy(make_energy) {}

    void prepare(const Net& net, const Topology& topology, std::span<const int> handle_vertices) override;
    Status start(Positions& positions, const Options& options, bool reachable) override;
    Status iterate(Positions& positions, TraceRow& row) override;

private:
    struct LineSearch {
        double step;
        bool accepted;
    };

    void choose_stage();
    void enter_stage(int stage);
    std::vector<bool> vertices_near_bad_edges() const;
    Eigen::Matrix3Xd assemble(const FreePart& part, BlockSystem& system, const Positions& positions) const;
    double energy(const FreePart& part, const Positions& positions) const;
    LineSearch search_line(const FreePart& part, Positions& positions, const Eigen::Matrix3Xd& direction,
                           double slope) const;
    void measure(const Positions& positions);
    Status at_minimum();
    void free_all_vertices();

    MakeEnergy m_make_energy;
    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    std::vector<bool> m_is_free;
    std::unique_ptr<FreePart> m_all;  // every vertex but the handles
    std::unique_ptr<BlockSystem> m_all_system;
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

}  // namespace chebnet
