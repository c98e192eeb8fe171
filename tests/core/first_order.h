#pragma once

#include <Eigen/QR>
#include <cmath>
#include <span>
#include <vector>

#include "edit/edit_state.h"
#include "net/net.h"
#include "net/topology.h"
#include "solve/options.h"
#include "solve/terms/bending_term.h"
#include "solve/terms/closeness_term.h"
#include "solve/terms/load_terms.h"
#include "solve/terms/shear_term.h"
#include "surface/guide.h"

namespace chebnet::samples {

constexpr double k_radians = EIGEN_PI / 180;  // of a degree

/// ∇E by the terms, whose derivatives are tested for themselves.
inline Eigen::Matrix3Xd gradient_of(const Net& net, const Options& options, const Positions& x, const Guide* guide) {
    const Topology topology(net);
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x.cols());
    BendingTerm(net, topology, net.rest_positions(), options.bending_weight,
                options.straight_rods ? BendingTerm::Reference::straight : BendingTerm::Reference::rest)
        .evaluate(x, gradient);
    ShearTerm(net, net.rest_positions(), options.shear_weight, ShearTerm::Reference::rest,
              options.shear_limit * k_radians)
        .evaluate(x, gradient);
    GravityTerm(net, options.gravity, -Eigen::Vector3d::UnitZ()).evaluate(x, gradient);
    const auto mode = static_cast<GuideMode>(options.guide_mode);
    if (guide != nullptr && mode != GuideMode::off)
        ClosenessTerm(net, *guide, 1, (mode == GuideMode::near ? 1 : 100) * options.guide_weight,
                      mode == GuideMode::outside ? ClosenessTerm::Side::below : ClosenessTerm::Side::both)
            .evaluate(x, gradient);
    return gradient;
}

/// Two vertices whose distance is kept, or may not become less.
struct Pair {
    int a, b;
    bool is_diagonal;
};

inline std::vector<Pair> kept_pairs(const Net& net, const Positions& x, double limit) {
    std::vector<Pair> pairs;
    for (int e = 0; e < net.edge_count(); ++e) pairs.push_back({net.edges()(0, e), net.edges()(1, e), false});
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> q = net.faces()[f];
        for (int k = 0; q.size() == 4 && k < 2; ++k)
            if ((x.col(q[k]) - x.col(q[k + 2])).norm() < (1 + 1e-3) * 2 * net.mean_length() * std::sin(limit / 2))
                pairs.push_back({q[k], q[k + 2], true});
    }
    return pairs;
}

struct FirstOrder {
    double gradient = 0;       // ‖∇E + Jᵀλ‖ over what may move, by the λ that fit best
    double smallest_push = 0;  // of diagonals at the limit: how much the least of them resists becoming shorter
    int active = 0;            // diagonals at the limit
};

/// Karush, Kuhn and Tucker's conditions, reckoned densely, with these exact handles.
inline FirstOrder first_order(const Net& net, const std::vector<Handle>& handles, const Options& options,
                              const Positions& x, const Guide* guide = nullptr) {
    const std::vector<Pair> pairs = kept_pairs(net, x, options.shear_limit * k_radians);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(pairs.size()), 3 * x.cols());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Eigen::RowVector3d u = (x.col(pairs[i].a) - x.col(pairs[i].b)).normalized().transpose();
        J.block<1, 3>(static_cast<Eigen::Index>(i), 3 * pairs[i].a) = u;
        J.block<1, 3>(static_cast<Eigen::Index>(i), 3 * pairs[i].b) = -u;
    }
    Eigen::Matrix3Xd gradient = gradient_of(net, options, x, guide);
    for (const Handle& handle : handles)
        for (int k = 0; k < 3; ++k) {
            if (has_axis(handle.slides, k)) continue;
            gradient(k, handle.vertex) = 0;
            J.col(3 * handle.vertex + k).setZero();
        }
    const Eigen::VectorXd g = gradient.reshaped();
    const Eigen::VectorXd lambda = J.transpose().completeOrthogonalDecomposition().solve(-g);
    FirstOrder result;
    result.gradient = (g + J.transpose() * lambda).norm() * net.mean_length();
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i].is_diagonal) {
            ++result.active;
            result.smallest_push = std::min(result.smallest_push, -lambda[static_cast<Eigen::Index>(i)]);
        }
    return result;
}

}  // namespace chebnet::samples
