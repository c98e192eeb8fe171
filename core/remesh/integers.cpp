#include "remesh/integers.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdlib>

namespace chebnet {

namespace {

// What is not better by more than this part is no improvement.
constexpr double k_improvement = 1e-9;
constexpr int k_most_improvements = 1000;

int rounded_quotient(int a, int b) { return static_cast<int>(std::lround(static_cast<double>(a) / b)); }

/// Column operations that leave one column whose product with the condition is not 0. Returns that, or −1.
int reduce_to_one(Eigen::MatrixXi& basis, Eigen::VectorXi& products) {
    for (;;) {
        int pivot = -1, others = 0;
        for (int k = 0; k < products.size(); ++k) {
            if (products[k] == 0) continue;
            ++others;
            if (pivot < 0 || std::abs(products[k]) < std::abs(products[pivot])) pivot = k;
        }
        if (others <= 1) return pivot;
        for (int k = 0; k < products.size(); ++k) {
            if (k == pivot || products[k] == 0) continue;
            const int times = rounded_quotient(products[k], products[pivot]);
            basis.col(k) -= times * basis.col(pivot);
            products[k] -= times * products[pivot];
        }
    }
}

void remove_column(Eigen::MatrixXi& matrix, int column) {
    const Eigen::Index last = matrix.cols() - 1;
    matrix.middleCols(column, last - column) = matrix.rightCols(last - column).eval();
    matrix.conservativeResize(Eigen::NoChange, last);
}

/// Rounds one after the other, the one nearest to an integer first.
Eigen::VectorXi round_one_by_one(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
    const Eigen::Index size = b.size();
    Eigen::MatrixXd inverse = A.ldlt().solve(Eigen::MatrixXd::Identity(size, size));
    Eigen::VectorXd y = -inverse * b;
    std::vector<bool> is_free(static_cast<std::size_t>(size), true);
    for (Eigen::Index k = 0; k < size; ++k) {
        Eigen::Index best = -1;
        double least = 1;
        for (Eigen::Index i = 0; i < size; ++i) {
            const double error = std::abs(y[i] - std::round(y[i]));
            if (is_free[i] && error < least) best = i, least = error;
        }
        if (best < 0) break;
        is_free[best] = false;
        const double value = std::round(y[best]), change = value - y[best];
        const Eigen::VectorXd column = inverse.col(best);
        if (column[best] > 0) {
            for (Eigen::Index i = 0; i < size; ++i)
                if (is_free[i]) y[i] += change / column[best] * column[i];
            for (Eigen::Index j = 0; j < size; ++j)
                if (is_free[j])
                    for (Eigen::Index i = 0; i < size; ++i)
                        if (is_free[i]) inverse(i, j) -= column[i] * column[j] / column[best];
        }
        y[best] = value;
    }
    Eigen::VectorXi result(size);
    for (Eigen::Index i = 0; i < size; ++i) result[i] = static_cast<int>(std::lround(y[i]));
    return result;
}

/// A change of one or two integers by 1.
struct Change {
    Eigen::Index first = 0, second = -1;
    int by_first = 0, by_second = 0;
    double gain = 0;
};

Change best_change(const Eigen::MatrixXd& A, const Eigen::VectorXd& gradient) {
    Change best;
    const Eigen::VectorXd half = A.diagonal() / 2;
    Eigen::VectorXd row(gradient.size());  // beside each other, for most of the time goes here
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) row[j] = A(i, j);
        for (const int a : {-1, 1}) {
            const double cost = half[i] + a * gradient[i];
            if (cost < best.gain) best = {i, -1, a, 0, cost};
            for (Eigen::Index j = 0; j < i; ++j) {
                const double both = cost + half[j], less = both - gradient[j] - a * row[j],
                             more = both + gradient[j] + a * row[j];
                if (less < best.gain) best = {i, j, a, -1, less};
                if (more < best.gain) best = {i, j, a, 1, more};
            }
        }
    }
    return best;
}

}  // namespace

Eigen::MatrixXi integer_null_space(int variables, const std::vector<IntegerCondition>& conditions) {
    Eigen::MatrixXi basis = Eigen::MatrixXi::Identity(variables, variables);
    for (const IntegerCondition& condition : conditions) {
        Eigen::VectorXi products = Eigen::VectorXi::Zero(basis.cols());
        for (const auto& [variable, coefficient] : condition.entries)
            products += coefficient * basis.row(variable).transpose();
        const int pivot = reduce_to_one(basis, products);
        if (pivot >= 0) remove_column(basis, pivot);
    }
    return basis;
}

Eigen::VectorXi nearest_integers(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
    Eigen::VectorXi y = round_one_by_one(A, b);
    Eigen::VectorXd gradient = A * y.cast<double>() + b;
    const double enough = k_improvement * (1 + std::abs(b.dot(y.cast<double>())));
    for (int k = 0; k < k_most_improvements; ++k) {
        const Change change = best_change(A, gradient);
        if (!(change.gain < -enough)) break;
        y[change.first] += change.by_first;
        gradient += change.by_first * A.col(change.first);
        if (change.second < 0) continue;
        y[change.second] += change.by_second;
        gradient += change.by_second * A.col(change.second);
    }
    return y;
}

}  // namespace chebnet
