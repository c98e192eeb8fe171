#pragma once

#include <Eigen/Core>

namespace chebnet {

/// Calls visit(weights) for the middles of the n² equal pieces into which a triangle is cut, by barycentric weights.
template <class Visit>
void for_each_middle(int n, Visit visit) {
    const auto visit_at = [&](double u, double v) { visit(Eigen::Vector3d(1 - (u + v) / n, u / n, v / n)); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; i + j < n; ++j) {
            visit_at(i + 1. / 3, j + 1. / 3);
            if (i + j + 1 < n) visit_at(i + 2. / 3, j + 2. / 3);
        }
}

}  // namespace chebnet
