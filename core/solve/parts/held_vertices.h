#pragma once

#include <span>
#include <vector>

#include "net/net.h"
#include "solve/slide.h"

namespace chebnet {

/// What of a net the handles hold: all of a fixed vertex, and of one that slides the coordinates that it keeps. The
/// rest of it is free.
class HeldVertices {
public:
    HeldVertices() = default;
    HeldVertices(int vertex_count, std::span<const int> fixed, std::span<const Slide> slides);

    /// The fixed ones first.
    const std::vector<int>& vertices() const { return m_vertices; }
    bool is_fixed(int vertex) const { return m_free_axes[vertex] == k_no_axes; }
    /// What of a vertex's move is the handles' to say.
    Eigen::Vector3d held_part(int vertex, const Eigen::Vector3d& move) const {
        return across(m_free_axes[vertex], move);
    }

    void take_held(const Positions& from, Positions& to) const;
    void take_free(int vertex, const Eigen::Vector3d& from, Positions& to) const;
    /// Whether a vertex stands in two states in the same place, as far as it is free.
    bool stands_the_same(int vertex, const Positions& a, const Positions& b) const;
    /// The farthest that what is held of a vertex has to go.
    double farthest(const Positions& from, const Positions& to) const;

private:
    std::vector<int> m_vertices;
    std::vector<Axes> m_free_axes;  // V
};

}  // namespace chebnet
