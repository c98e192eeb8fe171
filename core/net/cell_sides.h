#pragma once

#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// A side of a face that is of no rod: a rim, where a border has cut across a cell.
inline constexpr int k_rim = -1;

/// How faces lie in square cells of which a border may have cut off a part; a face then has the corners of its cell
/// that are left, and the ends of rods that were cut, and between these rims. For each corner of each face, in the
/// order of Faces::vertices: on which side of its cell, 0 to 3 as they follow each other there, lies the face's side
/// from there to the next corner; or k_rim. Numbers of one face do not compare with those of another.
///
/// `length`: L, of edges that no border has cut. Sides between two faces are of rods. Of the others a rod is never
/// longer than L, and shorter only if it ends at the border; between two rods it is whole. Where that leaves several
/// ways to read a face, that is taken which has no rim as long as L, and whose rods go on straightest from those in the
/// face beside it, or are at the squarest corner where there is none; and one with two rims, as where two opposite
/// corners of a cell are left, only if another would bend a rod by more than 45°.
/// Where a net is but one cell wide nothing tells rims as long as L from rods, which they are then taken for. A face
/// that is nothing of the kind: the sides of a quad, or else those between faces as far as they follow each other, and
/// of the others what is as long as L.
std::vector<int> cell_sides(const Net& net, const Topology& topology, double length);

/// V, where faces lie so: the corners of cells, for certain. The end of a rod has no other edge between two faces.
std::vector<bool> corners_of_cells(const Net& net);

/// How far whole edges are from the length L with others, as a part of it, by those that no border can have cut or,
/// where each may be cut, by those that are nearly as long: a billionth where a net was laid, up to k_whole_edge where
/// it was edited.
double whole_edge_tolerance(const Net& net, double length);

}  // namespace chebnet
