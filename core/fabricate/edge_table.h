#pragma once

#include <string>

#include "net/net.h"

namespace chebnet {

/// The edges of a net as CSV, for cutting rods or checking lengths: the line
/// "edge,vertex_a,vertex_b,length,rest_length,deviation", with ",force" behind it if `forces` are given (E), then one
/// for each edge in the order of Net::edges, all counted from 0. Length and deviation dL (net/measures.h) are those at
/// `positions` (3×V). Each number has as many digits, 15 to 17, as bring it back exactly.
std::string edge_table(const Net& net, const Positions& positions, const Eigen::VectorXd& forces = {});

}  // namespace chebnet
