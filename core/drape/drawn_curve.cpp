#include "drape/drawn_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "surface/surface_cut.h"

namespace chebnet {

DrawnCurve::DrawnCurve(const Surface& surface, const SurfaceTree& tree, const Positions& points)
    : m_chain(cut_path(surface, cut_line(surface, tree, points, "the curve"), "the curve")),
      m_is_closed(segments() > 1 && m_chain.col(0) == m_chain.col(segments())) {
    if (segments() == 0) throw Error(ErrorCode::bad_option, "the drawn curve has no length");
}

DrawnCurve::Place DrawnCurve::nearest(const Eigen::Vector3d& point) const {
    Place best{0, m_chain.col(0)};
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < segments(); ++k) {
        const Eigen::Vector3d a = m_chain.col(k), along = m_chain.col(k + 1) - a;
        const double squared_length = along.squaredNorm();
        if (squared_length == 0) continue;
        const Eigen::Vector3d here = a + std::clamp((point - a).dot(along) / squared_length, 0.0, 1.0) * along;
        const double distance = (here - point).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = {k, here};
    }
    return best;
}

std::optional<DrawnCurve::Place> DrawnCurve::after(const Place& from, double distance, bool forwards) const {
    Eigen::Vector3d here = from.position;
    Eigen::Index k = from.segment;
    for (Eigen::Index passed = 0; passed <= segments(); ++passed) {
        const Eigen::Vector3d end = m_chain.col(forwards ? k + 1 : k);
        if ((end - from.position).norm() >= distance) {
            // From a point within the sphere to one beyond it, the way meets it once.
            const Eigen::Vector3d along = (end - here).normalized(), gone = here - from.position;
            const double back = gone.dot(along);
            const double way = -back + std::sqrt(back * back + distance * distance - gone.squaredNorm());
            return Place{k, here + way * along};
        }
        here = end;
        k += forwards ? 1 : -1;
        if (k < 0 || k >= segments()) {
            if (!m_is_closed) return std::nullopt;
            k = forwards ? 0 : segments() - 1;
        }
    }
    return std::nullopt;
}

}  // namespace chebnet
