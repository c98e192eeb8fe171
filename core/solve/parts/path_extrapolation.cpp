#include "solve/parts/path_extrapolation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chebnet {

namespace {

double distance(const Positions& a, const Positions& b) {
    double sum = 0;
    for (Eigen::Index k = 0; k < a.size(); ++k) {
        const double difference = a.data()[k] - b.data()[k];
        sum += difference * difference;
    }
    return std::sqrt(sum);
}

}  // namespace

void PathExtrapolation::add(const Positions& x) {
    m_points[2].swap(m_points[1]);
    m_points[1].swap(m_points[0]);
    m_points[0] = x;
    m_count = std::min(m_count + 1, 3);
}

bool PathExtrapolation::is_known() const {
    return m_count == 3 && distance(m_points[0], m_points[1]) > 0 && distance(m_points[1], m_points[2]) > 0;
}

void PathExtrapolation::go(double t, Positions& x) const {
    const double ratio = distance(m_points[0], m_points[1]) / distance(m_points[1], m_points[2]);
    // Newton's form with nodes 0, −1 and −1 − 1 / ratio, by differences: what stands in all three stays to the last
    // bit.
    const double bend = t * (t + 1) / (1 + 1 / ratio);
    const auto& [last, middle, first] = m_points;
    x = last;
    for (Eigen::Index k = 0; k < x.size(); ++k)
        x.data()[k] +=
            (t + bend) * (last.data()[k] - middle.data()[k]) + bend * ratio * (first.data()[k] - middle.data()[k]);
}

double PathExtrapolation::farthest(const Positions& x) const {
    double most = 0;
    for (Eigen::Index k = 0; k < x.size(); k += 3) {
        double square = 0;
        for (int i = 0; i < 3; ++i) {
            const double way = x.data()[k + i] - m_points[0].data()[k + i];
            square += way * way;
        }
        most = std::max(most, square);
    }
    return std::sqrt(most);
}

}  // namespace chebnet
