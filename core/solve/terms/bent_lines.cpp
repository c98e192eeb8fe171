#include <algorithm>
#include <cmath>

#include "net/measures.h"
#include "solve/terms/bending_term.h"

namespace chebnet {

namespace {

constexpr double k_sharpest = 0.7;  // sine of half the largest turn

}  // namespace

void BendingTerm::bend_rest_lines(const Net& net, const Positions& rest, double curvature) {
    const Eigen::Matrix3Xd normals = vertex_normals(net, rest);
    for (int b = 0; b < net.vertex_count(); ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            const int j = m_spokes[i].partner;
            if (j < i) continue;
            const Eigen::Vector3d normal = normals.col(b), chord = m_rest.col(i) - m_rest.col(j);
            const Eigen::Vector3d along = (chord - normal.dot(chord) * normal).normalized();
            const double length = (1 / m_spokes[i].inverse_length + 1 / m_spokes[j].inverse_length) / 2;
            const double sine = std::clamp(curvature * length / 2, -k_sharpest, k_sharpest);
            m_rest.col(i) = std::sqrt(1 - sine * sine) * along - sine * normal;
            m_rest.col(j) = -std::sqrt(1 - sine * sine) * along - sine * normal;
        }
}

}  // namespace chebnet
