#include "drape/border_cut.h"

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <utility>

#include "drape/draped_net.h"
#include "surface/height.h"

namespace chebnet {

namespace {

// Halves the edge that is cut until no digit is left.
constexpr int k_halvings = 52;
// In edge lengths: what is nearer to each other is one point.
constexpr double k_point = 1e-9;

class Cutter {
public:
    Cutter(const Compass& compass, double smallest_angle, const std::vector<DrapedVertex>& vertices)
        : m_compass(compass),
          m_stub(k_shortest_end * compass.length()),
          m_largest_cosine(largest_cosine(smallest_angle)),
          m_vertices(vertices) {}

    BorderCut run(const std::vector<std::array<int, 4>>& cells) {
        for (const auto& cell : cells) {
            std::vector<int> face = cut(cell);
            if (face.size() < 3 || has_point_edge(face) || (face.size() == 4 && is_sharp(face))) continue;
            m_cut.faces.push_back(std::move(face));
        }
        m_cut.faces = joined_to_seed(m_cut.faces);
        return std::move(m_cut);
    }

private:
    bool is_kept(int vertex) const { return m_vertices[vertex].overhang <= m_stub; }

    /// The corners of what is left of a cell; none where one of its rods has no end.
    std::vector<int> cut(const std::array<int, 4>& cell) {
        std::vector<int> face;
        const auto add = [&](int vertex) {
            if (face.empty() || face.back() != vertex) face.push_back(vertex);
        };
        for (std::size_t k = 0; k < 4; ++k) {
            const int from = cell[k], to = cell[(k + 1) % 4];
            if (is_kept(from)) add(from);
            if (is_kept(from) == is_kept(to)) continue;
            const int end = is_kept(from) ? end_of(from, to) : end_of(to, from);
            if (end < 0) return {};
            add(end);
        }
        while (face.size() > 1 && face.front() == face.back()) face.pop_back();
        return face;
    }

    /// Of a rod from a vertex that is kept to one that is not; −1 where the border is farther away than that one, as
    /// past a slit on the other side of which it stands.
    int end_of(int kept, int beyond) {
        const auto [known, is_new] = m_end_at.try_emplace(std::minmax(kept, beyond), kept);
        if (!is_new || m_vertices[kept].overhang > 0) return known->second;
        const DrapedVertex end = on_boundary(m_vertices[kept], m_vertices[beyond]);
        const double length = (end.position - m_vertices[kept].position).norm();
        if (length < m_stub) return kept;
        if (length > m_compass.length() + m_compass.tolerance()) return known->second = -1;
        known->second = static_cast<int>(m_vertices.size() + m_cut.ends.size());
        m_cut.ends.push_back({end, beyond});
        return known->second;
    }

    /// The point of the boundary nearest to where the straight way from a vertex to one beyond it leaves the surface.
    DrapedVertex on_boundary(const DrapedVertex& from, const DrapedVertex& beyond) const {
        double inside = 0, outside = 1;
        // What is beyond a slit may not be so as seen from another vertex, past the slit's end.
        Height left{0, beyond.overhang, beyond.normal, beyond.at};
        for (int k = 0; k <= k_halvings; ++k) {
            const double part = k == 0 ? 1 : (inside + outside) / 2;
            const Height here = m_compass.height((1 - part) * from.position + part * beyond.position, from.at.face);
            if (here.overhang > 0) {
                outside = part;
                left = here;
            } else {
                inside = part;
            }
        }
        return {m_compass.surface().position_at(left.at), left.at, left.normal, 0};
    }

    /// Rods that end in the same corner of the boundary.
    bool has_point_edge(const std::vector<int>& face) const {
        for (std::size_t k = 0; k < face.size(); ++k)
            if ((position(face[k]) - position(face[(k + 1) % face.size()])).norm() < k_point * m_compass.length())
                return true;
        return false;
    }

    bool is_sharp(const std::vector<int>& face) const {
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Eigen::Vector3d here = position(face[k]);
            const Eigen::Vector3d a = position(face[(k + 1) % face.size()]) - here,
                                  b = position(face[(k + face.size() - 1) % face.size()]) - here;
            if (a.dot(b) > m_largest_cosine * a.norm() * b.norm()) return true;
        }
        return false;
    }

    const Eigen::Vector3d& position(int vertex) const {
        const int given = static_cast<int>(m_vertices.size());
        return vertex < given ? m_vertices[vertex].position : m_cut.ends[vertex - given].vertex.position;
    }

    const Compass& m_compass;
    double m_stub, m_largest_cosine;
    const std::vector<DrapedVertex>& m_vertices;
    std::map<std::pair<int, int>, int> m_end_at;  // of a rod, by the edge that it is a part of
    BorderCut m_cut;
};

}  // namespace

BorderCut cut_at_border(const Compass& compass, double smallest_angle, const std::vector<DrapedVertex>& vertices,
                        const std::vector<std::array<int, 4>>& cells) {
    return Cutter(compass, smallest_angle, vertices).run(cells);
}

}  // namespace chebnet
