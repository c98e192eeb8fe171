#include "drape/opened_corners.h"

#include <memory>
#include <vector>

#include "net/topology.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/length_projection.h"
#include "surface/height.h"

namespace chebnet {

namespace {

// Rounds of one projection onto each; then lengths and corners are made exact, and the net comes no nearer.
constexpr int k_rounds = 20, k_most_exact_rounds = 30, k_most_projections = 10;
// Of the way to the surface, in a round: all of it would fold what is far off.
constexpr double k_approach = 0.5;
// Of a length: exact.
constexpr double k_exact_error = 1e-11;
// Radians, by which corners are opened too far: more than CornerLimit::k_tolerance takes off again.
constexpr double k_margin = 3e-4;

/// About the net's middle and in its own unit, so that lengths become exact wherever the surface is, and however large.
class CornerOpening {
public:
    CornerOpening(const Net& net, const Guide& guide, double smallest_angle)
        : m_middle(net.rest_positions().rowwise().mean()),
          m_unit(net.unit()),
          m_net(net.scaled(1 / m_unit)),
          m_topology(m_net),
          m_guide(guide),
          m_limit(m_net, smallest_angle + k_margin),
          m_positions((net.rest_positions().colwise() - m_middle) / m_unit),
          m_faces(static_cast<std::size_t>(net.vertex_count()), 0) {
        watch();
    }

    bool run() {
        for (int round = 0; round < k_rounds; ++round) {
            m_limit.set_held(std::vector<double>(m_limit.held().size(), 0.0));
            approach_surface();
            hold_sharp_corners();
            if (!m_lengths->project(m_positions)) return false;
        }
        for (int round = 0; round < k_most_exact_rounds; ++round) {
            const bool is_open = !hold_sharp_corners();
            if (make_exact() && is_open) return true;
        }
        return false;
    }

    Positions positions() const { return (m_unit * m_positions).colwise() + m_middle; }

private:
    void watch() {
        m_limit.watch(m_positions);
        m_lengths = std::make_unique<LengthProjection>(m_net, m_topology, m_limit.watched());
        m_lengths->set_free(std::vector<bool>(static_cast<std::size_t>(m_net.vertex_count()), true));
    }

    void approach_surface() {
        for (int v = 0; v < m_positions.cols(); ++v) {
            const Eigen::Vector3d point = m_middle + m_unit * m_positions.col(v);
            const Offset offset = offset_of(m_guide.surface(), m_guide.tree(), point, m_faces[v]);
            m_faces[v] = offset.face;
            m_positions.col(v) -= k_approach / m_unit * offset.away;
        }
    }

    /// Whether there are more of them than before.
    bool hold_sharp_corners() {
        if (m_limit.needs_more_rows(m_positions)) watch();
        const int changed = m_limit.hold_short_ones(m_positions);
        m_limit.apply(m_lengths->system());
        return changed > 0;
    }

    bool make_exact() {
        LengthSystem& system = m_lengths->system();
        for (int k = 0; k < k_most_projections && m_lengths->project(m_positions); ++k) {
            system.assemble(m_positions);
            if (system.errors().lpNorm<Eigen::Infinity>() < k_exact_error) return true;
        }
        return false;
    }

    Eigen::Vector3d m_middle;
    double m_unit;
    Net m_net;
    Topology m_topology;
    const Guide& m_guide;
    CornerLimit m_limit;
    std::unique_ptr<LengthProjection> m_lengths;
    Positions m_positions;
    std::vector<int> m_faces;  // of each vertex a triangle near it
};

}  // namespace

std::optional<Positions> with_opened_corners(const Net& net, const Guide& guide, double smallest_angle) {
    CornerOpening opening(net, guide, smallest_angle);
    if (!opening.run()) return std::nullopt;
    return opening.positions();
}

}  // namespace chebnet
