#pragma once

#include <cstddef>
#include <string>

#include "base/error.h"

namespace chebnet {

/// No factor is made that would take more memory than this, so that it is refused before what cannot be had is asked
/// for: WebAssembly has 2 GB for all that a page holds.
inline constexpr std::size_t k_most_factor_bytes = sizeof(void*) < 8 ? std::size_t{512} << 20 : std::size_t{1} << 32;

/// Throws Error too_large, which names both sizes. `unknowns`: of the system. `bytes`: what it is going to take.
inline void check_factor_bytes(int unknowns, double bytes) {
    if (bytes <= static_cast<double>(k_most_factor_bytes)) return;
    const auto megabytes = [](double b) { return std::to_string(static_cast<long long>(b / (1 << 20))) + " MB"; };
    throw Error(ErrorCode::too_large, "the factor of a system of " + std::to_string(unknowns) +
                                          " unknowns would take " + megabytes(bytes) + ", the most allowed is " +
                                          megabytes(static_cast<double>(k_most_factor_bytes)));
}

}  // namespace chebnet
