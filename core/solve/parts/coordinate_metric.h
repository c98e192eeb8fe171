#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "linear/graph_system.h"
#include "net/net.h"
#include "solve/parts/free_part.h"
#include "solve/parts/neighbour_form.h"
#include "solve/parts/neighbour_pairs.h"
#include "solve/slide.h"

namespace chebnet {

/// A form that treats the coordinates alike, factored in single precision on what is free in some of them: in those in
/// which the same vertices slide, or in all where none does. Keeps references.
class CoordinateMetric {
public:
    /// `part`: what is free at all; `own_part`: what of it is free in these coordinates, null if all is. Throws Error
    /// too_large.
    CoordinateMetric(const NeighbourPairs& pairs, const FreePart& part, Axes coordinates = k_all_axes,
                     std::unique_ptr<const FreePart> own_part = nullptr);

    /// Takes over the form, with so much added at each vertex and so much more at one of each piece that nothing holds.
    void factorize(const NeighbourForm& form, double shift, double hold);
    /// Makes the coordinates of what is free those that it has where the form is least, beside what is held.
    void extend(const NeighbourForm& form, Eigen::Matrix3Xd& moves);
    /// Applies the inverse: the coordinates of what is free, from one to the other (3×V).
    void solve(const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to);

private:
    void solve_to(Eigen::Matrix3Xd& solution);

    const NeighbourPairs& m_pairs;
    const Axes m_coordinates;
    const std::unique_ptr<const FreePart> m_own_part;
    const FreePart& m_part;  // its vertices are the nodes of the system
    LaplacianSystem m_system;
    Eigen::Matrix4Xf m_single;
};

/// Where vertices slide: one for each set of coordinates in which the same vertices are free, but for those in which
/// none is.
std::vector<std::unique_ptr<CoordinateMetric>> metrics_by_coordinate(const Net& net, const NeighbourPairs& pairs,
                                                                     const FreePart& part,
                                                                     std::span<const Slide> slides);

}  // namespace chebnet
