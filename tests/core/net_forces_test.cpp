#include "edit/net_forces.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "first_order.h"
#include "sample_nets.h"

using namespace chebnet;

namespace {

/// An arched patch held at its corners, the last of which moves; heavy, if there is gravity.
Editor patch_at_rest(const Eigen::Vector3d& move, double gravity = 0) {
    const Net net = samples::patch(9, 9, 0.4);
    Editor editor(net);
    editor.set_method("equilibrium");
    editor.set_option("gravity", std::to_string(gravity));
    editor.set_option("rest_tolerance", "1e-7");
    std::vector<Handle> handles = samples::handles_at_rest(net, {0, 8, 72, 80});
    handles.back().target += move;
    editor.set_handles(handles);
    return editor;
}

/// 3×V, what is left of force at each vertex, by the terms and by what the report says holds them.
Eigen::Matrix3Xd unbalanced(const Editor& editor, const NetForces& forces) {
    const Net& net = editor.net();
    const Positions& x = editor.positions();
    Eigen::Matrix3Xd sum = -net.mean_length() * samples::gradient_of({net, {}, editor.options()}, x);
    const auto pull_together = [&](int a, int b, double force) {
        const Eigen::Vector3d pull = force * (x.col(b) - x.col(a)).normalized();
        sum.col(a) += pull;
        sum.col(b) -= pull;
    };
    for (int e = 0; e < net.edge_count(); ++e) pull_together(net.edges()(0, e), net.edges()(1, e), forces.edges[e]);
    for (const auto& [a, b, push] : forces.corners) pull_together(a, b, -push);
    for (std::size_t i = 0; i < editor.handles().size(); ++i)
        sum.col(editor.handles()[i].vertex) += forces.handles.col(static_cast<Eigen::Index>(i));
    return sum;
}

}  // namespace

TEST_CASE("Forces of edges, corners and handles keep every vertex in balance") {
    Editor editor = patch_at_rest({0, 0, 0}, 0.01);
    editor.set_option("shear_limit", "55");
    // By two opposite corners, which shears it.
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 80, 40});
    handles[0].target += Eigen::Vector3d(-0.9, -0.9, 0);
    handles[1].target += Eigen::Vector3d(0.9, 0.9, 0);
    editor.set_handles(handles);
    REQUIRE(editor.solve().status == Status::converged);
    const NetForces forces = net_forces(editor).value();
    CHECK_FALSE(forces.corners.empty());
    CHECK(forces.handles.norm() > 0.1);
    CHECK(unbalanced(editor, forces).norm() < 1e-6);
    for (const CornerForce& corner : forces.corners) CHECK(corner.push > 0);
}

TEST_CASE("Supports bear the weight of the net, whatever its unit") {
    for (const double unit : {1.0, 37.0}) {
        const Net net = samples::patch(9, 8, 0.4);
        Editor editor(Net(unit * net.rest_positions(), net.faces()));
        editor.set_method("equilibrium");
        editor.set_option("gravity", "0.02");
        editor.set_handles(samples::handles_at_rest(editor.net(), {0, 8, 63, 71, 31}));
        REQUIRE(editor.solve().status == Status::converged);
        const Eigen::Vector3d sum = net_forces(editor).value().handles.rowwise().sum();
        CHECK((sum - Eigen::Vector3d(0, 0, 0.02 * net.edge_count())).norm() < 1e-3);
    }
}

TEST_CASE("Supports bear the weight of a net whose edges differ, each by its length") {
    std::mt19937 random(3);
    const Net even = samples::patch(7, 6, 0.4);
    const Net net(samples::shaken(even.rest_positions(), 0.1, random), even.faces(), RestLengths::own);
    Editor editor(net);
    editor.set_method("equilibrium");
    editor.set_option("gravity", "0.02");
    editor.set_handles(samples::handles_at_rest(net, {0, 6, 35, 41}));
    REQUIRE(editor.solve().status == Status::converged);
    const NetForces forces = net_forces(editor).value();
    CHECK(forces.handles.row(2).sum() == Approx(0.02 * net.rest_lengths().sum() / net.mean_length()).epsilon(1e-3));
    CHECK(unbalanced(editor, forces).norm() < 1e-3);
}

TEST_CASE("A soft handle's force is its weight times its distance from the target") {
    Editor editor = patch_at_rest({0, 0, 1.2});
    std::vector<Handle> handles = editor.handles();
    handles.back().weight = 0.7;
    editor.set_handles(handles);
    REQUIRE(editor.solve().status == Status::converged);
    const NetForces forces = net_forces(editor).value();
    // Of E = w ‖x − c‖² / L², times L.
    const Eigen::Vector3d off = handles.back().target - editor.positions().col(80);
    CHECK(off.norm() > 0.01);
    CHECK((forces.handles.col(3) - 2 * 0.7 * off / editor.net().mean_length()).norm() < 1e-6);
    CHECK(forces.handles.rowwise().sum().norm() < 1e-6);
}

TEST_CASE("The energies of the terms add up to that of the net") {
    Editor editor = patch_at_rest({-0.5, -0.5, 0.5}, 0.01);
    const SolveReport report = editor.solve();
    double sum = 0;
    std::string names;
    const NetForces forces = net_forces(editor).value();
    for (const auto& [name, energy] : forces.energies) {
        sum += energy;
        names += std::string(name) + ' ';
    }
    CHECK(names == "bending shear gravity ");
    CHECK(sum == Approx(report.trace.back().energy));
    const Net& net = editor.net();
    Eigen::Matrix3Xd ignored = Eigen::Matrix3Xd::Zero(3, net.vertex_count());
    CHECK(forces.energies[0].energy ==
          Approx(BendingTerm(net, editor.topology(), net.rest_positions(), 1, BendingTerm::Reference::rest)
                     .evaluate(editor.positions(), ignored)));
}

TEST_CASE("Every frame says what is left to do, and of the motion left about as much as there is") {
    Editor editor = patch_at_rest({-1, -1, 0.5});
    editor.solve();
    // Cloth, which is long on its way to rest.
    for (const auto& [key, value] :
         {std::pair{"straight_rods", "on"}, {"bending_weight", "0.01"}, {"shear_weight", "0.01"}, {"gravity", "0.01"}})
        editor.set_option(key, value);
    std::vector<Positions> steps;
    std::vector<ToRest> left;
    SolveReport report;
    do {
        report = editor.solve({.iterations = 1});
        if (!report.to_rest) continue;
        steps.push_back(editor.positions());
        left.push_back(*report.to_rest);
    } while (report.status == Status::running);
    REQUIRE(report.status == Status::converged);
    CHECK(left.back().gradient_norm < editor.options().rest_tolerance);
    CHECK(left.back().corner_lack < 1e-3);
    CHECK(left.back().motion < 1e-3);
    int known = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double motion = (steps.back() - steps[i]).colwise().norm().maxCoeff() / editor.net().mean_length();
        CAPTURE(i, left[i].gradient_norm, left[i].motion, motion);
        CHECK(left[i].gradient_norm >= 0);
        if (!std::isfinite(left[i].motion) || motion < 1e-4) continue;
        ++known;
        CHECK(left[i].motion < 10 * motion);
        CHECK(motion < 10 * left[i].motion);
    }
    CHECK(known > 2);
}

TEST_CASE("A method that does not bring nets to rest knows no forces") {
    Editor editor = patch_at_rest({-0.5, -0.5, 0.5});
    editor.set_method("projection");
    CHECK_FALSE(editor.solve().to_rest.has_value());
    CHECK_FALSE(net_forces(editor).has_value());
    CHECK(editor.edge_forces() == Eigen::VectorXd::Zero(editor.net().edge_count()));
}

TEST_CASE("The table of edges has their forces if they are known") {
    Editor editor = patch_at_rest({-0.5, -0.5, 0.5});
    const auto header = [&] { return edge_table(editor).substr(0, edge_table(editor).find('\n')); };
    CHECK(header() == "edge,vertex_a,vertex_b,length,rest_length,deviation");
    editor.solve();
    CHECK(header() == "edge,vertex_a,vertex_b,length,rest_length,deviation,force");
    const std::string table = edge_table(editor);
    const std::string last = table.substr(table.rfind(',') + 1);
    CHECK(std::stod(last) == net_forces(editor).value().edges[editor.net().edge_count() - 1]);
}
