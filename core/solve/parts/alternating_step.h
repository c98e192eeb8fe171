#pragma once

#include <Eigen/Core>
#include <memory>

#include "net/net.h"
#include "solve/parts/laplacian_part.h"

namespace chebnet {

/// One iteration of a method that alternates: locally, each edge e chooses the vector t_e it wants to be (`project`);
/// globally, the free vertices take the positions that fit these vectors best (`fit`). Neither lets the energy rise.
/// The handles already stand at their targets and do not move. Nothing is allocated after construction but what the
/// linear solver returns. Keeps a reference to the part, which must outlive it and may serve several steps.
class AlternatingStep {
public:
    explicit AlternatingStep(LaplacianPart& part) : m_part(part), m_vectors(3, part.net().edge_count()) {}
    virtual ~AlternatingStep() = default;

    /// One iteration on `positions`, 3×V.
    void iterate(Positions& positions) {
        project(positions);
        fit(positions);
    }

    /// The local half: chooses the vectors for `positions`.
    virtual void project(const Positions& positions) = 0;
    /// The global half, with the vectors of the last project(). Returns ‖∇E‖ over the free vertices before the move if
    /// project() has seen these positions.
    double fit(Positions& positions) { return m_part.fit(m_vectors, positions); }
    /// E at `positions` with what the last project() has chosen, in the net's own unit squared.
    virtual double energy(const Positions& positions) const = 0;

protected:
    const Net& net() const { return m_part.net(); }
    /// The vector of edge e in some positions: from its second end to its first.
    Eigen::Vector3d edge_vector(int e, const Positions& positions) const {
        return positions.col(net().edges()(0, e)) - positions.col(net().edges()(1, e));
    }

    LaplacianPart& m_part;
    Eigen::Matrix3Xd m_vectors;  // 3×E, t_e
};

using MakeAlternatingStep = std::unique_ptr<AlternatingStep> (*)(LaplacianPart&);

template <typename Step>
std::unique_ptr<AlternatingStep> make_alternating_step(LaplacianPart& part) {
    return std::make_unique<Step>(part);
}

}  // namespace chebnet
