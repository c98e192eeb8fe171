#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "energy/composite_power_energy.h"
#include "energy/power_energy.h"
#include "energy/projected_power_energy.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/methods/methods.h"
#include "solve/parts/newton_direction.h"

using namespace chebnet;

namespace {

/// The whole net's energy with its gradient and its true Hessian over the free vertices, dense.
struct DenseNewton {
    DenseNewton(const Net& net, const FreePart& part, const EdgeEnergy& energy, const Positions& x)
        : ratios(edge_ratios(net, x)),
          gradient(Eigen::Matrix3Xd::Zero(3, part.size())),
          hessian(Eigen::MatrixXd::Zero(3 * part.size(), 3 * part.size())) {
        for (const FreePart::Edge& edge : part.edges()) {
            const double L = net.rest_lengths()[edge.index], r = ratios[edge.index];
            const Eigen::Vector3d u =
                (x.col(net.edges()(0, edge.index)) - x.col(net.edges()(1, edge.index))).normalized();
            const EdgeCurvature c = energy.hessian(r);
            const Eigen::Matrix3d B =
                (c.tangential * Eigen::Matrix3d::Identity() + (c.radial - c.tangential) * u * u.transpose()) / (L * L);
            const int ends[] = {edge.node_a, edge.node_b};
            for (int i = 0; i < 2; ++i) {
                if (ends[i] < 0) continue;
                gradient.col(ends[i]) += (i == 0 ? 1 : -1) * energy.slope(r) / L * u;
                for (int j = 0; j < 2; ++j)
                    if (ends[j] >= 0) hessian.block<3, 3>(3 * ends[i], 3 * ends[j]) += (i == j ? 1 : -1) * B;
            }
        }
    }
    Eigen::VectorXd ratios;
    Eigen::Matrix3Xd gradient;
    Eigen::MatrixXd hessian;
};

/// A patch pulled apart by its corners beyond its reach: all edges are stretched at the minimum.
Editor stretched_patch() {
    Editor editor(samples::patch(6, 5, 0));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 5, 24, 29});
    for (Handle& handle : handles) handle.target = 1.5 * handle.target + Eigen::Vector3d(0, 0, 0.1 * handle.vertex);
    editor.set_handles(handles);
    editor.set_positions(1.5 * editor.net().rest_positions());
    return editor;
}

/// Of the edges whose length has changed, the part that is longer than at rest.
double share_of_longer_edges(const Editor& editor) {
    int longer = 0, changed = 0;
    for (double r : edge_ratios(editor.net(), editor.positions())) {
        changed += deviation(r) > 1e-8;
        longer += deviation(r) > 1e-8 && r > 1;
    }
    return static_cast<double>(longer) / changed;
}

}  // namespace

TEST_CASE("Where all edges are stretched, projected Newton's and composite majorization's step is Newton's") {
    const Editor editor = stretched_patch();
    const Net& net = editor.net();
    const FreePart part(net, free_vertices(net.vertex_count(), std::vector<int>{0, 5, 24, 29}));
    const double p = GENERATE(2.0, 8.0);
    for (const auto& energy : {std::shared_ptr<PowerEnergy>(new ProjectedPowerEnergy(p)),
                               std::shared_ptr<PowerEnergy>(new CompositePowerEnergy(p))}) {
        const DenseNewton newton(net, part, *energy, editor.positions());
        REQUIRE(newton.ratios.minCoeff() > 1);
        NewtonDirection method;
        method.prepare(part);
        Eigen::Matrix3Xd direction;
        TraceRow row;
        REQUIRE(method.find({net, part, *energy, editor.positions(), newton.ratios, newton.gradient}, direction, row));
        const Eigen::VectorXd expected = -newton.hessian.ldlt().solve(newton.gradient.reshaped());
        CHECK((direction.reshaped() - expected).norm() < 1e-10 * expected.norm());
    }
}

TEST_CASE("Newton's method converges quadratically, the paper's majorizer linearly") {
    // A gradient this small changes the energy by less than its own rounding; Armijo's rule sees no further.
    constexpr double k_rounding = 1e-7;
    const auto gradient_norms = [](std::unique_ptr<Method> method) {
        Editor editor = stretched_patch();
        Positions x = editor.positions();
        const std::vector<int> fixed{0, 5, 24, 29};
        const Problem problem{editor.net(), editor.topology(), fixed};
        method->prepare(problem);
        Options options;
        options.threshold = 1e-24;
        options.energy_tolerance = options.gradient_tolerance = 0;
        REQUIRE(method->start(problem, x, options) == Status::running);
        std::vector<double> norms;
        for (int k = 0; k < 8; ++k) {
            TraceRow row;
            method->iterate(x, row);
            if (row.stage != 1) break;  // no step is found at the minimum, and the next exponent begins
            norms.push_back(row.gradient_norm);
        }
        return norms;
    };
    for (const auto& make : {k_projected_newton.make, k_composite_majorization.make}) {
        const std::vector<double> norms = gradient_norms(make());
        for (std::size_t k = 1; k < norms.size(); ++k)
            if (norms[k - 1] < 0.1) CHECK(norms[k] < norms[k - 1] * norms[k - 1] + k_rounding);
        CHECK(norms.back() < k_rounding);
    }
    const std::vector<double> paper = gradient_norms(k_li2022.make());
    for (std::size_t k = 1; k < paper.size(); ++k) CHECK(paper[k] < paper[k - 1]);
    CHECK(paper.back() > 10 * k_rounding);
}

TEST_CASE("The shift never reaches the paper's majorizer in its own workflow") {
    // Stage 1: any ratio a pull leaves, beside edges at rest. Stage 2: ratios with dL below the switch.
    for (double r = 0.1; r < 50; r *= 1.1) CHECK(PowerEnergy(2).curvature(r).tangential == Approx(4 - 2));
    const Options options;
    const double mean_radial = PowerEnergy(options.p_end).curvature(1).radial;
    for (double r = 0.9; r < 1.1; r += 0.001)
        if (deviation(r) < options.switch_deviation)
            CHECK(PowerEnergy(options.p_end).curvature(r).tangential > k_smallest_weight * mean_radial);
}

TEST_CASE("Edges at rest or compressed alone leave composite majorization a direction of descent") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = GENERATE(0, 1) == 0 ? samples::patch(5, 4) : samples::mixed_mesh();
    const FreePart part(net, free_vertices(net.vertex_count(), std::vector<int>{0, 4}));
    const Positions x = samples::shaken(0.9 * net.rest_positions(), 0.01, random);
    for (const double p : {2.0, 50.0}) {
        const CompositePowerEnergy energy(p);
        const DenseNewton at(net, part, energy, x);
        NewtonDirection method;
        method.prepare(part);
        Eigen::Matrix3Xd direction;
        TraceRow row;
        REQUIRE(method.find({net, part, energy, x, at.ratios, at.gradient}, direction, row));
        CHECK(direction.allFinite());
        CHECK(direction.cwiseProduct(at.gradient).sum() < 0);
    }
}

TEST_CASE("Figure 8: composite majorization favours L_e > L on the way, the paper's majorizer does not") {
    // An edge at rest has no tangential stiffness: the first step keeps all lengths to first order by turning edges,
    // and to second order that lengthens every one of them.
    const auto after = [](std::string_view method, int iterations) {
        Editor editor(samples::patch(20, 18));
        std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 19, 340, 359});
        handles.back().target += Eigen::Vector3d(-1.5, -1.0, 3);
        editor.set_handles(handles);
        editor.set_method(method);
        editor.solve({iterations});
        return share_of_longer_edges(editor);
    };
    CHECK(after("composite_majorization", 1) > 0.95);
    CHECK(after("projected_newton", 1) > 0.95);
    CHECK(after("li2022", 1) < 0.7);
    CHECK(after("composite_majorization", 2) > 0.7);
    CHECK(after("li2022", 2) < 0.7);
}

TEST_CASE("A net without handles finds its lengths") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::string method = GENERATE("li2022", "composite_majorization", "projected_newton", "dp4");
    Editor editor(samples::patch(7, 6));
    editor.set_method(method);
    editor.set_option("gradient_tolerance", "0");
    editor.set_positions(samples::shaken(editor.net().rest_positions(), 0.2, random));
    CHECK(editor.solve().status == Status::converged);
    CHECK(editor.positions().cwiseAbs().maxCoeff() < 20);
}

TEST_CASE("Gauss-Newton needs a small part of the paper's iterations") {
    const auto iterations = [](std::string_view method) {
        Editor editor(samples::patch(20, 18));
        std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 19, 340, 359});
        handles.back().target += Eigen::Vector3d(-1.5, -1.0, 3);
        editor.set_handles(handles);
        editor.set_method(method);
        const SolveReport report = editor.solve();
        REQUIRE(report.status == Status::converged);
        return report.iterations;
    };
    CHECK(2 * iterations("gauss_newton") < iterations("li2022"));
}
