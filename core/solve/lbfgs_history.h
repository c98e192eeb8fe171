#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace chebnet {

/// The two-loop recursion of L-BFGS (Nocedal 1980; Liu & Nocedal 1989) for 3×n unknowns: what the last moves have told
/// about the curvature. Allocates only while it fills for the first time.
class LbfgsHistory {
public:
    explicit LbfgsHistory(std::size_t memory) : m_memory(memory) {}

    bool empty() const { return m_count == 0; }
    void clear() { m_count = 0; }

    /// Learns from a move and the change of the gradient along it. A pair without clearly positive curvature would
    /// spoil the positive definiteness of the whole and is left out.
    void learn(const Eigen::Matrix3Xd& move, const Eigen::Matrix3Xd& gradient_change);

    /// Turns minus the gradient into a direction, in place. `initial_inverse(direction)` applies the first guess of the
    /// inverse Hessian, in place.
    template <typename InitialInverse>
    void apply(Eigen::Matrix3Xd& direction, InitialInverse initial_inverse) {
        for (std::size_t k = m_count; k-- > 0;) {
            Correction& c = correction(k);
            c.alpha = dot(c.s, direction) / c.sy;
            direction -= c.alpha * c.y;
        }
        initial_inverse(direction);
        for (std::size_t k = 0; k < m_count; ++k) {
            const Correction& c = correction(k);
            direction += (c.alpha - dot(c.y, direction) / c.sy) * c.s;
        }
    }

    /// sᵀy / yᵀy of the latest pair, the usual scale of an initial inverse that is a multiple of the identity.
    double latest_scale() { return correction(m_count - 1).sy / correction(m_count - 1).y.squaredNorm(); }

private:
    struct Correction {
        Eigen::Matrix3Xd s, y;  // change of the positions, of the gradient
        double sy = 0;          // their product, positive
        double alpha = 0;       // of the recursion under way
    };
    static double dot(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }
    /// k = 0: the oldest kept.
    Correction& correction(std::size_t k) { return m_ring[(m_first + k) % m_memory]; }

    std::size_t m_memory;
    std::vector<Correction> m_ring;
    std::size_t m_first = 0, m_count = 0;
};

}  // namespace chebnet
