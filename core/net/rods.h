#pragma once

#include <optional>
#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// The lines that a rod is laid along, each a list of vertices: those of Topology::net_lines() that pass inward
/// corners, but for rims, the edges along a border that has cut the net. Where a rod and a rim are on one line the rod
/// ends. Which edges are of rods say rod_edges() for the length L that edges share (shared_length()). Where no length
/// is shared by most, a border may have cut most edges: L is then `length`, where it is known, or whole_length() if the
/// net is_cut(); else all lines are of rods.
std::vector<std::vector<int>> rods(const Net& net, const Topology& topology, std::optional<double> length = {});

/// E, where edges have length L but those that a border may have cut: whether each is of a rod, and not a rim, by
/// cell_sides(). All are between two faces.
std::vector<bool> rod_edges(const Net& net, const Topology& topology, double length);

/// Which of rods() end where they began, and go straight on there.
std::vector<bool> closed_rods(const Topology& topology, const std::vector<std::vector<int>>& rods);

/// L, the length of edges that no border has cut: that which most share (shared_length()) or, where a border has cut
/// most, that of the longest edge between two faces; of the longest at all where none is between two.
double whole_length(const Net& net);

/// Whether a border has cut the net: its edges share a length, but for some that end at the border, where some of its
/// faces are no quads, or lines of whole edges end with a shorter one. Where most are cut a quad is whole or, in a
/// narrow net, all edges that no border can have cut are, several, or rods cross at several places that no edge joins;
/// and none between two faces is longer.
bool is_cut(const Net& net, const Topology& topology);

}  // namespace chebnet
