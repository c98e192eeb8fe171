#include "remesh/field_cut.h"

namespace chebnet {

FieldCut::FieldCut(const Surface& surface, const DirectionField& field) : m_surface(surface), m_field(field) {
    comb();
    prune();
    find_branches();
}

std::vector<ShiftTerm> FieldCut::shift(int side) const {
    if (m_branch[side] < 0) return {};
    if (m_is_along[side]) return {{m_branch[side], 0, 1}};
    return {{m_branch[side], m_turns[side], -1}};
}

void FieldCut::comb() {
    const int faces = m_surface.face_count();
    m_face_turns.assign(static_cast<std::size_t>(faces), -1);
    m_is_cut.assign(3 * static_cast<std::size_t>(faces), true);
    std::vector<int> queue;
    for (int seed = 0; seed < faces; ++seed) {
        if (m_face_turns[seed] >= 0) continue;
        m_face_turns[seed] = 0;
        queue.assign(1, seed);
        for (std::size_t k = 0; k < queue.size(); ++k)
            for (int s = 3 * queue[k]; s < 3 * queue[k] + 3; ++s) {
                const int other = m_surface.opposite(s);
                if (other < 0 || m_face_turns[Surface::face_of(other)] >= 0) continue;
                m_face_turns[Surface::face_of(other)] = (m_face_turns[queue[k]] + m_field.turns[s]) % 4;
                m_is_cut[s] = m_is_cut[other] = false;
                queue.push_back(Surface::face_of(other));
            }
    }
    m_turns.resize(m_is_cut.size());
    for (int s = 0; s < static_cast<int>(m_turns.size()); ++s) {
        const int other = m_surface.opposite(s);
        if (other < 0) continue;
        const int here = m_face_turns[Surface::face_of(s)], there = m_face_turns[Surface::face_of(other)];
        m_turns[s] = (m_field.turns[s] + here - there + 4) % 4;
    }
}

/// Cuts that end at a regular vertex are closed again.
void FieldCut::prune() {
    m_degree.assign(static_cast<std::size_t>(m_surface.vertex_count()), 0);
    for (int s = 0; s < static_cast<int>(m_is_cut.size()); ++s)
        if (m_is_cut[s] && m_surface.opposite(s) >= 0) ++m_degree[m_surface.from(s)];
    std::vector<int> ends;
    for (int v = 0; v < m_surface.vertex_count(); ++v)
        if (is_loose(v)) ends.push_back(v);
    while (!ends.empty()) {
        const int v = ends.back();
        ends.pop_back();
        if (!is_loose(v)) continue;
        const int s = next_cut(m_surface.first_side(v));
        m_is_cut[s] = m_is_cut[m_surface.opposite(s)] = false;
        --m_degree[v];
        --m_degree[m_surface.to(s)];
        if (is_loose(m_surface.to(s))) ends.push_back(m_surface.to(s));
    }
}

bool FieldCut::is_loose(int v) const {
    return m_degree[v] == 1 && m_field.holonomy[v] == 0 && !m_surface.is_boundary(v);
}

bool FieldCut::is_node(int v) const { return m_degree[v] != 2 || m_field.holonomy[v] != 0 || m_surface.is_boundary(v); }

/// That begins where a side does, counterclockwise from it: at an inner vertex with one.
int FieldCut::next_cut(int side) const {
    while (!m_is_cut[side]) side = m_surface.around(side);
    return side;
}

void FieldCut::find_branches() {
    m_branch.assign(m_is_cut.size(), -1);
    m_is_along.assign(m_is_cut.size(), false);
    for (const bool from_nodes : {true, false})
        for (int s = 0; s < static_cast<int>(m_branch.size()); ++s)
            if (m_is_cut[s] && m_surface.opposite(s) >= 0 && m_branch[s] < 0 &&
                is_node(m_surface.from(s)) == from_nodes)
                follow(s);
}

void FieldCut::follow(int side) {
    for (int s = side; s >= 0 && m_branch[s] < 0;) {
        m_branch[s] = m_branch[m_surface.opposite(s)] = m_branches;
        m_is_along[s] = true;
        if (is_node(m_surface.to(s))) break;
        s = next_cut(m_surface.around(m_surface.opposite(s)));
    }
    ++m_branches;
}

}  // namespace chebnet
