#include "remesh/rows.h"

#include <algorithm>
#include <array>
#include <queue>
#include <utility>

namespace chebnet {

namespace {

/// A quad with a side for its bottom: a row runs to the right.
struct Placed {
    int face = -1, bottom = 0;
};

class RowWalk {
public:
    explicit RowWalk(const Faces& quads)
        : m_quads(quads), m_opposite(opposite_sides(quads)), m_is_walked(static_cast<std::size_t>(quads.size())) {}

    /// All quads, each as it is passed.
    std::vector<Placed> run() {
        for (int f = 0; f < m_quads.size(); ++f) {
            m_next.push({f, 0});
            // A row that crosses itself is walked in pieces, of which the first need not come as far as this quad.
            for (; !m_next.empty(); m_next.pop())
                while (!m_is_walked[m_next.front().face]) walk_row(beginning(m_next.front()));
        }
        return std::move(m_order);
    }

private:
    /// By side 4 f + k, from corner k to corner k + 1 of face f: the side beyond it; −1: none.
    static std::vector<int> opposite_sides(const Faces& quads) {
        std::vector<std::array<int, 3>> sides;  // the ends, the smaller one first, and the side
        for (int f = 0; f < quads.size(); ++f)
            for (int k = 0; k < 4; ++k) {
                const auto [a, b] = std::minmax(quads[f][k], quads[f][(k + 1) % 4]);
                sides.push_back({a, b, 4 * f + k});
            }
        std::sort(sides.begin(), sides.end());
        std::vector<int> opposite(sides.size(), -1);
        for (std::size_t i = 1; i < sides.size(); ++i) {
            const auto& [a, b, side] = sides[i];
            const auto& [c, d, other] = sides[i - 1];
            if (a != c || b != d) continue;
            opposite[side] = other;
            opposite[other] = side;
        }
        return opposite;
    }

    /// The next quad by the side that is `turn` sides after the bottom, with its bottom where that of this one is; none
    /// that is walked already.
    Placed beside(const Placed& from, int turn) const {
        const int side = m_opposite[4 * from.face + (from.bottom + turn) % 4];
        if (side < 0 || m_is_walked[side / 4]) return {};
        return {side / 4, (side + 6 - turn) % 4};
    }

    Placed beginning(const Placed& start) const {
        Placed first = start;
        for (Placed left = beside(first, 3); left.face >= 0 && left.face != start.face; left = beside(first, 3))
            first = left;
        return first;
    }

    void walk_row(Placed quad) {
        const std::size_t first = m_order.size();
        for (; quad.face >= 0; quad = beside(quad, 1)) {
            m_is_walked[quad.face] = true;
            m_order.push_back(quad);
        }
        for (const int turn : {2, 0})
            for (std::size_t i = first; i < m_order.size(); ++i)
                if (const Placed next = beside(m_order[i], turn); next.face >= 0) m_next.push(next);
    }

    const Faces& m_quads;
    std::vector<int> m_opposite;
    std::vector<bool> m_is_walked;
    std::queue<Placed> m_next;  // of the rows beside those walked, to go on with
    std::vector<Placed> m_order;
};

}  // namespace

Mesh in_rows(const Mesh& quads) {
    Mesh result{Positions(3, quads.positions.cols()), {}};
    std::vector<int> numbers(static_cast<std::size_t>(quads.positions.cols()), -1);
    int count = 0;
    for (const auto& [face, bottom] : RowWalk(quads.faces).run()) {
        std::array<int, 4> corners{};
        // Those of the row before come first, as they do already.
        for (const int k : {0, 1, 3, 2}) {
            const int vertex = quads.faces[face][(bottom + k) % 4];
            int& number = numbers[vertex];
            if (number < 0) {
                number = count++;
                result.positions.col(number) = quads.positions.col(vertex);
            }
            corners[k] = number;
        }
        result.faces.add(corners);
    }
    return result;
}

}  // namespace chebnet
