#pragma once

#include <Eigen/Core>
#include <vector>

namespace chebnet {

/// A linear condition Σ coefficient · x_variable = 0 on integers.
struct IntegerCondition {
    struct Entry {
        int variable, coefficient;
    };
    std::vector<Entry> entries;
};

/// A basis of all integer solutions x, its columns: x = N y, and every integer y gives one. By Euclid's algorithm on
/// the columns (Cohen, A Course in Computational Algebraic Number Theory, 1993, section 2.4).
Eigen::MatrixXi integer_null_space(int variables, const std::vector<IntegerCondition>& conditions);

/// Integers y with a small ½ yᵀ A y + bᵀ y, for A symmetric and positive definite: the one nearest to its best value is
/// rounded and the best values of the others are reckoned anew, until none is left (Bommes, Zimmer & Kobbelt,
/// Mixed-Integer Quadrangulation, 2009); then single ones and pairs are changed by 1 as long as that helps.
Eigen::VectorXi nearest_integers(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace chebnet
