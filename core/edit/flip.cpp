#include "edit/flip.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

#include "base/error.h"
#include "net/topology.h"
#include "solve/parts/free_part.h"
#include "solve/parts/laplacian_part.h"

namespace chebnet {

namespace {

// The part of the net's extent from which points count as spread in a direction.
constexpr double k_spread = 1e-6;
constexpr int k_refinements = 3;  // of the film, whose system is solved in single precision

/// The axes of some points from the one along which they differ least.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes_of(const Positions& points) {
    const Positions from_centre = points.colwise() - points.rowwise().mean();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(from_centre * from_centre.transpose());
}

/// Of the plane nearest to the handles; where they lie in a line or are one, of that plane through it to which the net
/// is nearest.
Eigen::Vector3d normal_of(const Positions& handles, const Positions& net) {
    const auto axes = axes_of(handles);
    const double extent = axes_of(net).eigenvalues()[2], least = k_spread * k_spread * extent;
    if (axes.eigenvalues()[1] > least) return axes.eigenvectors().col(0);
    if (axes.eigenvalues()[2] <= least) return axes_of(net).eigenvectors().col(0);
    const Eigen::Vector3d line = axes.eigenvectors().col(2);
    // Along the line the net is made to differ most, so that the normal is across it.
    return axes_of(net + 1e3 * line * (line.transpose() * net)).eigenvectors().col(0);
}

/// Each vertex of a held piece at the mean of its neighbours.
Positions soap_film(const Net& net, const std::vector<bool>& is_free, const Positions& positions) {
    Positions film = positions;
    LaplacianPart part(net, is_free);
    for (int k = 0; k < k_refinements; ++k) part.fit(Eigen::Matrix3Xd::Zero(3, net.edge_count()), film);
    return film;
}

}  // namespace

Positions flipped(const Net& net, std::span<const Handle> handles, const Positions& positions) {
    std::vector<int> held;
    for (const Handle& handle : handles)
        if (handle.is_exact()) held.push_back(handle.vertex);
    if (held.empty()) throw Error(ErrorCode::bad_option, "a net that no exact handle holds cannot be pushed through");

    const std::vector<bool> is_free = free_vertices(net.vertex_count(), held);
    const double size = positions.lpNorm<Eigen::Infinity>();
    if (!(size > 0 && size <= k_largest_size)) return positions;  // a handle stands beyond where any net may be
    const Positions x = (positions.colwise() - positions.col(held.front())) / size;  // squares of it are numbers
    const Eigen::Vector3d normal = normal_of(x(Eigen::all, held), x);
    const Positions film = soap_film(net, is_free, x);
    Positions result = positions;
    for (const std::vector<int>& piece : Topology(net).components()) {
        if (std::all_of(piece.begin(), piece.end(), [&](int v) { return is_free[v]; })) continue;
        for (int v : piece)
            if (is_free[v]) result.col(v) -= 2 * size * normal.dot(x.col(v) - film.col(v)) * normal;
    }
    return result;
}

}  // namespace chebnet
