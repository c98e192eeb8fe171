#include <catch2/catch.hpp>
#include <random>

#include "energy/power_energy.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/parts/lbfgs_direction.h"

using namespace chebnet;

namespace {

/// Energy (3) of a net with p = 2, without handles.
struct Landscape {
    Net net = samples::patch(5, 4);
    FreePart part{net, free_vertices(net.vertex_count(), {})};
    PowerEnergy energy{2};

    Eigen::Matrix3Xd gradient(const Positions& x) const {
        Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, x.cols());
        const Eigen::VectorXd ratios = edge_ratios(net, x);
        for (int e = 0; e < net.edge_count(); ++e) {
            const int a = net.edges()(0, e), b = net.edges()(1, e);
            const double L = net.rest_lengths()[e];
            const Eigen::Vector3d force = energy.slope(ratios[e]) / L * (x.col(a) - x.col(b)).normalized();
            sum.col(a) += force;
            sum.col(b) -= force;
        }
        return sum;
    }

    Eigen::Matrix3Xd direction(DescentDirection& method, const Positions& x) const {
        Eigen::Matrix3Xd found;
        TraceRow row;
        REQUIRE(method.find({net, part, energy, x, edge_ratios(net, x), gradient(x)}, found, row));
        return found;
    }
};

Editor solving_patch(std::string_view method) {
    Editor editor(samples::patch(7, 6));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 6, 35, 41});
    handles.back().target += Eigen::Vector3d(-0.5, -0.3, 1);
    editor.set_handles(handles);
    editor.set_method(method);
    editor.set_option("max_iterations", "2000");
    return editor;
}

}  // namespace

TEST_CASE("L-BFGS without a history is gradient descent, with one it keeps the secant condition and descends") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Landscape land;
    Positions x = samples::shaken(land.net.rest_positions(), 0.1, random);
    GradientDirection steepest;
    LbfgsDirection lbfgs;
    steepest.restart();
    lbfgs.restart();
    const Eigen::Matrix3Xd first = land.direction(lbfgs, x);
    CHECK(first == land.direction(steepest, x));
    CHECK((first + land.gradient(x)).norm() < 1e-12 * first.norm());  // edges have length 1

    Eigen::Matrix3Xd move = first;
    for (int k = 0; k < 30; ++k) {
        const double step = k == 0 ? 0.01 : 0.1;
        lbfgs.accepted(step);
        x += step * move;
        move = land.direction(lbfgs, x);
        CHECK(samples::dot(move, land.gradient(x)) < 0);
    }
    lbfgs.restart();
    steepest.restart();
    CHECK(land.direction(lbfgs, x) == land.direction(steepest, x));
}

TEST_CASE("With one correction L-BFGS is the memoryless BFGS update") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Landscape land;
    const Positions x = samples::shaken(land.net.rest_positions(), 0.05, random);
    LbfgsDirection lbfgs;
    lbfgs.restart();
    const Eigen::VectorXd s = 0.01 * land.direction(lbfgs, x).reshaped();
    lbfgs.accepted(0.01);
    const Positions next = x + s.reshaped(3, x.cols());
    const Eigen::VectorXd g = land.gradient(next).reshaped(), y = g - land.gradient(x).reshaped();
    // H = (I − ρ s yᵀ) γ (I − ρ y sᵀ) + ρ s sᵀ, ρ = 1 / sᵀy, γ = sᵀy / yᵀy (Nocedal & Wright, eq. 7.16 and 7.20).
    const double rho = 1 / s.dot(y), gamma = s.dot(y) / y.dot(y);
    const Eigen::MatrixXd V = Eigen::MatrixXd::Identity(s.size(), s.size()) - rho * y * s.transpose();
    const Eigen::VectorXd expected = -(gamma * V.transpose() * V + rho * s * s.transpose()) * g;
    const Eigen::VectorXd found = land.direction(lbfgs, next).reshaped();
    CHECK((found - expected).norm() < 1e-9 * expected.norm());
}

TEST_CASE("First-order methods lower the energy in every step and keep all vertices free") {
    const std::string method = GENERATE("gradient_descent", "lbfgs");
    Editor editor = solving_patch(method);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(editor.handle_error() == 0);
    const Trace& trace = report.trace;
    for (std::size_t k = 0; k < trace.size(); ++k) {
        CHECK(trace[k].free_vertices == editor.net().vertex_count() - 4);
        CHECK(trace[k].stage < 3);
        if (k > 0 && trace[k].p == trace[k - 1].p) CHECK(trace[k].energy < trace[k - 1].energy);
    }
}

TEST_CASE("L-BFGS needs far fewer iterations than gradient descent, Newton's kind fewer still") {
    const auto iterations = [](std::string_view method) { return solving_patch(method).solve().iterations; };
    const int newton = iterations("li2022"), lbfgs = iterations("lbfgs"), gradient = iterations("gradient_descent");
    CHECK(2 * newton < lbfgs);
    CHECK(2 * lbfgs < gradient);
}
