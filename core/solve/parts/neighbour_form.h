#pragma once

#include <vector>

#include "solve/parts/neighbour_pairs.h"
#include "solve/terms/term.h"

namespace chebnet {

/// A quadratic form that joins neighbours and vertices with a common neighbour. Keeps a reference to the pairs.
class NeighbourForm : public QuadraticForm {
public:
    NeighbourForm(const NeighbourPairs& pairs, int vertex_count)
        : m_pairs(pairs), m_weights(pairs.size(), 0), m_vertex_weights(static_cast<std::size_t>(vertex_count), 0) {}

    void set_zero() {
        m_weights.assign(m_weights.size(), 0);
        m_vertex_weights.assign(m_vertex_weights.size(), 0);
    }
    void add_link(int a, int b, double weight) override { m_weights[m_pairs.find(a, b)] += weight; }
    void add_vertex(int vertex, double weight) override { m_vertex_weights[vertex] += weight; }

    double weight(std::size_t pair) const { return m_weights[pair]; }
    double vertex_weight(int vertex) const { return m_vertex_weights[vertex]; }

private:
    const NeighbourPairs& m_pairs;
    std::vector<double> m_weights, m_vertex_weights;
};

}  // namespace chebnet
