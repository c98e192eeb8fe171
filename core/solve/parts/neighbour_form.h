#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/terms/term.h"

namespace chebnet {

/// A quadratic form on the pairs of vertices that are neighbours or have a common neighbour.
class NeighbourForm : public QuadraticForm {
public:
    NeighbourForm(const Net& net, const Topology& topology) {
        std::vector<std::array<int, 2>> pairs;
        for (int v = 0; v < net.vertex_count(); ++v) {
            const std::span<const int> around = topology.neighbours(v);
            for (std::size_t i = 0; i < around.size(); ++i) {
                if (v < around[i]) pairs.push_back({v, around[i]});
                for (std::size_t j = i + 1; j < around.size(); ++j) pairs.push_back({around[i], around[j]});
            }
        }
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        m_pairs = std::move(pairs);
        m_first.assign(static_cast<std::size_t>(net.vertex_count()) + 1, 0);
        for (const auto& [a, b] : m_pairs) ++m_first[a + 1];
        for (std::size_t v = 1; v < m_first.size(); ++v) m_first[v] += m_first[v - 1];
        set_zero();
    }

    void set_zero() {
        m_weights.assign(m_pairs.size(), 0);
        m_vertex_weights.assign(m_first.size() - 1, 0);
    }
    void add_link(int a, int b, double weight) override {
        const std::array<int, 2> pair{std::min(a, b), std::max(a, b)};
        const auto found =
            std::lower_bound(m_pairs.begin() + m_first[pair[0]], m_pairs.begin() + m_first[pair[0] + 1], pair);
        m_weights[found - m_pairs.begin()] += weight;
    }
    void add_vertex(int vertex, double weight) override { m_vertex_weights[vertex] += weight; }

    const std::vector<std::array<int, 2>>& pairs() const { return m_pairs; }
    double weight(std::size_t pair) const { return m_weights[pair]; }
    double vertex_weight(int vertex) const { return m_vertex_weights[vertex]; }

private:
    std::vector<std::array<int, 2>> m_pairs;  // sorted
    std::vector<int> m_first;                 // V + 1, into the pairs, by their smaller vertex
    std::vector<double> m_weights, m_vertex_weights;
};

}  // namespace chebnet
