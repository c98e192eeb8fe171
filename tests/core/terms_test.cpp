#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <random>

#include "base/stopwatch.h"
#include "net/families.h"
#include "sample_nets.h"
#include "solve/terms/bending_term.h"
#include "solve/terms/closeness_term.h"
#include "solve/terms/distance_constraint.h"
#include "solve/terms/load_terms.h"
#include "solve/terms/penalty_term.h"
#include "solve/terms/shear_term.h"
#include "solve/terms/tip_term.h"

using namespace chebnet;

namespace {

/// A patch with an own length for each edge.
Net uneven_patch(std::mt19937& random) {
    const Net even = samples::patch(6, 5);
    return Net(samples::shaken(even.rest_positions(), 0.1, random), even.faces(), RestLengths::own);
}

Net sample_net(int which, std::mt19937& random) {
    switch (which) {
        case 0:
            return samples::patch(6, 5);
        case 1:
            return samples::cube();
        case 2:
            return samples::mixed_mesh();
        case 3:
            return samples::ring(6, 5, true);
        default:
            return uneven_patch(random);
    }
}

/// Large enough for every vertex to be above or below a face, an edge or a corner of it.
const Guide& tetrahedron() {
    static const Guide guide([] {
        Mesh mesh{Positions(3, 4), {}};
        mesh.positions << 1, -1, -1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
        for (const auto& face : {std::vector{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}) mesh.faces.add(face);
        return Surface(mesh);
    }());
    return guide;
}

std::vector<std::unique_ptr<Term>> terms_of(const Net& net) {
    const Topology topology(net);
    const std::vector<Pull> pulls{
        {0, Eigen::Vector3d(1, 2, 3), 0.5}, {3, Eigen::Vector3d(-1, 0, 2), 20}, {5, Eigen::Vector3d(0, 1, 2), 3, 0.4}};
    std::vector<std::unique_ptr<Term>> terms;
    for (const auto reference : {BendingTerm::Reference::rest, BendingTerm::Reference::straight})
        terms.push_back(std::make_unique<BendingTerm>(net, topology, net.rest_positions(), 1.5, reference));
    std::vector<double> stiffness;
    for (const int family : edge_families(net).value_or(std::vector<int>())) stiffness.push_back(family == 0 ? 2 : 0.3);
    for (const auto reference : {BendingTerm::Reference::straight, BendingTerm::Reference::curved})
        terms.push_back(
            std::make_unique<BendingTerm>(net, topology, net.rest_positions(), 1.5, reference, stiffness, 0.4));
    for (const auto reference : {ShearTerm::Reference::rest, ShearTerm::Reference::right_angles})
        terms.push_back(std::make_unique<ShearTerm>(net, net.rest_positions(), 0.3, reference, 0.3));
    terms.push_back(std::make_unique<TipTerm>(net, topology, 0.7));
    terms.push_back(std::make_unique<PullTerm>(net, pulls));
    terms.push_back(std::make_unique<GravityTerm>(net, 0.7, -Eigen::Vector3d::UnitZ()));
    terms.push_back(std::make_unique<PenaltyTerm>(edge_lengths(net), 2));
    return terms;
}

/// Their second derivatives jump: where a distance is as long as it has to be, and from face to face.
std::vector<std::unique_ptr<Term>> terms_with_kinks(const Net& net) {
    std::vector<std::unique_ptr<Term>> terms;
    terms.push_back(std::make_unique<PenaltyTerm>(shear_limit(net, 1.2), 3));
    for (const auto side : {ClosenessTerm::Side::both, ClosenessTerm::Side::below})
        terms.push_back(std::make_unique<ClosenessTerm>(net, tetrahedron(), 0.5, 2, side));
    return terms;
}

double energy(Term& term, const Positions& x) {
    Eigen::Matrix3Xd ignored = Eigen::Matrix3Xd::Zero(3, x.cols());
    return term.evaluate(x, ignored);
}

Eigen::Matrix3Xd gradient(Term& term, const Positions& x) {
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, x.cols());
    term.evaluate(x, sum);
    return sum;
}

Eigen::Matrix3Xd curvature(const Term& term, Curvature kind, const Eigen::Matrix3Xd& d) {
    Eigen::Matrix3Xd product = Eigen::Matrix3Xd::Zero(3, d.cols());
    term.add_curvature(kind, d, product);
    return product;
}

/// The value of a QuadraticForm along some moves.
class FormAlong : public QuadraticForm {
public:
    explicit FormAlong(const Eigen::Matrix3Xd& d) : m_d(d) {}
    void add_link(int a, int b, double weight) override { value += weight * (m_d.col(a) - m_d.col(b)).squaredNorm(); }
    void add_vertex(int a, double weight) override { value += weight * m_d.col(a).squaredNorm(); }
    double value = 0;

private:
    const Eigen::Matrix3Xd& m_d;
};

/// The product of a BlockForm with some moves.
class BlocksTimes : public BlockForm {
public:
    explicit BlocksTimes(const Eigen::Matrix3Xd& d) : m_d(d), product(Eigen::Matrix3Xd::Zero(3, d.cols())) {}
    void add_vertex(int a, const Eigen::Matrix3d& B) override { product.col(a) += B * m_d.col(a); }
    void add_pair(int a, int b, const Eigen::Matrix3d& B) override {
        product.col(a) += B * m_d.col(b);
        product.col(b) += B.transpose() * m_d.col(a);
    }

private:
    const Eigen::Matrix3Xd& m_d;

public:
    Eigen::Matrix3Xd product;
};

double bound(const Term& term, const Eigen::Matrix3Xd& d) {
    FormAlong form(d);
    term.add_bound(form);
    return form.value;
}

Positions rigidly_moved(const Positions& x, std::mt19937& random) {
    std::normal_distribution<double> normal;
    Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
    turn.normalize();
    return (turn.toRotationMatrix() * x).colwise() + Eigen::Vector3d(normal(random), normal(random), normal(random));
}

struct Random {
    unsigned seed = std::random_device{}();
    std::mt19937 engine{seed};
};

}  // namespace

TEST_CASE("The gradient of each term is its energy's derivative") {
    Random random;
    CAPTURE(random.seed);
    const Net net = sample_net(GENERATE(0, 1, 2, 3, 4), random.engine);
    const Positions x = samples::shaken(net.rest_positions(), 0.15, random.engine);
    const Eigen::Matrix3Xd d = samples::shaken(Positions::Zero(3, x.cols()), 1, random.engine);
    for (const auto& term : terms_of(net)) {
        CAPTURE(term->name());
        // Of fourth order: where a rotation is hardly determined, third derivatives are large.
        const double h = 2e-5;
        const auto difference = [&](double t) {
            return (energy(*term, x + t * d) - energy(*term, x - t * d)) / (2 * t);
        };
        const double slope = (4 * difference(h) - difference(2 * h)) / 3;
        CHECK(samples::dot(gradient(*term, x), d) == Approx(slope).epsilon(1e-6).margin(1e-7));
    }
}

TEST_CASE("The exact curvature of each term is its gradient's derivative, below the term's bound") {
    Random random;
    CAPTURE(random.seed);
    const Net net = sample_net(GENERATE(0, 1, 2, 3, 4), random.engine);
    // Turned as a whole, so that rotations matter.
    const Positions x = samples::shaken(rigidly_moved(net.rest_positions(), random.engine), 0.1, random.engine);
    const Eigen::Matrix3Xd d = samples::shaken(Positions::Zero(3, x.cols()), 1, random.engine);
    for (const auto& term : terms_of(net)) {
        CAPTURE(term->name());
        const double h = 1e-5;
        const Eigen::Matrix3Xd change = (gradient(*term, x + h * d) - gradient(*term, x - h * d)) / (2 * h);
        gradient(*term, x);
        const Eigen::Matrix3Xd product = curvature(*term, Curvature::exact, d);
        CHECK((product - change).norm() <= 1e-4 * change.norm());
        CHECK(samples::dot(d, product) <= bound(*term, d) * (1 + 1e-12) + 1e-12);
    }
}

TEST_CASE("Between kinks, too, gradient and curvature are derivatives") {
    std::mt19937 random(5);  // not by chance: a difference over a kink is none
    const Net net = sample_net(GENERATE(0, 1, 2, 3, 4), random);
    const Positions x = samples::shaken(net.rest_positions(), 0.15, random);
    const Eigen::Matrix3Xd d = samples::shaken(Positions::Zero(3, x.cols()), 1, random);
    for (const auto& term : terms_with_kinks(net)) {
        CAPTURE(term->name());
        const double h = 1e-6;
        CHECK(samples::dot(gradient(*term, x), d) ==
              Approx((energy(*term, x + h * d) - energy(*term, x - h * d)) / (2 * h)).epsilon(1e-6).margin(1e-7));
        const Eigen::Matrix3Xd change = (gradient(*term, x + h * d) - gradient(*term, x - h * d)) / (2 * h);
        gradient(*term, x);
        CHECK((curvature(*term, Curvature::exact, d) - change).norm() <= 1e-5 * change.norm());
    }
}

TEST_CASE("The convex curvature of each term is symmetric, positive, below its bound, and what its blocks say") {
    Random random;
    CAPTURE(random.seed);
    const Net net = sample_net(GENERATE(0, 1, 2, 3, 4), random.engine);
    const Positions x = samples::shaken(net.rest_positions(), 0.15, random.engine);
    const auto direction = [&] { return samples::shaken(Positions::Zero(3, x.cols()), 1, random.engine); };
    std::vector<std::unique_ptr<Term>> terms = terms_of(net);
    for (auto& term : terms_with_kinks(net)) terms.push_back(std::move(term));
    for (const auto& term : terms) {
        CAPTURE(term->name());
        gradient(*term, x);
        for (int k = 0; k < 10; ++k) {
            const Eigen::Matrix3Xd d = direction(), e = direction();
            const Eigen::Matrix3Xd product = curvature(*term, Curvature::convex, d);
            CHECK(samples::dot(d, product) >= -1e-12);
            CHECK(samples::dot(d, product) <= bound(*term, d) * (1 + 1e-12) + 1e-12);
            CHECK(samples::dot(e, product) ==
                  Approx(samples::dot(d, curvature(*term, Curvature::convex, e))).margin(1e-10));
            BlocksTimes blocks(d);
            term->add_blocks(blocks);
            CHECK((blocks.product - product).norm() <= 1e-10 * (1 + product.norm()));
        }
    }
}

TEST_CASE("Where nothing is strained both curvatures are one") {
    Random random;
    CAPTURE(random.seed);
    const Net net = sample_net(GENERATE(0, 1, 2, 3, 4), random.engine);
    const Positions rest = rigidly_moved(net.rest_positions(), random.engine);
    const Eigen::Matrix3Xd d = samples::shaken(Positions::Zero(3, rest.cols()), 1, random.engine);
    const Topology topology(net);
    BendingTerm bending(net, topology, net.rest_positions(), 1.5, BendingTerm::Reference::rest);
    ShearTerm shear(net, net.rest_positions(), 0.3, ShearTerm::Reference::rest, 0.3);
    for (Term* term : std::initializer_list<Term*>{&bending, &shear}) {
        CAPTURE(term->name());
        gradient(*term, rest);
        const Eigen::Matrix3Xd exact = curvature(*term, Curvature::exact, d);
        CHECK((curvature(*term, Curvature::convex, d) - exact).norm() <= 1e-8 * exact.norm());
    }
}

TEST_CASE("A rigid motion costs neither bending nor shear, straight rods turn freely too") {
    Random random;
    CAPTURE(random.seed);
    const Net net = sample_net(GENERATE(0, 1, 2, 3, 4), random.engine);
    const Topology topology(net);
    const Positions moved = rigidly_moved(net.rest_positions(), random.engine);
    BendingTerm bending(net, topology, net.rest_positions(), 1, BendingTerm::Reference::rest);
    ShearTerm shear(net, net.rest_positions(), 1, ShearTerm::Reference::rest, 0.3);
    for (Term* term : std::initializer_list<Term*>{&bending, &shear}) {
        CHECK(std::abs(energy(*term, moved)) < 1e-15);
        CHECK(gradient(*term, moved).norm() < 1e-7);
    }
    BendingTerm rods(net, topology, net.rest_positions(), 1, BendingTerm::Reference::straight);
    CHECK(energy(rods, moved) == Approx(energy(rods, net.rest_positions())).margin(1e-12));
}

TEST_CASE("Rods: a line on a circle has the bending energy of its turning angles") {
    // A prism of quads with n sides: n rows of lines around, which turn by 2π/n at each vertex, straight along.
    const int n = 12, rows = 3;
    Positions x(3, n * rows);
    Faces faces;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < n; ++i) {
            x.col(j * n + i) << std::cos(2 * EIGEN_PI * i / n), std::sin(2 * EIGEN_PI * i / n), 0.5 * j;
            if (j + 1 < rows) faces.add({j * n + i, j * n + (i + 1) % n, (j + 1) * n + (i + 1) % n, (j + 1) * n + i});
        }
    const Net net(x, faces, RestLengths::own);
    BendingTerm rods(net, Topology(net), net.rest_positions(), 2, BendingTerm::Reference::straight);
    const double turn = 2 * std::sin(EIGEN_PI / n);  // ‖t_i + t_j‖ of unit tangents that turn by 2π/n
    CHECK(energy(rods, x) == Approx(2 * n * rows * turn * turn));
}

TEST_CASE("Tips: the corner of a cube costs three times the weight, a vertex that is regular or flat nothing") {
    const Net cube = samples::cube();
    TipTerm tips(cube, Topology(cube), 2);
    CHECK(energy(tips, cube.rest_positions()) == Approx(2 * 3 * 8));
    CHECK(energy(tips, 2 * cube.rest_positions()) == Approx(4 * 2 * 3 * 8));

    // Three rhombs about a vertex, in a plane.
    Mesh flat{Positions::Zero(3, 7), {}};
    for (int k = 0; k < 3; ++k) {
        const double along = 2 * EIGEN_PI / 3 * k, across = along + EIGEN_PI / 3;
        flat.positions.col(1 + 2 * k) << std::cos(along), std::sin(along), 0;
        flat.positions.col(2 + 2 * k) << std::cos(across), std::sin(across), 0;
        flat.faces.add({0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % 6});
    }
    const Net rhombs(flat.positions, flat.faces, RestLengths::own);
    TipTerm at_middle(rhombs, Topology(rhombs), 2);
    CHECK(energy(at_middle, flat.positions) < 1e-28);
    flat.positions.col(0) << 0, 0, 0.5;
    CHECK(energy(at_middle, flat.positions) == Approx(2 * 1.5 * 1.5));

    const Net grid = samples::patch(3, 4);
    Random random;
    CAPTURE(random.seed);
    TipTerm none(grid, Topology(grid), 2);
    CHECK(energy(none, samples::shaken(grid.rest_positions(), 1, random.engine)) == 0);
}

TEST_CASE("Constraints: Jacobian and curvature are derivatives, and rows of the Jacobian act as their transposes") {
    Random random;
    CAPTURE(random.seed);
    const Net net = sample_net(GENERATE(0, 1, 2, 3, 4), random.engine);
    const Positions x = samples::shaken(net.rest_positions(), 0.1, random.engine);
    const auto direction = [&] { return samples::shaken(Positions::Zero(3, x.cols()), 1, random.engine); };
    for (DistanceConstraint constraint : {edge_lengths(net), shear_limit(net, 0.5)}) {
        CAPTURE(constraint.name());
        const Eigen::Matrix3Xd d = direction(), e = direction();
        const Eigen::VectorXd y = Eigen::VectorXd::NullaryExpr(
            constraint.count(), [&] { return std::uniform_real_distribution<double>(-1, 1)(random.engine); });
        const double h = 1e-5;
        const Eigen::VectorXd change = (constraint.evaluate(x + h * d) - constraint.evaluate(x - h * d)) / (2 * h);
        const auto pulled = [&](const Positions& at) {
            constraint.evaluate(at);
            Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, x.cols());
            constraint.add_transposed(y, sum);
            return sum;
        };
        const Eigen::Matrix3Xd pull_change = (pulled(x + h * d) - pulled(x - h * d)) / (2 * h);
        const Eigen::Matrix3Xd pull = pulled(x);
        CHECK((constraint.multiply(d) - change).norm() <= 1e-6 * (1 + change.norm()));
        CHECK(constraint.multiply(e).dot(y) == Approx(samples::dot(e, pull)).margin(1e-10));
        Eigen::Matrix3Xd curved = Eigen::Matrix3Xd::Zero(3, x.cols());
        constraint.add_curvature(y, d, curved);
        CHECK((curved - pull_change).norm() <= 1e-5 * (1 + pull_change.norm()));
    }
}

TEST_CASE("The shear limit holds exactly when no corner of a quad is sharper, nor blunter than its supplement") {
    for (const double degrees : {25.0, 30.0, 35.0, 90.0, 145.0, 150.0, 155.0}) {
        const double angle = degrees * EIGEN_PI / 180;
        Positions rhombus(3, 4);
        rhombus << 0, 1, 1 + std::cos(angle), std::cos(angle),  //
            0, 0, std::sin(angle), std::sin(angle),             //
            0, 0, 0, 0;
        Faces faces;
        faces.add({0, 1, 2, 3});
        const Net net(rhombus, faces);
        DistanceConstraint limit = shear_limit(net, 30 * EIGEN_PI / 180);
        CAPTURE(degrees);
        CHECK(limit.count() == 2);
        CHECK((limit.evaluate(rhombus).minCoeff() >= -1e-12) == (degrees >= 30 && degrees <= 150));
    }
    CHECK(shear_limit(samples::mixed_mesh(), 0.5).count() == 2);  // of three faces one is a quad
}

TEST_CASE("Lines through a vertex at which very many edges meet are looked for in no time") {
    constexpr int count = 100'000;
    Positions x(3, count + 1);
    Faces fan;
    x.col(0).setZero();
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * EIGEN_PI * k / count;
        x.col(k + 1) << std::cos(angle), std::sin(angle), 0;
        fan.add({0, 1 + k, 1 + (k + 1) % count});
    }
    const Net net(x, fan);
    const Topology topology(net);
    const Stopwatch watch;
    const BendingTerm term(net, topology, net.rest_positions(), 1, BendingTerm::Reference::straight);
    CHECK(watch.milliseconds() < 3000);  // each edge compared with each takes more than ten times that
}
