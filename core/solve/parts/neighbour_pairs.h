#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/valence_limit.h"

namespace chebnet {

/// The pairs of vertices that are neighbours or have a common neighbour: what the Hessian of a bending energy joins.
class NeighbourPairs {
public:
    /// Throws Error too_large where too many meet at a vertex, see check_valences().
    NeighbourPairs(const Net& net, const Topology& topology) {
        check_valences(net, topology, 3);
        for (int v = 0; v < net.vertex_count(); ++v) {
            const std::span<const int> around = topology.neighbours(v);
            for (std::size_t i = 0; i < around.size(); ++i) {
                if (v < around[i]) m_pairs.push_back({v, around[i]});
                for (std::size_t j = i + 1; j < around.size(); ++j) m_pairs.push_back({around[i], around[j]});
            }
        }
        std::sort(m_pairs.begin(), m_pairs.end());
        m_pairs.erase(std::unique(m_pairs.begin(), m_pairs.end()), m_pairs.end());
        m_first.assign(static_cast<std::size_t>(net.vertex_count()) + 1, 0);
        for (const auto& [a, b] : m_pairs) ++m_first[a + 1];
        for (std::size_t v = 1; v < m_first.size(); ++v) m_first[v] += m_first[v - 1];
    }

    std::size_t size() const { return m_pairs.size(); }
    /// Ascending, the smaller vertex first.
    const std::array<int, 2>& operator[](std::size_t pair) const { return m_pairs[pair]; }
    /// The number of the pair of two vertices, which must be one.
    std::size_t find(int a, int b) const {
        const std::array<int, 2> pair{std::min(a, b), std::max(a, b)};
        const auto begin = m_pairs.begin();
        return static_cast<std::size_t>(std::lower_bound(begin + m_first[pair[0]], begin + m_first[pair[0] + 1], pair) -
                                        begin);
    }

private:
    std::vector<std::array<int, 2>> m_pairs;
    std::vector<int> m_first;  // V + 1, into the pairs, by their smaller vertex
};

}  // namespace chebnet
