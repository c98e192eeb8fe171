#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "constants.h"
#include "edit/edit_state.h"
#include "edit/locality.h"
#include "net/families.h"
#include "net/net.h"
#include "net/topology.h"
#include "solve/options.h"
#include "solve/terms/bending_term.h"
#include "solve/terms/closeness_term.h"
#include "solve/terms/load_terms.h"
#include "solve/terms/shear_term.h"
#include "solve/terms/tip_term.h"
#include "surface/guide.h"

namespace chebnet::samples {

/// What is to be at rest, and all that holds and draws it.
struct Resting {
    const Net& net;
    std::vector<Handle> handles;
    const Options& options;
    const Guide* guide = nullptr;
    const Region* region = nullptr;
    const Positions* shape = nullptr;  // that costs no energy; null: the net's rest positions
    std::vector<bool> weightless{};    // V, see GravityTerm
};

/// Of soft handles, and of the region's border where no exact handle is.
inline std::vector<Pull> pulls_of(const Resting& resting) {
    std::vector<Pull> pulls;
    std::vector<bool> is_exact(static_cast<std::size_t>(resting.net.vertex_count()), false);
    for (const Handle& handle : resting.handles) {
        is_exact[handle.vertex] = handle.is_exact();
        if (!handle.is_exact()) pulls.push_back({handle.vertex, handle.target, handle.weight});
    }
    if (resting.region != nullptr)
        for (const Pull& pull : resting.region->pulls)
            if (!is_exact[pull.vertex]) pulls.push_back(pull);
    return pulls;
}

/// ∇E by the terms, whose derivatives are tested for themselves; 0 where nothing may move.
inline Eigen::Matrix3Xd gradient_of(const Resting& resting, const Positions& x) {
    const auto& [net, handles, options, guide, region, shape, weightless] = resting;
    const Topology topology(net);
    const Positions& from = shape != nullptr ? *shape : net.rest_positions();
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x.cols());
    std::vector<double> stiffness;
    for (const int family : edge_families(net).value_or(std::vector<int>()))
        stiffness.push_back(family == 0 ? options.warp_stiffness : options.weft_stiffness);
    const auto reference = options.rod_curvature != 0 ? BendingTerm::Reference::curved
                           : options.straight_rods    ? BendingTerm::Reference::straight
                                                      : BendingTerm::Reference::rest;
    BendingTerm(net, topology, from, options.bending_weight, reference, stiffness, options.rod_curvature)
        .evaluate(x, gradient);
    ShearTerm(net, from, options.shear_weight,
              options.square_corners ? ShearTerm::Reference::right_angles : ShearTerm::Reference::rest,
              std::max(options.shear_limit, 15 * k_degree))
        .evaluate(x, gradient);
    TipTerm(net, topology, options.tip_weight).evaluate(x, gradient);
    GravityTerm(net, options.gravity, -Eigen::Vector3d::Unit(options.y_up ? 1 : 2), weightless).evaluate(x, gradient);
    const GuideMode mode = options.guide_mode;
    if (guide != nullptr && mode != GuideMode::off)
        ClosenessTerm(net, *guide, 1,
                      (mode == GuideMode::near ? 1 : 100) *
                          (mode == GuideMode::outside ? 1 : 50.0 / net.vertex_count()) * options.guide_weight,
                      mode == GuideMode::outside ? ClosenessTerm::Side::below : ClosenessTerm::Side::both)
            .evaluate(x, gradient);
    PullTerm(net, pulls_of(resting)).evaluate(x, gradient);
    return gradient;
}

/// 3 × V: the coordinates that nothing holds.
inline Eigen::Matrix3Xd free_coordinates(const Resting& resting) {
    Eigen::Matrix3Xd is_free = Eigen::Matrix3Xd::Ones(3, resting.net.vertex_count());
    for (const Handle& handle : resting.handles)
        for (int k = 0; k < 3; ++k)
            if (handle.is_exact() && !has_axis(handle.slides, k)) is_free(k, handle.vertex) = 0;
    if (resting.region != nullptr)
        for (int v : resting.region->outside) is_free.col(v).setZero();
    return is_free;
}

/// Two vertices whose distance is kept, or may not become less.
struct Pair {
    int a, b;
    bool is_diagonal;
};

/// The edges, then the diagonals of quads that stand at the limit.
inline std::vector<Pair> kept_pairs(const Net& net, const Positions& x, double limit) {
    std::vector<Pair> pairs;
    const Topology topology(net);
    for (int e = 0; e < net.edge_count(); ++e) pairs.push_back({net.edges()(0, e), net.edges()(1, e), false});
    for (int f = 0; limit > 0 && f < net.face_count(); ++f) {
        const std::span<const int> q = net.faces()[f];
        if (q.size() != 4) continue;
        const auto side = [&, q = q](int k) {
            return net.rest_lengths()[topology.edge_between(q[k % 4], q[(k + 1) % 4])];
        };
        const auto opposite = [&](double p, double r) {
            return std::hypot(p - r, 2 * std::sqrt(p * r) * std::sin(limit / 2));
        };
        for (int k = 0; k < 2; ++k) {
            const double least = std::max(opposite(side(k), side(k + 1)), opposite(side(k + 2), side(k + 3)));
            if ((x.col(q[k]) - x.col(q[k + 2])).norm() < (1 + 2e-3) * least) pairs.push_back({q[k], q[k + 2], true});
        }
    }
    return pairs;
}

struct FirstOrder {
    double gradient = std::numeric_limits<double>::infinity();  // ‖∇E + Jᵀλ‖ over what may move, by the λ that fit best
    int active = 0;                                             // diagonals that resist becoming shorter
};

/// Jᵀ: what keeps the pairs that are on, as columns.
inline Eigen::SparseMatrix<double> kept_directions(const std::vector<Pair>& pairs, const std::vector<bool>& is_on,
                                                   const Positions& x, const Eigen::Matrix3Xd& is_free) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto& [a, b, is_diagonal] = pairs[i];
        const Eigen::Vector3d u = (x.col(a) - x.col(b)).stableNormalized();
        for (int k = 0; is_on[i] && k < 3; ++k) {
            entries.emplace_back(3 * a + k, static_cast<int>(i), is_free(k, a) * u[k]);
            entries.emplace_back(3 * b + k, static_cast<int>(i), -is_free(k, b) * u[k]);
        }
    }
    Eigen::SparseMatrix<double> directions(x.size(), static_cast<Eigen::Index>(pairs.size()));
    directions.setFromTriplets(entries.begin(), entries.end());
    return directions;
}

/// The λ for which ‖g + Jᵀλ‖ is least. Rows of J may depend on each other: by normal equations with a little added,
/// corrected until that shows no more.
inline Eigen::VectorXd multipliers(const Eigen::SparseMatrix<double>& Jt, const Eigen::VectorXd& g) {
    Eigen::SparseMatrix<double> normal = Jt.transpose() * Jt, little(Jt.cols(), Jt.cols());
    little.setIdentity();
    normal += 1e-9 * little;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(normal);
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(Jt.cols());
    for (int k = 0; k < 20; ++k) lambda -= factor.solve(Jt.transpose() * (g + Jt * lambda));
    return lambda;
}

/// Karush, Kuhn and Tucker's conditions: the λ of edges may have either sign, those of diagonals push. Diagonals that
/// would pull are let go, and held again where they would become shorter without (Lawson & Hanson 1974, chapter 23).
inline FirstOrder first_order(const Resting& resting, const Positions& x) {
    const double L = resting.net.mean_length(), none = 1e-5 / L;
    const std::vector<Pair> pairs = kept_pairs(resting.net, x, resting.options.shear_limit);
    const Eigen::Matrix3Xd is_free = free_coordinates(resting);
    const Eigen::VectorXd g = gradient_of(resting, x).cwiseProduct(is_free).reshaped();
    const Eigen::SparseMatrix<double> all = kept_directions(pairs, std::vector<bool>(pairs.size(), true), x, is_free);
    std::vector<bool> is_on(pairs.size(), true);
    FirstOrder best;
    for (int round = 0; round < 40; ++round) {
        const Eigen::SparseMatrix<double> Jt = kept_directions(pairs, is_on, x, is_free);
        const Eigen::VectorXd lambda = multipliers(Jt, g), left = g + Jt * lambda, shortening = all.transpose() * left;
        FirstOrder found{left.norm() * L, 0};
        bool pulls = false;
        std::size_t most = pairs.size();
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            if (!pairs[i].is_diagonal) continue;
            if (is_on[i] && lambda[row] > none) {
                pulls = true;
                is_on[i] = false;
            }
            if (is_on[i] && lambda[row] < -none) ++found.active;
            const double least = most < pairs.size() ? shortening[static_cast<Eigen::Index>(most)] : none;
            if (!is_on[i] && shortening[row] > least) most = i;
        }
        if (pulls) continue;
        if (found.gradient < best.gradient) best = found;
        if (most == pairs.size()) break;
        is_on[most] = true;
    }
    return best;
}

}  // namespace chebnet::samples
