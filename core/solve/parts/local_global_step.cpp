#include "solve/parts/local_global_step.h"

namespace chebnet {

void LocalGlobalStep::project(const Positions& positions) {
    for (int e = 0; e < net().edge_count(); ++e) {
        const Eigen::Vector3d now = edge_vector(e, positions);
        const double length = now.norm();
        m_vectors.col(e) = net().rest_lengths()[e] * (length > 0 ? Eigen::Vector3d(now / length)
                                                                 : edge_vector(e, net().rest_positions()).normalized());
    }
}

double LocalGlobalStep::energy(const Positions& positions) const {
    double sum = 0;
    for (int e = 0; e < net().edge_count(); ++e) {
        const double off = edge_vector(e, positions).norm() - net().rest_lengths()[e];
        sum += off * off;
    }
    return sum;
}

}  // namespace chebnet
