#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace chebnet {

/// Options that several methods read, for MethodInfo::options.
///
/// When a descent has come to rest: has_settled().
inline constexpr std::array k_tolerances{"energy_tolerance", "gradient_tolerance"};
/// Of StagedDescent: the exponents of its stages, and the vertices of its last one.
inline constexpr std::array k_exponents{"p_start", "p_end", "adaptive_p", "switch_deviation"};
inline constexpr std::array k_reduction{"adaptive_reduction", "reduction_deviation", "active_fraction", "active_rings",
                                        "reduce_once"};

template <std::size_t... sizes>
constexpr auto joined(const std::array<const char*, sizes>&... lists) {
    std::array<const char*, (sizes + ...)> all{};
    auto end = all.begin();
    ((end = std::copy(lists.begin(), lists.end(), end)), ...);
    return all;
}

}  // namespace chebnet
