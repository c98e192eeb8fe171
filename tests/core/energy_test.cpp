#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

#include "energy/power_energy.h"

using namespace chebnet;

namespace {

/// An edge vector d = L r u with a random direction and a ratio between 1/2 and 2.
struct RandomEdge {
    explicit RandomEdge(std::mt19937& random) {
        std::uniform_real_distribution<double> unit(0, 1);
        std::normal_distribution<double> normal;
        L = 0.1 + 3 * unit(random);
        r = std::pow(2, 2 * unit(random) - 1);
        u = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
        d = L * r * u;
    }
    double L, r;
    Eigen::Vector3d u, d;
};

Eigen::Matrix3d block(const Curvature& c, const Eigen::Vector3d& u, double L) {
    const Eigen::Matrix3d radial = u * u.transpose();
    return (c.radial * radial + c.tangential * (Eigen::Matrix3d::Identity() - radial)) / (L * L);
}

/// The majorizer of section 3.2.1 around d0, as a function of the edge vector: g + 1 / (g₀ + ∇g₀·(d − d₀)) − 2.
/// Infinite where the linear part is not positive.
double majorizer(double p, double L, const Eigen::Vector3d& d0, const Eigen::Vector3d& d) {
    const double r0 = d0.norm() / L, g0 = std::pow(r0, p);
    const Eigen::Vector3d gradient0 = p * std::pow(r0, p - 1) / L * d0.normalized();
    const double linear = g0 + gradient0.dot(d - d0);
    return linear > 0 ? std::pow(d.norm() / L, p) + 1 / linear - 2 : std::numeric_limits<double>::infinity();
}

}  // namespace

TEST_CASE("The energy is r^p + r^-p - 2, without cancellation near r = 1") {
    const double p = GENERATE(1.5, 2.0, 7.0, 50.0), r = GENERATE(0.6, 1.0, 1.3);
    CHECK(PowerEnergy(p).value(r) == Approx(std::pow(r, p) + std::pow(r, -p) - 2).margin(1e-12));
    const double t = 1e-9;
    CHECK(PowerEnergy(p).value(1 + t) == Approx(p * p * t * t).epsilon(1e-5));
}

TEST_CASE("Slope, true Hessian and gradient block agree with finite differences") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const double p = GENERATE(2.0, 3.0, 8.0, 50.0);
    const PowerEnergy energy(p);
    for (int k = 0; k < 50; ++k) {
        const RandomEdge edge(random);
        const auto value = [&](const Eigen::Vector3d& d) { return energy.value(d.norm() / edge.L); };
        const auto gradient = [&](const Eigen::Vector3d& d) {
            return Eigen::Vector3d(energy.slope(d.norm() / edge.L) / edge.L * d.normalized());
        };
        const Eigen::Matrix3d hessian = block(energy.hessian(edge.r), edge.u, edge.L);
        const double h = 1e-5 * edge.L / p;
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
            const double slope = (value(edge.d + step) - value(edge.d - step)) / (2 * h);
            CHECK(slope == Approx(gradient(edge.d)[i]).margin(1e-5 * gradient(edge.d).norm() + 1e-9));
            const Eigen::Vector3d column = (gradient(edge.d + step) - gradient(edge.d - step)) / (2 * h);
            CHECK((column - hessian.col(i)).norm() < 1e-6 * hessian.norm());
        }
    }
}

TEST_CASE("The majorizer bounds the energy and touches its value and gradient; its Hessian is the one used") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const double p = GENERATE(2.0, 4.0, 50.0);
    const PowerEnergy energy(p);
    for (int k = 0; k < 100; ++k) {
        const RandomEdge at(random), other(random);
        const double L = at.L;
        const auto bound = [&](const Eigen::Vector3d& d) { return majorizer(p, L, at.d, d); };

        const Eigen::Vector3d elsewhere = other.d / other.L * L;
        CHECK(bound(elsewhere) >= energy.value(other.r) * (1 - 1e-9) - 1e-9);
        CHECK(bound(at.d) == Approx(energy.value(at.r)).margin(1e-9));

        // Central differences of the bound: its gradient is the energy's, its Hessian the curvature block.
        const double h = 2e-4 * L / p;
        const Eigen::Vector3d gradient = energy.slope(at.r) / L * at.u;
        const Eigen::Matrix3d hessian = block(energy.curvature(at.r), at.u, L);
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
            const double up = bound(at.d + step), down = bound(at.d - step), here = bound(at.d);
            CHECK((up - down) / (2 * h) == Approx(gradient[i]).margin(1e-5 * hessian.norm() * L));
            CHECK((up - 2 * here + down) / (h * h) == Approx(hessian(i, i)).margin(1e-3 * hessian.norm()));
        }
        // The weights are the block's eigenvalues, times L².
        CHECK(energy.curvature(at.r).radial > 0);
        CHECK(energy.curvature(at.r).tangential > 0);
    }
}

TEST_CASE("The majorizer's Hessian is never below the true one") {
    const double p = GENERATE(2.0, 5.0, 50.0), r = GENERATE(0.5, 0.9, 1.0, 1.1, 2.0);
    const PowerEnergy energy(p);
    CHECK(energy.curvature(r).radial >= energy.hessian(r).radial);
    CHECK(energy.curvature(r).tangential >= energy.hessian(r).tangential);
}

TEST_CASE(
    "Proposition 1: the energy is the direct p-th power of the stretch up to constants, and its root tends to the "
    "worst edge") {
    // For a, b > 0 and p ≥ 1: a^p + b^p ≤ (a + b)^p ≤ 2^(p−1) (a^p + b^p), here with a = r, b = 1/r.
    const double p = GENERATE(2.0, 10.0, 50.0), r = GENERATE(0.7, 0.95, 1.0, 1.02, 1.5);
    const double energy = PowerEnergy(p).value(r) + 2, direct = std::pow(r + 1 / r, p);
    CHECK(energy <= direct);
    CHECK(direct <= std::pow(2, p - 1) * energy * (1 + 1e-12));

    // (Σ r^p + r^−p)^(1/p) → max(r, 1/r) over the edges: a large exponent sees the worst edge only.
    const std::vector<double> ratios{0.97, 1.02, r, 1.01};
    double worst = 0;
    for (double ratio : ratios) worst = std::max({worst, ratio, 1 / ratio});
    const auto gap = [&](double exponent) {
        double sum = 0;
        for (double ratio : ratios) sum += PowerEnergy(exponent).value(ratio) + 2;
        return std::pow(sum, 1 / exponent) - worst;
    };
    CHECK(gap(p) > 0);
    CHECK(gap(2 * p) < gap(p));
    CHECK(gap(1000) < 0.003 * worst);
}
