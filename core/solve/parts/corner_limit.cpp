#include "solve/parts/corner_limit.h"

#include <algorithm>

namespace chebnet {

namespace {

// Diagonals that exceed their limit by less than this, in edge lengths, are watched, and may be in the way of a move.
constexpr double k_watch = 0.2;
// No diagonal is made longer by more than this at once.
constexpr double k_opening = 0.1;

}  // namespace

CornerLimit::CornerLimit(const Net& net, double angle)
    : m_limits(shear_limit(net, angle).distances()), m_is_watched(m_limits.size(), false), m_held(m_limits.size(), 0) {}

double CornerLimit::lack(const Positions& positions, const Distance& limit) const {
    return (limit.distance - (positions.col(limit.vertex_a) - positions.col(limit.vertex_b)).norm()) / limit.unit;
}

bool CornerLimit::needs_more_rows(const Positions& positions) const {
    for (std::size_t i = 0; i < m_limits.size(); ++i)
        if (!m_is_watched[i] && lack(positions, m_limits[i]) > k_tolerance) return true;
    return false;
}

void CornerLimit::watch(const Positions& positions) {
    m_watched.clear();
    for (std::size_t i = 0; i < m_limits.size(); ++i) {
        m_is_watched[i] = m_held[i] > 0 || lack(positions, m_limits[i]) > -k_watch;
        if (m_is_watched[i]) m_watched.push_back(static_cast<int>(i));
    }
}

std::vector<Distance> CornerLimit::watched() const {
    std::vector<Distance> distances;
    for (int i : m_watched) distances.push_back(m_limits[i]);
    return distances;
}

void CornerLimit::apply(LengthSystem& system) const {
    int row = system.row_count() - static_cast<int>(m_watched.size());
    for (int i : m_watched) {
        if (m_held[i] > 0)
            system.switch_on(row++, m_held[i]);
        else
            system.switch_off(row++);
    }
}

int CornerLimit::hold_short_ones(const Positions& positions) {
    int changed = 0;
    for (int i : m_watched) {
        const double missing = lack(positions, m_limits[i]);
        if (missing <= k_tolerance) continue;
        const double distance = m_limits[i].distance - std::max(0.0, missing - k_opening) * m_limits[i].unit;
        if (m_held[i] >= distance) continue;
        m_held[i] = distance;
        ++changed;
    }
    return changed;
}

/// In edge lengths.
double CornerLimit::shortening(const Positions& positions, const Eigen::Matrix3Xd& moves, const Distance& limit) const {
    const Eigen::Vector3d d = positions.col(limit.vertex_a) - positions.col(limit.vertex_b);
    const double length = d.norm();
    return length > 0 ? d.dot(moves.col(limit.vertex_b) - moves.col(limit.vertex_a)) / (length * limit.unit) : 0;
}

bool CornerLimit::blocks(const Positions& positions, const Eigen::Matrix3Xd& moves, const Distance& limit) const {
    const double room = -lack(positions, limit);
    return room <= k_watch && room + k_tolerance <= shortening(positions, moves, limit);
}

bool CornerLimit::is_blocked_by_unwatched(const Positions& positions, const Eigen::Matrix3Xd& moves) const {
    for (std::size_t i = 0; i < m_limits.size(); ++i)
        if (!m_is_watched[i] && blocks(positions, moves, m_limits[i])) return true;
    return false;
}

int CornerLimit::hold_blocking_ones(const Positions& positions, const Eigen::Matrix3Xd& moves) {
    int changed = 0;
    for (int i : m_watched) {
        if (m_held[i] > 0 || !blocks(positions, moves, m_limits[i])) continue;
        const double room = -lack(positions, m_limits[i]);
        const double above = room < -k_tolerance ? -std::max(0.0, -room - k_opening) : room;
        m_held[i] = m_limits[i].distance + above * m_limits[i].unit;
        ++changed;
    }
    return changed;
}

Eigen::VectorXd CornerLimit::excess(const LengthSystem& system) const {
    Eigen::VectorXd rows = Eigen::VectorXd::Zero(system.row_count());
    Eigen::Index row = rows.size() - static_cast<Eigen::Index>(m_watched.size());
    for (int i : m_watched) rows[row++] = std::max(0.0, (m_held[i] - m_limits[i].distance) / m_limits[i].unit);
    return rows;
}

void CornerLimit::approach(const std::vector<double>& from, double part) {
    for (int i : m_watched)
        if (from[i] > m_limits[i].distance) m_held[i] = from[i] + part * (m_limits[i].distance - from[i]);
}

double CornerLimit::part_until_short(const Positions& positions, const Eigen::Matrix3Xd& moves) const {
    double part = 1;
    for (std::size_t i = 0; i < m_limits.size(); ++i) {
        const double room = k_tolerance - lack(positions, m_limits[i]);
        if (m_held[i] == 0 && room > 0) {
            const double closing = shortening(positions, moves, m_limits[i]);
            if (room < part * closing) part = room / closing;
        }
    }
    return part;
}

int CornerLimit::release(const Eigen::VectorXd& multipliers) {
    int released = 0;
    Eigen::Index row = multipliers.size() - static_cast<Eigen::Index>(m_watched.size());
    for (int i : m_watched) {
        const double multiplier = multipliers[row++];
        if (m_held[i] == 0 || multiplier <= 0) continue;
        m_held[i] = 0;
        ++released;
    }
    return released;
}

int CornerLimit::release_one(const Eigen::VectorXd& multipliers) {
    Eigen::Index row = multipliers.size() - static_cast<Eigen::Index>(m_watched.size());
    int most = -1;
    double pull = 0;
    for (int i : m_watched) {
        const double multiplier = multipliers[row++];
        if (m_held[i] == 0 || multiplier <= pull) continue;
        most = i;
        pull = multiplier;
    }
    if (most >= 0) m_held[most] = 0;
    return most >= 0 ? 1 : 0;
}

int CornerLimit::release_early_ones() {
    int released = 0;
    for (int i : m_watched) {
        if (!(m_held[i] - m_limits[i].distance > k_tolerance * m_limits[i].unit)) continue;
        m_held[i] = 0;
        ++released;
    }
    return released;
}

double CornerLimit::largest_lack(const Positions& positions) const {
    double largest = 0;
    for (const Distance& limit : m_limits) largest = std::max(largest, lack(positions, limit));
    return largest;
}

bool CornerLimit::is_kept(const Positions& positions) const { return largest_lack(positions) <= k_kept; }

CornerLimit corner_limit(const Net& net, const Options& options, double margin) {
    if (options.shear_limit == 0) return CornerLimit();
    return CornerLimit(net, options.shear_limit + margin);
}

}  // namespace chebnet
