#pragma once

#include <numeric>
#include <vector>

namespace chebnet {

/// Things that are joined to sets, two sets at a time (Tarjan 1975).
class Sets {
public:
    explicit Sets(int count) : m_parent(static_cast<std::size_t>(count)) {
        std::iota(m_parent.begin(), m_parent.end(), 0);
    }

    /// The same for all of one set: its smallest.
    int of(int thing) {
        while (m_parent[thing] != thing) thing = m_parent[thing] = m_parent[m_parent[thing]];
        return thing;
    }

    void join(int a, int b) {
        const int first = of(a), second = of(b);
        m_parent[first < second ? second : first] = first < second ? first : second;
    }

private:
    std::vector<int> m_parent;
};

}  // namespace chebnet
