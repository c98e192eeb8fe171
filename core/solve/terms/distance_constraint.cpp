#include "solve/terms/distance_constraint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace chebnet {

namespace {

// No diagonal is to be longer than this part of what the edges on either side reach when they lie in one line.
constexpr double k_attainable = 0.9;

}  // namespace

DistanceConstraint::DistanceConstraint(const char* name, Kind kind, std::vector<Distance> distances)
    : m_name(name), m_kind(kind), m_distances(std::move(distances)), m_directions(3, count()), m_lengths(count()) {}

Eigen::VectorXd DistanceConstraint::evaluate(const Positions& x) {
    Eigen::VectorXd c(count());
    for (int i = 0; i < count(); ++i) {
        const auto& [a, b, distance, unit] = m_distances[i];
        const Eigen::Vector3d d = x.col(a) - x.col(b);
        m_lengths[i] = d.norm();
        // Two vertices in one place have no direction to go apart; their neighbours will open them.
        m_directions.col(i) = m_lengths[i] > 0 ? Eigen::Vector3d(d / m_lengths[i]) : Eigen::Vector3d::Zero();
        c[i] = (m_lengths[i] - distance) / unit;
    }
    return c;
}

Eigen::VectorXd DistanceConstraint::multiply(const Eigen::Matrix3Xd& d) const {
    Eigen::VectorXd product(count());
    for (int i = 0; i < count(); ++i)
        product[i] = m_directions.col(i).dot(d.col(m_distances[i].vertex_a) - d.col(m_distances[i].vertex_b)) /
                     m_distances[i].unit;
    return product;
}

void DistanceConstraint::add_transposed(const Eigen::VectorXd& y, Eigen::Matrix3Xd& sum) const {
    for (int i = 0; i < count(); ++i) {
        if (y[i] == 0) continue;
        const Eigen::Vector3d force = y[i] / m_distances[i].unit * m_directions.col(i);
        sum.col(m_distances[i].vertex_a) += force;
        sum.col(m_distances[i].vertex_b) -= force;
    }
}

void DistanceConstraint::add_curvature(const Eigen::VectorXd& y, const Eigen::Matrix3Xd& d,
                                       Eigen::Matrix3Xd& product) const {
    for (int i = 0; i < count(); ++i) {
        if (y[i] == 0 || m_lengths[i] == 0) continue;
        const Eigen::Vector3d u = m_directions.col(i);
        const Eigen::Vector3d move = d.col(m_distances[i].vertex_a) - d.col(m_distances[i].vertex_b);
        const Eigen::Vector3d force = y[i] / (m_distances[i].unit * m_lengths[i]) * (move - u.dot(move) * u);
        product.col(m_distances[i].vertex_a) += force;
        product.col(m_distances[i].vertex_b) -= force;
    }
}

DistanceConstraint edge_lengths(const Net& net) {
    std::vector<Distance> distances;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double L = net.rest_lengths()[e];
        distances.push_back({net.edges()(0, e), net.edges()(1, e), L, L});
    }
    return DistanceConstraint("lengths", DistanceConstraint::Kind::equal, std::move(distances));
}

DistanceConstraint shear_limit(const Net& net, double angle) {
    std::map<std::pair<int, int>, double> length;
    for (int e = 0; e < net.edge_count(); ++e) length[{net.edges()(0, e), net.edges()(1, e)}] = net.rest_lengths()[e];
    const auto between = [&](int a, int b) { return length.at(std::minmax(a, b)); };
    const auto opposite = [&](double p, double q) { return std::sqrt(p * p + q * q - 2 * p * q * std::cos(angle)); };

    std::vector<Distance> diagonals;
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> q = net.faces()[f];
        if (q.size() != 4) continue;
        double sides[4];
        for (int k = 0; k < 4; ++k) sides[k] = between(q[k], q[(k + 1) % 4]);
        const double unit = (sides[0] + sides[1] + sides[2] + sides[3]) / 4;
        for (int k = 0; k < 2; ++k) {
            const double a = sides[k], b = sides[k + 1], c = sides[k + 2], d = sides[(k + 3) % 4];
            const double wanted = std::max(opposite(a, b), opposite(c, d));
            diagonals.push_back({q[k], q[k + 2], std::min(wanted, k_attainable * std::min(a + b, c + d)), unit});
        }
    }
    return DistanceConstraint("shear limit", DistanceConstraint::Kind::at_least, std::move(diagonals));
}

}  // namespace chebnet
