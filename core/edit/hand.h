#pragma once

#include <vector>

#include "solve/slide.h"

namespace chebnet {

/// Exact handles on their way to their targets: whose hand they are in, and how that holds them meanwhile.
class Hand {
public:
    enum class Owner {
        nobody,
        user,
        released,  ///< the user's, who has let go: empty once the solve under way, or the next, has ended
        solve,     ///< draws them step by step
    };

    /// Empty, of a net of so many vertices.
    explicit Hand(int vertex_count) : m_holds(static_cast<std::size_t>(vertex_count), false) {}

    Owner owner() const { return m_owner; }
    bool is_empty() const { return m_vertices.empty(); }
    const std::vector<int>& vertices() const { return m_vertices; }
    bool holds(int vertex) const { return m_holds[vertex]; }
    /// The axes to which it is kept, where it is the user's.
    Axes along() const { return m_along; }
    /// Whether what is in it is pulled towards its targets, rather than held at them.
    bool holds_back() const { return m_holds_back; }
    /// Whether what was held back has come near its targets and has been held there again.
    bool has_held_again() const { return m_has_held_again; }

    /// False if it has the vertex already.
    bool take(int vertex, Owner owner) {
        m_owner = owner;
        if (m_holds[vertex]) return false;
        m_vertices.push_back(vertex);
        m_holds[vertex] = true;
        return true;
    }
    void release() {
        if (m_owner == Owner::user) m_owner = Owner::released;
    }
    void keep_to(Axes along) { m_along = along; }
    void hold_back(bool on) { m_holds_back = on; }
    void hold_again(bool on) { m_has_held_again = on; }
    void empty() {
        for (int vertex : m_vertices) m_holds[vertex] = false;
        m_vertices.clear();
        m_owner = Owner::nobody;
        m_along = k_all_axes;
        m_holds_back = m_has_held_again = false;
    }

private:
    Owner m_owner = Owner::nobody;
    std::vector<int> m_vertices;
    std::vector<bool> m_holds;  // V
    Axes m_along = k_all_axes;
    bool m_holds_back = false, m_has_held_again = false;
};

}  // namespace chebnet
