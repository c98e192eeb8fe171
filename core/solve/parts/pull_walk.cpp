#include "solve/parts/pull_walk.h"

#include <algorithm>
#include <utility>

namespace chebnet {

namespace {

// Steps of the way, unless they have to be shorter.
constexpr double k_most_pull_steps = 50;

bool is_same(const Pull& a, const Pull& b) { return a.vertex == b.vertex && a.weight == b.weight; }

}  // namespace

void PullWalk::take(std::span<const Pull> pulls) {
    m_from = std::move(m_now);
    m_to.assign(pulls.begin(), pulls.end());
    m_now = m_to;
    m_walked = 1;
}

void PullWalk::begin(const Positions& positions, bool are_known, double edge_length, bool also_short) {
    are_known &= std::equal(m_from.begin(), m_from.end(), m_to.begin(), m_to.end(), is_same);
    const std::vector<Pull> before = std::exchange(m_from, m_to);
    double length = 0;
    for (std::size_t i = 0; i < m_to.size(); ++i) {
        if (!walks(m_to[i])) continue;
        const Eigen::Vector3d& to = m_to[i].target;
        Eigen::Vector3d& from = m_from[i].target;
        from = positions.col(m_to[i].vertex);
        if (are_known && (to - before[i].target).norm() < (to - from).norm()) from = before[i].target;
        length = std::max(length, (to - from).norm() / edge_length);
    }
    m_stride = std::max(1 / k_most_pull_steps, 1 / std::max(1.0, length));
    go_to(length > (also_short ? 0 : 1) ? 0 : 1);
}

double PullWalk::next() const { return std::min(1.0, m_walked + m_stride); }

void PullWalk::go_to(double part) {
    for (std::size_t i = 0; i < m_now.size(); ++i) m_now[i].target = target(i, part);
    m_walked = part;
}

std::vector<Pull> PullWalk::moves_to(double part) const {
    std::vector<Pull> moves = m_now;
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i].target = target(i, part) - m_now[i].target;
    return moves;
}

Eigen::Vector3d PullWalk::target(std::size_t i, double part) const {
    return part == 1 ? m_to[i].target : m_from[i].target + part * (m_to[i].target - m_from[i].target);
}

}  // namespace chebnet
