#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "energy/composite_power_energy.h"
#include "energy/direct_energy.h"
#include "energy/length_power_energy.h"
#include "energy/power_energy.h"
#include "energy/projected_power_energy.h"
#include "net/measures.h"

using namespace chebnet;

namespace {

// Every exponent that the paper uses.
const std::vector<double> k_exponents{2, 4, 8, 10, 20, 50, 75};

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

Eigen::Matrix3d block(const EdgeCurvature& c, const Eigen::Vector3d& u, double L) {
    const Eigen::Matrix3d radial = u * u.transpose();
    return (c.radial * radial + c.tangential * (Eigen::Matrix3d::Identity() - radial)) / (L * L);
}

using Energy = std::shared_ptr<const EdgeEnergy>;
/// A convex function of the edge vector d that bounds an energy and touches it at d₀.
using Majorizer = std::function<double(double L, const Eigen::Vector3d& d0, const Eigen::Vector3d& d)>;

struct Sample {
    std::string name;
    double p;
    Energy energy;
    Majorizer majorizer;  // none: the curvature is not that of a majorizer
};

/// The first-order expansion of r^q around d₀, at d.
double linear_power(double q, double L, const Eigen::Vector3d& d0, const Eigen::Vector3d& d) {
    const double r0 = d0.norm() / L;
    return std::pow(r0, q) + q * std::pow(r0, q - 1) / L * d0.normalized().dot(d - d0);
}

/// g + 1 / (g₀ + ∇g₀·(d − d₀)) − 2 with g = r^p (section 3.2.1). Infinite where the linear part is not positive.
Majorizer paper_majorizer(double p) {
    return [p](double L, const Eigen::Vector3d& d0, const Eigen::Vector3d& d) {
        const double linear = linear_power(p, L, d0, d);
        return linear > 0 ? std::pow(d.norm() / L, p) + 1 / linear - 2 : std::numeric_limits<double>::infinity();
    };
}

/// h⁺(g) + h⁻(g₀ + ∇g₀·(d − d₀)) with g = r^q, where h falls below 1 and rises above: composite majorization.
Majorizer split_majorizer(double q, std::function<double(double)> h) {
    return [q, h](double L, const Eigen::Vector3d& d0, const Eigen::Vector3d& d) {
        const double rising = std::max(std::pow(d.norm() / L, q), 1.0), falling = linear_power(q, L, d0, d);
        if (falling <= 0) return std::numeric_limits<double>::infinity();
        return h(rising) + h(std::min(falling, 1.0));
    };
}

Majorizer composite_majorizer(double p) {
    return split_majorizer(p, [](double y) { return y + 1 / y - 2; });
}

std::vector<Sample> energy_samples() {
    std::vector<Sample> list;
    for (const double p : {2.0, 3.0, 8.0, 50.0}) {
        list.push_back({"paper", p, std::make_shared<PowerEnergy>(p), paper_majorizer(p)});
        list.push_back({"composite", p, std::make_shared<CompositePowerEnergy>(p), composite_majorizer(p)});
        list.push_back({"projected", p, std::make_shared<ProjectedPowerEnergy>(p), nullptr});
    }
    for (const double p : {2.0, 4.0, 8.0})
        list.push_back({"length power", p, std::make_shared<LengthPowerEnergy>(p),
                        split_majorizer(1, [p](double y) { return std::pow(std::abs(y - 1), p); })});
    for (const double p : {2.0, 3.0, 8.0})
        list.push_back({"direct", p, std::make_shared<DirectEnergy>(p),
                        split_majorizer(1, [p](double y) { return std::pow(deviation(y), p); })});
    return list;
}

}  // namespace

TEST_CASE("The energy is r^p + r^-p - 2, without cancellation near r = 1") {
    const double p = GENERATE(1.5, 2.0, 7.0, 50.0), r = GENERATE(0.6, 1.0, 1.3);
    CHECK(PowerEnergy(p).value(r) == Approx(std::pow(r, p) + std::pow(r, -p) - 2).margin(1e-12));
    const double t = 1e-9;
    CHECK(PowerEnergy(p).value(1 + t) == Approx(p * p * t * t).epsilon(1e-5));
}

TEST_CASE("Powers of length below 2 have finite derivatives at r = 1, where their own grow beyond all numbers") {
    const LengthPowerEnergy energy(1.5);
    CHECK(std::isfinite(energy.second_derivative(1)));
    CHECK(energy.second_derivative(1) >= energy.second_derivative(1 + 1e-7));
    CHECK(energy.second_derivative(1.01) == Approx(1.5 * 0.5 * 10));
    CHECK(LengthPowerEnergy(2).second_derivative(1) == 2);
    CHECK(LengthPowerEnergy(4).second_derivative(1) == 0);
}

TEST_CASE("Every energy has its own value, and none at r = 1") {
    const double r = GENERATE(0.6, 0.97, 1.0, 1.3);
    for (const Sample& sample : energy_samples()) {
        INFO(sample.name << " p = " << sample.p);
        CHECK(sample.energy->value(1) == 0);
        CHECK(sample.energy->slope(1) == 0);
        const double dL = r + 1 / r - 2;
        const double expected = sample.name == "length power" ? std::pow(std::abs(r - 1), sample.p)
                                : sample.name == "direct"     ? std::pow(dL, sample.p)
                                                              : std::pow(r, sample.p) + std::pow(r, -sample.p) - 2;
        CHECK(sample.energy->value(r) == Approx(expected).margin(1e-12));
    }
}

TEST_CASE("How flat an energy is near the solution is told by its slope beside that of a quadratic one") {
    constexpr double dL = 1e-6, r = 1 + 1e-3;
    for (const double p : {2., 3., 4., 8.})
        CHECK(LengthPowerEnergy(p).relative_slope(dL) ==
              Approx(LengthPowerEnergy(p).slope(r) / LengthPowerEnergy(2).slope(r)));
    CHECK(LengthPowerEnergy(1.5).relative_slope(dL) == 1);
    CHECK(PowerEnergy(50).relative_slope(dL) == 1);
}

TEST_CASE("Slope, true Hessian and gradient block agree with finite differences") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (const auto& [name, p, energy, majorizer] : energy_samples()) {
        INFO(name << " p = " << p);
        for (int k = 0; k < 20; ++k) {
            const RandomEdge edge(random);
            const auto value = [&, &f = energy](const Eigen::Vector3d& d) { return f->value(d.norm() / edge.L); };
            const auto gradient = [&, &f = energy](const Eigen::Vector3d& d) {
                return Eigen::Vector3d(f->slope(d.norm() / edge.L) / edge.L * d.normalized());
            };
            const Eigen::Matrix3d hessian = block(energy->hessian(edge.r), edge.u, edge.L);
            // Relative to r − 1, whose high powers some of the energies are.
            const double h = 1e-4 * edge.L * std::min(1 / p, std::abs(edge.r - 1) / p);
            for (int i = 0; i < 3; ++i) {
                const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
                const double slope = (value(edge.d + step) - value(edge.d - step)) / (2 * h);
                CHECK(slope == Approx(gradient(edge.d)[i]).margin(1e-4 * gradient(edge.d).norm() + 1e-12));
                const Eigen::Vector3d column = (gradient(edge.d + step) - gradient(edge.d - step)) / (2 * h);
                CHECK((column - hessian.col(i)).norm() < 1e-4 * hessian.norm() + 1e-12);
            }
        }
    }
}

TEST_CASE("Proposition 2: a majorizer is convex, bounds its energy, touches value and gradient, its Hessian is used") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (const auto& [name, p, energy, majorizer] : energy_samples()) {
        if (!majorizer) continue;
        INFO(name << " p = " << p);
        for (int k = 0; k < 50; ++k) {
            const RandomEdge at(random), other(random);
            const double L = at.L, h = 2e-4 * L / p;
            if (std::abs(at.r - 1) * L < 2 * h) continue;  // the Hessian jumps there
            CAPTURE(at.r, other.r);
            const auto bound = [&, &m = majorizer](const Eigen::Vector3d& d) { return m(L, at.d, d); };

            const Eigen::Vector3d elsewhere = other.d / other.L * L;
            CHECK(bound(elsewhere) >= energy->value(other.r) * (1 - 1e-9) - 1e-9);
            const double chord = (bound(at.d) + bound(elsewhere)) / 2;
            CHECK(bound((at.d + elsewhere) / 2) <= chord * (1 + 1e-9) + 1e-9);
            CHECK(bound(at.d) == Approx(energy->value(at.r)).margin(1e-9));

            // Central differences of the bound: its gradient is the energy's, its Hessian the curvature block.
            const Eigen::Vector3d gradient = energy->slope(at.r) / L * at.u;
            const Eigen::Matrix3d hessian = block(energy->curvature(at.r), at.u, L);
            for (int i = 0; i < 3; ++i) {
                const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
                const double up = bound(at.d + step), down = bound(at.d - step), here = bound(at.d);
                CHECK((up - down) / (2 * h) == Approx(gradient[i]).margin(1e-4 * hessian.norm() * L + 1e-9));
                CHECK((up - 2 * here + down) / (h * h) ==
                      Approx(hessian(i, i)).margin(2e-3 * hessian.norm() + 1e-3 / (L * L)));
            }
        }
    }
}

TEST_CASE("No curvature is indefinite, none of a majorizer is below the true one") {
    const double r = GENERATE(0.3, 0.5, 0.9, 0.999, 1.0, 1.001, 1.1, 2.0, 10.0);
    for (const auto& [name, p, energy, majorizer] : energy_samples()) {
        INFO(name << " p = " << p);
        const EdgeCurvature used = energy->curvature(r), real = energy->hessian(r);
        CHECK(used.radial >= 0);
        CHECK(used.tangential >= 0);
        CHECK(used.radial >= real.radial * (1 - 1e-12));
        CHECK(used.tangential >= real.tangential * (1 - 1e-12));
        if (name == "paper") CHECK(used.tangential > 0);
    }
}

TEST_CASE("Proposition 3: neither composite majorization's majorizer nor its Hessian is ever above the paper's") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (const double p : k_exponents) {
        const Majorizer paper_bound = paper_majorizer(p), composite_bound = composite_majorizer(p);
        for (int k = 0; k < 200; ++k) {
            const RandomEdge edge(random), other(random);
            CAPTURE(p, edge.r, other.r);
            const Eigen::Vector3d elsewhere = other.d / other.L * edge.L;
            CHECK(composite_bound(edge.L, edge.d, elsewhere) <=
                  paper_bound(edge.L, edge.d, elsewhere) * (1 + 1e-9) + 1e-9);
            const EdgeCurvature composite = CompositePowerEnergy(p).curvature(edge.r);
            const EdgeCurvature paper = PowerEnergy(p).curvature(edge.r);
            CHECK(composite.radial <= paper.radial * (1 + 1e-12));
            CHECK(composite.tangential <= paper.tangential * (1 + 1e-12));
        }
    }
}

TEST_CASE("Under composite majorization and projected Newton only stretched edges feel tangential stiffness") {
    for (const double p : {2.0, 50.0}) {
        const CompositePowerEnergy composite(p);
        const ProjectedPowerEnergy projected(p);
        for (const double r : {0.3, 0.8, 0.999}) {
            CHECK(composite.curvature(r).tangential == 0);
            CHECK(projected.curvature(r).tangential == 0);
            CHECK(projected.curvature(r).radial == composite.hessian(r).radial);
            CHECK(composite.curvature(r).radial > projected.curvature(r).radial);
        }
        // Both are the true Hessian where that is positive semi-definite.
        for (const double r : {1.0, 1.001, 1.3, 3.0})
            for (const EdgeCurvature& c : {composite.curvature(r), projected.curvature(r)}) {
                CHECK(c.radial == composite.hessian(r).radial);
                CHECK(c.tangential == composite.hessian(r).tangential);
                CHECK((c.tangential > 0) == (r > 1));
            }
    }
}

TEST_CASE("Proposition 1: F^new_p = r^p + r^-p - 2 is no less than dL^p, and both are 0 at r = 1 alone") {
    for (const double p : k_exponents) {
        const PowerEnergy power(p);
        const DirectEnergy direct(p);
        CHECK(power.value(1) == 0);
        CHECK(direct.value(1) == 0);
        for (double r = 0.25; r <= 4; r *= 1.001) {
            CAPTURE(p, r);
            CHECK(power.value(r) == Approx(std::pow(r, p) + std::pow(r, -p) - 2));
            CHECK(power.value(r) > std::pow(r + 1 / r - 2, p));
            CHECK(direct.value(r) == Approx(std::pow(r + 1 / r - 2, p)));
        }
    }
}

TEST_CASE("A large exponent sees the worst edge only: the energy's p-th root tends to max(r, 1/r)") {
    const std::vector<double> ratios{0.97, 1.02, 0.94, 1.01};
    const double worst = 1 / 0.94;
    double gap_before = std::numeric_limits<double>::infinity();
    for (const double p : k_exponents) {
        double sum = 0;
        for (const double r : ratios) sum += PowerEnergy(p).value(r) + 2;
        const double gap = std::pow(sum, 1 / p) - worst;
        CHECK(gap > 0);
        CHECK(gap < gap_before);
        gap_before = gap;
    }
    CHECK(gap_before < 0.01 * worst);
}
