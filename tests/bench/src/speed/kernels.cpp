#include "kernels.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#ifdef CHEBNET_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif
#include <memory>
#include <type_traits>
#include <utility>

#include "linear/graph_system.h"
#include "net/topology.h"
#include "solve/parts/free_part.h"

namespace chebnet::bench {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// A matrix as GraphSystem takes it: a block at each node, and [[B, −B], [−B, B]] at each link.
template <int size>
struct Terms {
    using Block = Eigen::Matrix<double, size, size>;
    Eigen::Matrix2Xi links;
    std::vector<Block> at_node, at_link;
};

template <int size>
Terms<size> no_terms(int nodes, const Eigen::Matrix2Xi& links) {
    using Block = typename Terms<size>::Block;
    return {links, std::vector<Block>(static_cast<std::size_t>(nodes), Block::Zero()),
            std::vector<Block>(static_cast<std::size_t>(links.cols()), Block::Zero())};
}

/// The sum of a block for each edge over the free vertices; `block_of` takes the edge.
template <int size, typename BlockOf>
Terms<size> sum_over_edges(const FreePart& part, BlockOf block_of) {
    Terms<size> terms = no_terms<size>(part.size(), part.links());
    for (const FreePart::Edge& edge : part.edges()) {
        const auto block = block_of(edge.index);
        if (edge.link >= 0)
            terms.at_link[edge.link] += block;
        else
            terms.at_node[edge.node_a >= 0 ? edge.node_a : edge.node_b] += block;
    }
    for (const int node : part.floating_nodes()) terms.at_node[node] += Terms<size>::Block::Identity();
    return terms;
}

Eigen::Vector3d direction(const Net& net, int edge) {
    return (net.rest_positions().col(net.edges()(0, edge)) - net.rest_positions().col(net.edges()(1, edge)))
        .normalized();
}

/// Of the energy with p = 2 at rest, but for a factor (Li et al. 2022, section 3.2.1).
Terms<3> block_terms(const Net& net, const FreePart& part) {
    return sum_over_edges<3>(part, [&](int edge) -> Eigen::Matrix3d {
        const Eigen::Vector3d u = direction(net, edge);
        return Eigen::Matrix3d::Identity() + 4 * u * u.transpose();
    });
}

Terms<1> laplacian_terms(const FreePart& part) {
    return sum_over_edges<1>(part, [](int) { return Eigen::Matrix<double, 1, 1>(1.0); });
}

/// J W Jᵀ of the constraints "edge e has its length", in units of the length: see LengthProjection. A little is added
/// to the diagonal, as there, where constraints depend on each other.
Terms<1> length_terms(const Net& net, const std::vector<bool>& is_free) {
    constexpr double shift = 1e-6;
    const Topology topology(net);
    std::vector<std::pair<int, int>> couplings;
    std::vector<double> values;
    for (int v = 0; v < net.vertex_count(); ++v)
        for (const int a : topology.incident_edges(v))
            for (const int b : topology.incident_edges(v)) {
                if (a >= b) continue;
                const double sign = (net.edges()(0, a) == v) == (net.edges()(0, b) == v) ? 1 : -1;
                couplings.emplace_back(a, b);
                values.push_back(is_free[v] ? sign * direction(net, a).dot(direction(net, b)) : 0);
            }
    Eigen::Matrix2Xi links(2, static_cast<Eigen::Index>(couplings.size()));
    for (Eigen::Index k = 0; k < links.cols(); ++k) links.col(k) << couplings[k].first, couplings[k].second;

    Terms<1> terms = no_terms<1>(net.edge_count(), links);
    for (int e = 0; e < net.edge_count(); ++e) {
        const int weight = is_free[net.edges()(0, e)] + is_free[net.edges()(1, e)];
        terms.at_node[e][0] = weight > 0 ? (1 + shift) * weight : 1;
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        terms.at_link[k][0] = -values[k];  // which adds as much to two diagonal entries: taken away again
        terms.at_node[couplings[k].first][0] += values[k];
        terms.at_node[couplings[k].second][0] += values[k];
    }
    return terms;
}

/// All of the matrix, for multiplying.
template <int size>
Sparse sparse_matrix(const Terms<size>& terms) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int column, const auto& block) {
        for (int r = 0; r < size; ++r)
            for (int c = 0; c < size; ++c) entries.emplace_back(size * row + r, size * column + c, block(r, c));
    };
    for (std::size_t i = 0; i < terms.at_node.size(); ++i)
        add(static_cast<int>(i), static_cast<int>(i), terms.at_node[i]);
    for (std::size_t k = 0; k < terms.at_link.size(); ++k) {
        const int a = terms.links(0, static_cast<Eigen::Index>(k)), b = terms.links(1, static_cast<Eigen::Index>(k));
        const auto& block = terms.at_link[k];
        add(a, a, block);
        add(b, b, block);
        add(a, b, -block);
        add(b, a, -block);
    }
    const auto rows = size * static_cast<Eigen::Index>(terms.at_node.size());
    Sparse matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

// A right-hand side is 3×nodes: one vector for blocks of three, three vectors for a scalar matrix.

template <int size>
double residual(const Sparse& matrix, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& rhs) {
    if constexpr (size == 3)
        return (matrix * x.reshaped() - rhs.reshaped()).norm() / rhs.norm();
    else
        return (matrix * x.transpose() - rhs.transpose()).norm() / rhs.norm();
}

template <int size, typename Solver>
Eigen::Matrix3Xd solve(const Solver& solver, const Eigen::Matrix3Xd& rhs) {
    if constexpr (size == 3)
        return solver.solve(Eigen::VectorXd(rhs.reshaped())).reshaped(3, rhs.cols());
    else
        return solver.solve(Eigen::MatrixXd(rhs.transpose())).transpose();
}

template <int size>
Kernel chebnet_kernel(const std::string& system, const Terms<size>& terms, const Sparse& matrix,
                      const Eigen::Matrix3Xd& rhs) {
    const auto solver = std::make_shared<std::conditional_t<size == 3, BlockSystem, LaplacianSystem>>(
        static_cast<int>(terms.at_node.size()), terms.links);
    for (std::size_t i = 0; i < terms.at_node.size(); ++i) solver->add_at_node(static_cast<int>(i), terms.at_node[i]);
    for (std::size_t k = 0; k < terms.at_link.size(); ++k) solver->add_at_link(static_cast<int>(k), terms.at_link[k]);
    const bool ok = solver->factorize();
    const double error = ok ? residual<size>(matrix, solver->solve(rhs), rhs) : 1;
    return {system, "chebnet", static_cast<int>(matrix.rows()), error, [solver] { solver->factorize(); }};
}

template <int size, typename Solver>
Kernel other_kernel(const std::string& system, const std::string& name, const Sparse& matrix,
                    const Eigen::Matrix3Xd& rhs) {
    const auto solver = std::make_shared<Solver>();
    const auto lower = std::make_shared<Sparse>(matrix.template triangularView<Eigen::Lower>());
    solver->analyzePattern(*lower);
    solver->factorize(*lower);
    const bool ok = solver->info() == Eigen::Success;
    const double error = ok ? residual<size>(matrix, solve<size>(*solver, rhs), rhs) : 1;
    return {system, name, static_cast<int>(matrix.rows()), error, [solver, lower] { solver->factorize(*lower); }};
}

template <int size>
void add_kernels(const std::string& system, const Terms<size>& terms, std::vector<Kernel>& kernels) {
    const Sparse matrix = sparse_matrix(terms);
    const Eigen::Matrix3Xd rhs = Eigen::Matrix3Xd::Ones(3, static_cast<Eigen::Index>(terms.at_node.size()));
    kernels.push_back(chebnet_kernel(system, terms, matrix, rhs));
    using EigenSolver = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>>;
    kernels.push_back(other_kernel<size, EigenSolver>(system, "eigen", matrix, rhs));
#ifdef CHEBNET_HAS_CHOLMOD
    using CholmodSolver = Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower>;
    kernels.push_back(other_kernel<size, CholmodSolver>(system, "cholmod", matrix, rhs));
#endif
}

}  // namespace

std::vector<Kernel> make_kernels(const Net& net, std::span<const int> handle_vertices) {
    const std::vector<bool> is_free = free_vertices(net.vertex_count(), handle_vertices);
    const FreePart part(net, is_free);
    std::vector<Kernel> kernels;
    add_kernels("block", block_terms(net, part), kernels);
    add_kernels("lengths", length_terms(net, is_free), kernels);
    add_kernels("laplacian", laplacian_terms(part), kernels);
    return kernels;
}

}  // namespace chebnet::bench
