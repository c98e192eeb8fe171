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

/// E, where edges have length L but those that a border may have cut: whether each is of a rod. All are between two
/// faces. On the boundary one of length L is of a rod, unless it leads across a cell from the end of one cut rod to
/// that of another; one of another length is of a rim, unless it goes on straight from a rod, of which it is then what
/// a border left of the last edge.
std::vector<bool> rod_edges(const Net& net, const Topology& topology, double length);

/// Which of rods() end where they began, and go straight on there.
std::vector<bool> closed_rods(const Topology& topology, const std::vector<std::vector<int>>& rods);

/// L, the length of edges that no border has cut: that which most share (shared_length()) or, where a border has cut
/// most, that of the longest edge between two faces; of the longest at all where none is between two.
double whole_length(const Net& net);

/// How far whole edges are from the length `shared` with others, as a part of it, by those that no border can have cut
/// or, where each may be cut, by those that are nearly as long: a ten-thousandth where a net was laid, up to
/// k_whole_edge where it was edited. What a border cuts off may be less.
double whole_edge_tolerance(const Net& net, const Topology& topology, double shared);

/// Whether a border has cut the net: its edges share a length, but for some that end at the border, where some of its
/// faces are no quads, or lines of whole edges end with a shorter one. Where most are cut, a quad is whole.
bool is_cut(const Net& net, const Topology& topology);

}  // namespace chebnet
