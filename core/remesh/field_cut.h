#pragma once

#include <vector>

#include "remesh/direction_field.h"
#include "surface/surface.h"

namespace chebnet {

/// ± J^turns T of a branch's translation T, where J is a quarter turn.
struct ShiftTerm {
    int branch, turns, sign;
};

/// A surface cut open along edges, so that a field on it has no turns but across the cut, and coordinates that follow
/// the field are one map of the plane on the rest. A branch is a walk of cut edges with the same transition, which ends
/// where others meet it, at a singular vertex or at the boundary.
class FieldCut {
public:
    /// Both have to outlive it.
    FieldCut(const Surface& surface, const DirectionField& field);

    /// Of each triangle, by how many quarter turns its direction is turned so that those beside each other agree.
    const std::vector<int>& face_turns() const { return m_face_turns; }
    int branch_count() const { return m_branches; }
    /// Beyond a side coordinates are turned by so many quarter turns; 0 where it is not cut, or on the boundary.
    int turns(int side) const { return m_turns[side]; }
    /// What is added to them there after the turn; nothing likewise.
    std::vector<ShiftTerm> shift(int side) const;

private:
    void comb();
    void prune();
    bool is_loose(int v) const;
    bool is_node(int v) const;
    int next_cut(int side) const;
    void find_branches();
    void follow(int side);

    const Surface& m_surface;
    const DirectionField& m_field;
    std::vector<int> m_face_turns, m_turns;
    std::vector<bool> m_is_cut;    // of each side; those on the boundary are, too
    std::vector<int> m_degree;     // of each vertex: cut edges inside of the surface
    std::vector<int> m_branch;     // of each side, −1 if it is of none
    std::vector<bool> m_is_along;  // of each side: its branch goes along it, not along its opposite
    int m_branches = 0;
};

}  // namespace chebnet
