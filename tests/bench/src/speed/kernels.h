#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "net/net.h"

namespace chebnet::bench {

/// One numeric factorisation that can be repeated: one of the project's linear systems by one of the solvers.
struct Kernel {
    std::string system;  ///< "block" (3V×3V), "lengths" (E×E) or "laplacian" (V×V)
    std::string solver;  ///< "chebnet", "eigen" (SimplicialLDLT, AMD) or "cholmod" (supernodal)
    int rows;
    double residual;  ///< ‖Ax − b‖ / ‖b‖ of a solution: what the factor is worth
    std::function<void()> factorize;
};

/// The systems of a net at rest with some vertices held, each by every solver, already analysed and factored once.
/// Reads and writes nothing: it serves both targets.
std::vector<Kernel> make_kernels(const Net& net, std::span<const int> handle_vertices);

}  // namespace chebnet::bench
