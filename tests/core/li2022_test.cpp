#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <utility>

#include "energy/power_energy.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/methods/methods.h"
#include "solve/parts/free_part.h"

using namespace chebnet;

namespace {

/// Energy (3), its gradient and the majorizer's Hessian of a whole net, dense and without any elimination.
struct WholeNet {
    WholeNet(const Net& net, const Positions& x, double p)
        : gradient(Eigen::VectorXd::Zero(x.size())), hessian(Eigen::MatrixXd::Zero(x.size(), x.size())) {
        const PowerEnergy energy(p);
        for (int e = 0; e < net.edge_count(); ++e) {
            const int a = 3 * net.edges()(0, e), b = 3 * net.edges()(1, e);
            const double L = net.rest_lengths()[e];
            const Eigen::Vector3d d = x.col(a / 3) - x.col(b / 3), u = d.normalized();
            const double r = d.norm() / L;
            value += energy.value(r);
            gradient.segment<3>(a) += energy.slope(r) / L * u;
            gradient.segment<3>(b) -= energy.slope(r) / L * u;
            // The majorizer's Hessian written out: B = (p/L²) [r^(p−2) I + ((p−2) r^(p−2) + 2p r^(−p−2)) u uᵀ].
            const Eigen::Matrix3d B =
                p / (L * L) *
                (std::pow(r, p - 2) * Eigen::Matrix3d::Identity() +
                 ((p - 2) * std::pow(r, p - 2) + 2 * p * std::pow(r, -p - 2)) * u * u.transpose());
            hessian.block<3, 3>(a, a) += B;
            hessian.block<3, 3>(b, b) += B;
            hessian.block<3, 3>(a, b) -= B;
            hessian.block<3, 3>(b, a) -= B;
        }
    }
    double value = 0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
};

/// A patch pulled at one corner while three vertices are held.
Editor li2022_editor(Net net) {
    Editor editor(std::move(net));
    editor.set_method("li2022");
    return editor;
}

constexpr int k_spot = 15 * 30 + 15;

/// A net that is exact but for one spot, so that the third stage comes first.
Editor spoilt_patch() {
    Editor editor = li2022_editor(samples::patch(30, 30));
    Positions x = editor.net().rest_positions();
    x(2, k_spot) += 0.05;
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 29, 870, 899}));
    editor.set_option("adaptive_p", "off");
    editor.set_option("reduction_deviation", "1");
    editor.set_positions(x);
    return editor;
}

Editor lifted_patch(double distance = 1.5) {
    Editor editor = li2022_editor(samples::patch(9, 8));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 8, 63, 71});
    handles.back().target += Eigen::Vector3d(-0.5, -0.3, 1).normalized() * distance;
    editor.set_handles(handles);
    return editor;
}

}  // namespace

TEST_CASE("Eliminating the handles gives the step of the KKT system (5)") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const double p = GENERATE(2.0, 6.0);
    const Net net = GENERATE(0, 1) == 0 ? samples::patch(5, 4) : samples::mixed_mesh();
    const Topology topology(net);
    const std::vector<int> handles{0, 4};  // not joined, so that all energy is that of edges that can change
    Positions x = samples::shaken(net.rest_positions(), 0.02, random);
    const Positions before = x;

    // [H Cᵀ; C 0] [dx; λ] = [−∇E; 0], one row of C for each coordinate of a handle.
    const WholeNet whole(net, before, p);
    const Eigen::Index n = before.size(), c = 3 * static_cast<Eigen::Index>(handles.size());
    Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + c, n + c);
    kkt.topLeftCorner(n, n) = whole.hessian;
    for (std::size_t h = 0; h < handles.size(); ++h)
        for (int k = 0; k < 3; ++k) {
            const Eigen::Index row = n + 3 * static_cast<Eigen::Index>(h) + k, column = 3 * handles[h] + k;
            kkt(row, column) = kkt(column, row) = 1;
        }
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n + c);
    rhs.head(n) = -whole.gradient;
    const Eigen::VectorXd step = kkt.fullPivLu().solve(rhs).head(n);

    const auto method = k_li2022.make();
    const Problem problem{net, topology, handles};
    method->prepare(problem);
    Options options;
    options.p_start = p;
    options.switch_deviation = 0;  // stay in stage 1
    options.threshold = 1e-20;
    REQUIRE(method->start(problem, x, options) == Status::running);
    TraceRow row;
    method->iterate(x, row);
    REQUIRE(row.step == 1);
    const Eigen::VectorXd moved = (x - before).reshaped();
    CHECK((moved - step).norm() < 1e-9 * step.norm());

    Eigen::VectorXd free_gradient = whole.gradient;
    for (int h : handles) free_gradient.segment<3>(3 * h).setZero();
    CHECK(row.gradient_norm == Approx(free_gradient.norm() * net.mean_length()));
    CHECK(row.energy == Approx(WholeNet(net, x, p).value));
}

TEST_CASE("The gradient of the whole net agrees with finite differences") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::mixed_mesh();
    const Positions x = samples::shaken(net.rest_positions(), 0.05, random);
    const double p = GENERATE(2.0, 20.0), h = 1e-6;
    const WholeNet whole(net, x, p);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Positions up = x, down = x;
        up.reshaped()[i] += h;
        down.reshaped()[i] -= h;
        const double slope = (WholeNet(net, up, p).value - WholeNet(net, down, p).value) / (2 * h);
        CHECK(slope == Approx(whole.gradient[i]).margin(1e-6 * whole.gradient.norm()));
    }
}

TEST_CASE("A pull converges below 1e-6 with handles exact, in three stages that only go forward") {
    Editor editor = lifted_patch();
    const SolveReport report = editor.solve();
    REQUIRE(report.status == Status::converged);
    CHECK(report.max_deviation < 1e-6);
    CHECK(max_deviation(editor.net(), editor.positions()) == report.max_deviation);
    CHECK(editor.handle_error() == 0);
    REQUIRE(report.iterations == static_cast<int>(report.trace.size()));

    const Options options;
    double deviation_before = std::numeric_limits<double>::infinity();
    std::set<int> stages;
    for (const TraceRow& row : report.trace) {
        stages.insert(row.stage);
        CHECK(row.p == (row.stage == 1 ? options.p_start : options.p_end));
        if (row.stage == 2) CHECK(deviation_before < options.switch_deviation);
        if (row.stage == 3) CHECK(deviation_before < options.reduction_deviation);
        if (row.stage != 3) CHECK(row.free_vertices == editor.net().vertex_count() - 4);
        deviation_before = row.max_deviation;
    }
    CHECK(stages.count(1) == 1);
    CHECK(stages.count(2) == 1);
}

TEST_CASE("Within one exponent the energy never rises") {
    Editor editor = lifted_patch(GENERATE(0.3, 1.0, 2.0));
    const Trace trace = editor.solve().trace;
    for (std::size_t k = 1; k < trace.size(); ++k)
        if (trace[k].p == trace[k - 1].p) CHECK(trace[k].energy <= trace[k - 1].energy);
}

TEST_CASE("Each strategy can be switched off") {
    Editor editor = lifted_patch();
    editor.set_option("adaptive_reduction", "off");
    for (const TraceRow& row : editor.solve().trace) CHECK(row.stage < 3);

    Editor fixed_p = lifted_patch(0.3);
    fixed_p.set_option("adaptive_p", "off");
    fixed_p.set_option("p_end", "8");
    const SolveReport report = fixed_p.solve();
    CHECK(report.status == Status::converged);
    for (const TraceRow& row : report.trace) CHECK(row.p == 8);
}

TEST_CASE("Reduced iterations move only vertices within two rings of an edge with dL > ε4") {
    Editor editor = spoilt_patch();
    const Positions x = editor.positions();
    const SolveReport report = editor.solve({1});
    REQUIRE(report.trace.size() == 1);
    CHECK(report.trace[0].stage == 3);
    // Ends of the four bad edges (5 vertices) and two rings: all within three steps of the spot.
    CHECK(report.trace[0].free_vertices == 25);
    const std::vector<double> distance = editor.topology().distances_from(k_spot);
    for (int v = 0; v < editor.net().vertex_count(); ++v)
        if (distance[v] > 3.5) CHECK(editor.positions().col(v) == x.col(v));
    CHECK(report.max_deviation < max_deviation(editor.net(), x));
}

TEST_CASE("Reduced once, as section 3.3 has it, the same vertices move to the end, else they are chosen anew") {
    for (const bool once : {true, false}) {
        Editor editor = spoilt_patch();
        editor.set_option("reduce_once", once ? "on" : "off");
        editor.set_option("threshold", "1e-12");
        const Positions before = editor.positions();
        std::set<int> sizes;
        const SolveReport report = editor.solve();
        for (const TraceRow& row : report.trace)
            if (row.stage == 3) sizes.insert(row.free_vertices);
        CAPTURE(once);
        REQUIRE(report.trace.size() > 2);
        CHECK((sizes.size() == 1) == once);
        const auto moved = ((editor.positions() - before).array() != 0).colwise().any().count();
        if (once) CHECK(moved <= *sizes.begin());
    }
}

TEST_CASE("Reduced once, vertices that cannot mend the net end the solve, else all are freed again") {
    for (const bool once : {true, false}) {
        Editor editor = li2022_editor(samples::patch(30, 30));
        // All edges between two columns are too long; their ends alone cannot make room for that.
        Positions x = editor.net().rest_positions();
        for (int v = 0; v < editor.net().vertex_count(); ++v) x(0, v) += v % 30 >= 15 ? 0.1 : 0;
        editor.set_handles({{0, x.col(0)}, {29, x.col(29)}, {870, x.col(870)}, {899, x.col(899)}});
        editor.set_option("adaptive_p", "off");
        editor.set_option("reduction_deviation", "1");
        editor.set_option("active_rings", "0");
        editor.set_option("reduce_once", once ? "on" : "off");
        editor.set_positions(x);
        const SolveReport report = editor.solve();
        std::set<int> stages;
        for (const TraceRow& row : report.trace) stages.insert(row.stage);
        CAPTURE(once);
        CHECK(report.status == (once ? Status::stalled : Status::converged));
        CHECK(stages == (once ? std::set<int>{3} : std::set<int>{2, 3}));
    }
}

TEST_CASE("The three stopping rules end a solve each") {
    Editor threshold = lifted_patch();
    threshold.set_option("threshold", "1e-3");
    CHECK(threshold.solve().status == Status::converged);
    CHECK(max_deviation(threshold.net(), threshold.positions()) < 1e-3);

    // Loose rules 1 and 2 stop at a false minimum, first in stage 1 and then for good.
    Editor energy = lifted_patch();
    energy.set_option("energy_tolerance", "1");
    CHECK(energy.solve().status == Status::stalled);
    Editor gradient = lifted_patch();
    gradient.set_option("gradient_tolerance", "1e6");
    CHECK(gradient.solve().status == Status::stalled);
    CHECK(gradient.positions().allFinite());

    Editor limit = lifted_patch();
    limit.set_option("max_iterations", "2");
    const SolveReport report = limit.solve();
    CHECK(report.status == Status::max_iterations);
    CHECK(report.iterations == 2);
}

TEST_CASE("The result turns, moves and scales with the net") {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    const Eigen::Vector3d shift(3, -4, 5);
    const double scale = GENERATE(1.0, 1e-3, 1e4);
    const auto carry = [&](const Positions& x) -> Positions { return (scale * turn * x).colwise() + shift; };

    Editor plain = lifted_patch();
    Editor carried = li2022_editor(Net(carry(plain.net().rest_positions()), plain.net().faces()));
    std::vector<Handle> handles = plain.handles();
    for (Handle& handle : handles) handle.target = carry(handle.target);
    carried.set_handles(handles);

    const SolveReport report = plain.solve();
    CHECK(carried.solve().iterations == report.iterations);
    CHECK(samples::largest_move(carried.positions(), carry(plain.positions())) < 1e-8 * scale);
}

TEST_CASE("A general mesh keeps each edge's own length") {
    Editor editor = li2022_editor(samples::mixed_mesh());
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 4});
    handles[1].target += Eigen::Vector3d(-0.4, 0.2, 0.3);
    editor.set_handles(handles);
    REQUIRE(editor.solve().status == Status::converged);
    CHECK((edge_ratios(editor.net(), editor.positions()).array() - 1).abs().maxCoeff() < 1.1e-3);
}

TEST_CASE("A handle that jumps onto its neighbour does not break the solve") {
    Editor editor = li2022_editor(samples::patch(8, 8));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 27});
    handles[1].target = editor.net().rest_positions().col(28);
    editor.set_handles(handles);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(editor.handle_error() == 0);
}

TEST_CASE("A net whose every vertex is a handle, and one without handles, end at once") {
    Editor all = li2022_editor(samples::cube());
    all.set_handles(samples::handles_at_rest(all.net(), {0, 1, 2, 3, 4, 5, 6, 7}));
    CHECK(all.solve().status == Status::converged);
    std::vector<Handle> handles = all.handles();
    handles[0].target *= 0.5;
    handles[0].target[0] -= 0.3;
    all.set_handles(handles);
    CHECK(all.solve().status == Status::unreachable);

    Editor none = li2022_editor(samples::cube());
    const SolveReport report = none.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.iterations == 0);
}
