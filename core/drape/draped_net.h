#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "drape/border_cut.h"
#include "drape/drape.h"

namespace chebnet {

/// Whether no corner of a cell is sharper than an angle with this cosine, nor blunter than π less it.
bool keeps_limit(const std::array<Eigen::Vector3d, 4>& cell, double largest_cosine);

/// The faces that are joined by edges to the first one with vertex 0, the seed.
std::vector<std::vector<int>> joined_to_seed(const std::vector<std::vector<int>>& faces);

/// The net of what a border has left, without the vertices that no face has. `places`: of the vertices. Throws Error
/// bad_option if no face is left.
Drape draped_net(const std::vector<DrapedVertex>& vertices, const Eigen::Matrix2Xi& places, const BorderCut& cut);

}  // namespace chebnet
