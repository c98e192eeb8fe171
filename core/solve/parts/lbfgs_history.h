#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include "linear/dense_kernels.h"

namespace chebnet {

/// The two-loop recursion of L-BFGS (Nocedal 1980; Liu & Nocedal 1989): what the last moves have told about the
/// curvature. `Vectors` holds the unknowns, a column of each node's: Eigen::Matrix3Xd, or Eigen::Matrix4Xf where single
/// precision is enough for a direction. Allocates only while it fills for the first time.
template <typename Vectors>
class LbfgsHistory {
public:
    explicit LbfgsHistory(std::size_t memory) : m_memory(memory) {}

    bool empty() const { return m_count == 0; }
    void clear() { m_count = 0; }

    /// Learns from a move and the change of the gradient along it. A pair without clearly positive curvature would
    /// spoil the positive definiteness of the whole and is left out.
    void learn(const Vectors& move, const Vectors& gradient_change) {
        const double sy = dot(move, gradient_change);
        const double sizes = std::sqrt(dot(move, move) * dot(gradient_change, gradient_change));
        if (!(sy > k_least_curvature * sizes)) return;
        m_ring.resize(m_memory);
        if (m_count == m_memory)
            m_first = (m_first + 1) % m_memory;
        else
            ++m_count;
        Correction& latest = correction(m_count - 1);
        latest.s = move;
        latest.y = gradient_change;
        latest.sy = sy;
    }

    /// Turns minus the gradient into a direction, in place. `initial_inverse(direction)` applies the first guess of the
    /// inverse Hessian, in place.
    template <typename InitialInverse>
    void apply(Vectors& direction, InitialInverse initial_inverse) {
        for (std::size_t k = m_count; k-- > 0;) {
            Correction& c = correction(k);
            c.alpha = dot(c.s, direction) / c.sy;
            direction -= static_cast<Scalar>(c.alpha) * c.y;
        }
        initial_inverse(direction);
        for (std::size_t k = 0; k < m_count; ++k) {
            const Correction& c = correction(k);
            direction += static_cast<Scalar>(c.alpha - dot(c.y, direction) / c.sy) * c.s;
        }
    }

    /// sᵀy / yᵀy of the latest pair, the usual scale of an initial inverse that is a multiple of the identity.
    double latest_scale() {
        const Correction& c = correction(m_count - 1);
        return c.sy / dot(c.y, c.y);
    }

private:
    using Scalar = typename Vectors::Scalar;
    static constexpr double k_least_curvature = 1e-10;

    struct Correction {
        Vectors s, y;      // change of the positions, of the gradient
        double sy = 0;     // their product, positive
        double alpha = 0;  // of the recursion under way
    };
    static double dot(const Vectors& a, const Vectors& b) {
        return dense::dot(a.data(), b.data(), static_cast<int>(a.size()));
    }
    /// k = 0: the oldest kept.
    Correction& correction(std::size_t k) { return m_ring[(m_first + k) % m_memory]; }

    std::size_t m_memory;
    std::vector<Correction> m_ring;
    std::size_t m_first = 0, m_count = 0;
};

}  // namespace chebnet
