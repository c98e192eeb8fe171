#include "solve/parts/held_vertices.h"

#include <algorithm>

namespace chebnet {

HeldVertices::HeldVertices(int vertex_count, std::span<const int> fixed, std::span<const Slide> slides)
    : m_vertices(fixed.begin(), fixed.end()), m_free_axes(static_cast<std::size_t>(vertex_count), k_all_axes) {
    for (int v : fixed) m_free_axes[v] = k_no_axes;
    for (const Slide& slide : slides) {
        m_vertices.push_back(slide.vertex);
        m_free_axes[slide.vertex] = slide.along;
    }
}

void HeldVertices::take_held(const Positions& from, Positions& to) const {
    for (int v : m_vertices) copy_along(k_all_axes - m_free_axes[v], from.col(v).data(), to.col(v).data());
}

void HeldVertices::take_free(int vertex, const Eigen::Vector3d& from, Positions& to) const {
    copy_along(m_free_axes[vertex], from.data(), to.col(vertex).data());
}

bool HeldVertices::stands_the_same(int vertex, const Positions& a, const Positions& b) const {
    const Axes held = k_all_axes - m_free_axes[vertex];
    return across(held, a.col(vertex)) == across(held, b.col(vertex));
}

double HeldVertices::farthest(const Positions& from, const Positions& to) const {
    double farthest = 0;
    for (int v : m_vertices) farthest = std::max(farthest, held_part(v, to.col(v) - from.col(v)).norm());
    return farthest;
}

}  // namespace chebnet
