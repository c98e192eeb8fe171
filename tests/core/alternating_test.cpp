#include "solve/parts/alternating.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "net/measures.h"
#include "net/mesh.h"
#include "sample_nets.h"
#include "solve/parts/arap_step.h"
#include "solve/parts/local_global_step.h"
#include "solve/parts/nearest_rotation.h"

using namespace chebnet;

namespace {

Eigen::Quaterniond random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
}

Eigen::Matrix3d random_matrix(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    return Eigen::Matrix3d::NullaryExpr([&] { return unit(random); });
}

/// The largest tr(RᵀA) over all rotations: the sum of singular values, the smallest with the sign of det A.
double best_alignment(const Eigen::Matrix3d& A) {
    const Eigen::Vector3d s = A.jacobiSvd().singularValues();
    return s[0] + s[1] + (A.determinant() < 0 ? -s[2] : s[2]);
}

double alignment(const Eigen::Matrix3d& A, const Eigen::Quaterniond& q) {
    return (q.toRotationMatrix().transpose() * A).trace();
}

/// A patch whose last corner is pulled away while three others are held.
Editor pulled_patch(std::string_view method) {
    Editor editor(samples::patch(9, 8));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 8, 63, 71});
    handles.back().target += Eigen::Vector3d(-0.7, -0.5, 1.2);
    editor.set_handles(handles);
    editor.set_method(method);
    return editor;
}

}  // namespace

TEST_CASE("The nearest rotation is the best there is, whatever the guess") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int k = 0; k < 300; ++k) {
        const Eigen::Matrix3d A = random_matrix(random);  // half of them reflect
        const Eigen::Quaterniond q = nearest_rotation(A, random_rotation(random));
        CHECK(q.norm() == Approx(1).epsilon(1e-14));
        CHECK(alignment(A, q) == Approx(best_alignment(A)).epsilon(1e-12).margin(1e-12));
    }
}

TEST_CASE("Degenerate matrices have a nearest rotation too") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Eigen::Vector3d a = random_matrix(random).col(0), b = random_matrix(random).col(0);
    const Eigen::Quaterniond turn = random_rotation(random);
    const Eigen::Matrix3d R = turn.toRotationMatrix();
    const auto check = [&](const Eigen::Matrix3d& A) {
        const Eigen::Quaterniond q = nearest_rotation(A, Eigen::Quaterniond::Identity());
        CHECK(alignment(A, q) == Approx(best_alignment(A)).epsilon(1e-10).margin(1e-10));
    };
    check(Eigen::Matrix3d::Zero());
    check(a * b.transpose());                                             // one direction
    check(R * Eigen::Vector3d(2, 1, 0).asDiagonal() * R.transpose());     // flat
    check(R * Eigen::Vector3d(-1, -1, 1).asDiagonal() * R.transpose());   // half a turn from the guess
    check(R * Eigen::Vector3d(-1, -1, 0).asDiagonal() * R.transpose());   // likewise, flat
    check(R * Eigen::Vector3d(1, 1, -1).asDiagonal() * R.transpose());    // a mirror
    check(R * Eigen::Vector3d(-1, -1, -1).asDiagonal() * R.transpose());  // a point reflection
}

TEST_CASE("One ARAP step is that of Sorkine and Alexa, by SVD and a dense system") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = GENERATE(0, 1) == 0 ? samples::patch(5, 4) : samples::mixed_mesh();
    const Topology topology(net);
    const std::vector<int> handles{0, 4};
    const Positions& p = net.rest_positions();
    const Positions x = samples::shaken(p, 0.3, random);

    std::vector<Eigen::Matrix3d> R;
    for (int v = 0; v < net.vertex_count(); ++v) {
        Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
        for (int n : topology.neighbours(v)) S += (x.col(v) - x.col(n)) * (p.col(v) - p.col(n)).transpose();
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(S, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Eigen::Matrix3d U = svd.matrixU();
        if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) *= -1;
        R.push_back(U * svd.matrixV().transpose());
    }
    // Eq. 9 of the paper for free vertices, x_h = target for handles.
    const int n = net.vertex_count();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n, n), rhs = Eigen::MatrixXd::Zero(n, 3);
    for (int v = 0; v < n; ++v) {
        if (std::find(handles.begin(), handles.end(), v) != handles.end()) {
            system(v, v) = 1;
            rhs.row(v) = x.col(v).transpose();
            continue;
        }
        for (int m : topology.neighbours(v)) {
            system(v, v) += 1;
            system(v, m) -= 1;
            rhs.row(v) += ((R[v] + R[m]) * (p.col(v) - p.col(m)) / 2).transpose();
        }
    }
    const Positions expected = system.fullPivLu().solve(rhs).transpose();

    LaplacianPart part(net, free_vertices(n, handles));
    ArapStep step(part);
    Positions moved = x;
    step.iterate(moved);
    CHECK((moved - expected).norm() < 1e-7 * x.norm());  // the SVD has no inertia
    for (int h : handles) CHECK(moved.col(h) == x.col(h));
}

TEST_CASE("ARAP reproduces a rigid motion of its handles") {
    Editor editor(samples::patch(7, 6));
    editor.set_method("arap");
    for (const auto& [key, value] : {std::pair{"threshold", "1e-24"}, {"energy_tolerance", "0"}})
        editor.set_option(key, value);
    editor.set_option("gradient_tolerance", "0");
    editor.set_option("max_iterations", "100000");
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    const Positions carried = (turn * editor.net().rest_positions()).colwise() + Eigen::Vector3d(3, -2, 5);
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 6, 20, 35, 41});
    for (Handle& handle : handles) handle.target = carried.col(handle.vertex);
    editor.set_handles(handles);
    const SolveReport report = editor.solve();
    CHECK(report.trace.back().energy < 1e-20);
    CHECK((editor.positions() - carried).cwiseAbs().maxCoeff() < 1e-10);
}

TEST_CASE("Alternating methods never raise their energy, and report its value and gradient") {
    const std::string method = GENERATE("arap", "local_global");
    Editor editor = pulled_patch(method);
    const Net& net = editor.net();
    LaplacianPart part(net, free_vertices(net.vertex_count(), std::vector<int>{0, 8, 63, 71}));
    std::unique_ptr<AlternatingStep> step;
    if (method == "arap")
        step = std::make_unique<ArapStep>(part);
    else
        step = std::make_unique<LocalGlobalStep>(part);
    const auto energy_at = [&](const Positions& x) {
        step->project(x);
        return step->energy(x);
    };

    double before = energy_at(editor.positions());
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Positions x = editor.positions();
        const SolveReport report = editor.solve({1});
        const TraceRow& row = report.trace.back();
        CHECK(row.energy <= before);
        CHECK(row.energy == Approx(energy_at(editor.positions())).epsilon(1e-9));
        before = row.energy;

        if (iteration % 10 != 0) continue;
        double squared_norm = 0;
        for (int v : part.part().vertices())
            for (int k = 0; k < 3; ++k) {
                Positions up = x, down = x;
                up(k, v) += 1e-6;
                down(k, v) -= 1e-6;
                const double slope = (energy_at(up) - energy_at(down)) / 2e-6;
                squared_norm += slope * slope;
            }
        CHECK(row.gradient_norm == Approx(std::sqrt(squared_norm)).epsilon(1e-4));
    }
}

TEST_CASE("The energy of local-global is the sum of squared differences of length, each edge against its own") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::mixed_mesh();
    const Positions x = samples::shaken(net.rest_positions(), 0.3, random);
    LaplacianPart part(net, free_vertices(net.vertex_count(), std::vector<int>{0}));
    LocalGlobalStep step(part);
    const Eigen::VectorXd off = (edge_ratios(net, x).array() - 1) * net.rest_lengths().array();
    CHECK(step.energy(x) == Approx(off.squaredNorm()));
}

TEST_CASE("Local-global brings edges to their length and says so") {
    Editor editor = pulled_patch("local_global");
    editor.set_option("max_iterations", "100000");
    editor.set_option("energy_tolerance", "0");
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-6);
    CHECK(editor.handle_error() == 0);
}

TEST_CASE("An exact edge is not collapsed, however long others are beside it") {
    const double wide = 1e60, thin = 1e-140;
    Mesh mesh{Positions(3, 4), {}};
    mesh.positions << 0, wide, wide, 0, 0, 0, thin, thin, 0, 0, 0, 0;
    mesh.faces.add({0, 1, 2, 3});
    const Net net(mesh.positions, mesh.faces, RestLengths::own);
    for (const char* method : {"local_global", "projection", "li2022"}) {
        INFO(method);
        Editor editor(net);
        editor.set_method(method);
        CHECK(editor.solve().status == Status::converged);
        CHECK(editor.positions() == net.rest_positions());
    }
}

TEST_CASE("A piece without a handle is held by nothing and still has a solution") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::patch(4, 4);
    LaplacianPart part(net, free_vertices(net.vertex_count(), {}));
    REQUIRE(part.part().floating_nodes().size() == 1);
    LocalGlobalStep step(part);
    Positions x = samples::shaken(net.rest_positions(), 0.2, random);
    const int held = part.part().vertices()[part.part().floating_nodes()[0]];
    const Eigen::Vector3d before = x.col(held);
    double energy = step.energy(x);
    for (int k = 0; k < 50; ++k) {
        step.iterate(x);
        CHECK(step.energy(x) <= energy);
        energy = step.energy(x);
    }
    CHECK((x.col(held) - before).norm() < 1e-6);
    CHECK(energy < 1e-3);
}

TEST_CASE("A collapsed edge takes the direction it has at rest") {
    const Net net = samples::patch(4, 4);
    LaplacianPart part(net, free_vertices(net.vertex_count(), std::vector<int>{0}));
    Positions x = net.rest_positions().col(0).replicate(1, net.vertex_count());
    LocalGlobalStep(part).iterate(x);
    CHECK((x - net.rest_positions()).norm() < 1e-4);
    x = net.rest_positions().col(0).replicate(1, net.vertex_count());
    ArapStep(part).iterate(x);
    CHECK((x - net.rest_positions()).norm() < 1e-4);
}
