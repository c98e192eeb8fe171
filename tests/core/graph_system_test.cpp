#include "linear/graph_system.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>
#include <tuple>
#include <type_traits>

#include "sample_nets.h"

using namespace chebnet;

TEMPLATE_TEST_CASE("A block system solves what its dense matrix says, time and again", "", BlockSystem,
                   SingleBlockSystem) {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto random_block = [&] {
        const Eigen::Matrix3d A = Eigen::Matrix3d::NullaryExpr([&] { return normal(random); });
        return Eigen::Matrix3d(A * A.transpose());
    };
    const Net net = samples::patch(6, 5);
    const Eigen::Matrix2Xi& links = net.edges();
    const int n = net.vertex_count();
    TestType system(n, links);
    // Cholesky's factor is backward stable: what it leaves is of the size of its digits (Higham 2002, theorem 10.4).
    const double digits = std::is_same_v<TestType, BlockSystem> ? 1e-13 : 1e-5;

    for (int round = 0; round < 3; ++round) {
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * n, 3 * n);
        system.set_zero();
        for (int k = 0; k < links.cols(); ++k) {
            const Eigen::Matrix3d B = random_block();
            system.add_at_link(k, B);
            const int a = 3 * links(0, k), b = 3 * links(1, k);
            dense.block<3, 3>(a, a) += B;
            dense.block<3, 3>(b, b) += B;
            dense.block<3, 3>(a, b) -= B;
            dense.block<3, 3>(b, a) -= B;
        }
        for (int node : {0, n / 2, n - 1}) {
            const Eigen::Matrix3d B = random_block() + Eigen::Matrix3d::Identity();
            system.add_at_node(node, B);
            dense.block<3, 3>(3 * node, 3 * node) += B;
        }
        REQUIRE(system.factorize());
        const Eigen::Matrix3Xd rhs = Eigen::Matrix3Xd::NullaryExpr(3, n, [&] { return normal(random); });
        const Eigen::Matrix3Xd x = system.solve(rhs);
        const Eigen::VectorXd residual = dense * x.reshaped() - rhs.reshaped();
        CHECK(residual.norm() < digits * dense.norm() * x.norm());
    }
}

TEMPLATE_TEST_CASE("Registers of any width give the same bits", "", float, double) {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::normal_distribution<TestType> normal;
    constexpr int width = 4, depth = 13, lanes = dense::k_lanes<TestType>;
    using Matrix = Eigen::Matrix<TestType, Eigen::Dynamic, Eigen::Dynamic>;
    for (int rows = dense::k_row_multiple; rows <= 60; rows += dense::k_row_multiple) {
        const auto entry = [&] { return normal(random); };
        const Matrix A = Matrix::NullaryExpr(rows, depth, entry), B = Matrix::NullaryExpr(width, depth, entry);
        const Matrix triangle = Matrix::NullaryExpr(width, width, entry), C = Matrix::NullaryExpr(rows, width, entry);
        Matrix narrow = C, wide = C, as_here = C;
        const auto ends = [&](Matrix& c) { return std::tuple(rows, c.data(), rows, A.data(), rows, B.data(), width); };
        const auto args = [&](Matrix& c) { return std::tuple_cat(ends(c), std::tuple(depth, triangle.data())); };
        std::apply([](auto... a) { dense::block_column_by<width, lanes>(a...); }, args(narrow));
        std::apply([](auto... a) { dense::block_column_by<width, 2 * lanes>(a...); }, args(wide));
        std::apply([](auto... a) { dense::block_column<width>(a...); }, args(as_here));
        CHECK(narrow == wide);
        CHECK(narrow == as_here);
        const Matrix product = C - A * B.transpose();
        const Matrix lower = triangle.template triangularView<Eigen::Lower>();
        CHECK((narrow * lower.transpose() - product).norm() < 1e-3 * (1 + product.norm() + narrow.norm()));
    }
}

/// The factor of r^|i − j| is known: r^(i − j), times √(1 − r²) but for the first column.
TEST_CASE("A factor in single precision has no entries so small that their products are no normal numbers") {
    constexpr int n = 64;
    constexpr double r = 0.05;
    std::vector<float> panel(n * n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) panel[j * n + i] = static_cast<float>(std::pow(r, std::abs(i - j)));
    REQUIRE(dense::factor_panel(panel.data(), n, n, n));
    int dropped = 0;
    for (int j = 0; j < n; ++j)
        for (int i = j; i < n; ++i) {
            const double entry = panel[j * n + i], known = std::pow(r, i - j) * (j > 0 ? std::sqrt(1 - r * r) : 1);
            INFO("row " << i << ", column " << j);
            CHECK(std::abs(entry - known) < 1e-6);
            CHECK((entry == 0 || std::abs(entry) > 1e-17));
            dropped += static_cast<int>(entry == 0);
        }
    CHECK(dropped > n);
}

TEST_CASE("A system that is not positive definite is refused") {
    BlockSystem system(3, (Eigen::Matrix2Xi(2, 2) << 0, 1, 1, 2).finished());
    system.add_at_link(0, Eigen::Matrix3d::Identity());
    system.add_at_link(1, -Eigen::Matrix3d::Identity());
    system.add_at_node(0, Eigen::Matrix3d::Identity());
    CHECK_FALSE(system.factorize());
    system.add_at_node(1, Eigen::Matrix3d::Constant(std::nan("")));
    CHECK_FALSE(system.factorize());
}

TEST_CASE("The order found is a permutation and makes less fill than the natural one") {
    const Net net = samples::patch(20, 20);
    const BlockSystem whole(net.vertex_count(), net.edges());
    std::vector<int> rank = whole.elimination_rank();
    std::vector<int> sorted = rank;
    std::sort(sorted.begin(), sorted.end());
    for (int i = 0; i < net.vertex_count(); ++i) REQUIRE(sorted[i] == i);

    const auto factored = [&](std::vector<int> order) {
        BlockSystem system(net.vertex_count(), net.edges(), std::move(order));
        for (int k = 0; k < net.edge_count(); ++k) system.add_at_link(k, Eigen::Matrix3d::Identity());
        system.add_at_node(0, Eigen::Matrix3d::Identity());
        REQUIRE(system.factorize());
        return system.factor_entries();
    };
    std::vector<int> natural(rank.size());
    for (std::size_t i = 0; i < natural.size(); ++i) natural[i] = static_cast<int>(i);
    CHECK(factored(rank) < factored(natural));
}

TEST_CASE("A Laplacian system solves three coordinates at once") {
    const Net net = samples::patch(5, 4);
    LaplacianSystem system(net.vertex_count(), net.edges());
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(20, 20);
    for (int k = 0; k < net.edge_count(); ++k) {
        const int a = net.edges()(0, k), b = net.edges()(1, k);
        const double w = 1 + 0.1 * k;
        system.add_at_link(k, LaplacianSystem::Block(w));
        dense(a, a) += w;
        dense(b, b) += w;
        dense(a, b) -= w;
        dense(b, a) -= w;
    }
    system.add_at_node(3, LaplacianSystem::Block(2.0));
    dense(3, 3) += 2;
    REQUIRE(system.factorize());
    const Eigen::Matrix3Xd rhs = net.rest_positions();
    Eigen::Matrix3Xd x = system.solve(rhs);
    CHECK((x * dense - rhs).norm() < 1e-4 * rhs.norm());
    // Single precision loses nothing where the residual is corrected.
    for (int step = 0; step < 4; ++step) x += system.solve(rhs - x * dense);
    CHECK((x * dense - rhs).norm() < 1e-13 * rhs.norm());
}
