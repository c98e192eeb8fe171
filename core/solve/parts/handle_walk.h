#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/held_vertices.h"
#include "solve/parts/turned_handles.h"

namespace chebnet {

/// The way of exact handles from where a net has them to where they are to be, gone in steps. It knows where handles
/// stand along it; a method makes the net follow. Of a vertex that slides, the way is what it has to go across the axes
/// along which it slides. Handles joined by edges turn together, see TurnedHandles; others go straight.
class HandleWalk {
public:
    /// Keeps a reference to the topology.
    void set_handles(HeldVertices held, const Topology& topology);
    const HeldVertices& held() const { return m_held; }

    /// From the first to the second, both 3×V; `edge_length`: the unit of the way.
    void begin(const Positions& from, const Positions& to, double edge_length);
    const Positions& end() const { return m_to; }
    /// In edge lengths, of the handle that has the farthest to go.
    double length() const { return m_length; }
    /// Longer than a hand goes in a frame or two.
    bool is_jump() const;
    /// The part of the way that has been gone.
    double walked() const { return m_walked; }
    /// The part at which the next step is to end.
    double next() const;
    /// Whether what was gone since then is so little of a step that the net is about to be taut.
    bool is_nearly_stuck_since(double walked) const;
    void go_to(double part) { m_walked = part; }

    /// What handles have to move from a net to be this part of their way, 3×V; 0 elsewhere.
    Eigen::Matrix3Xd moves_to(double part, const Positions& from) const;
    /// Takes off of such moves what the net's last step did of them, as far as this one is like it. Returns how much of
    /// that step is to be repeated.
    double take_off_repeated(Eigen::Matrix3Xd& moves) const;
    /// How the net moved in a step, 3×V.
    void note_move(Eigen::Matrix3Xd move) { m_last_move = std::move(move); }
    const Eigen::Matrix3Xd& last_move() const { return m_last_move; }
    /// As if no step had been made.
    void forget_moves(int vertices) { m_last_move.setZero(3, vertices); }

    /// The farthest that a handle has to go from a net to the end of the way, in edge lengths.
    double way_left(const Positions& from) const;
    /// Whether handles end as they are in this shape, wherever that is; `like`: see placed().
    bool ends_as_in(const Positions& shape, const Positions& like) const;
    /// A shape, each piece of it turned and shifted to where handles are to be, what slides to where `like` has it, and
    /// as far as that leaves it free, to `like`.
    Positions placed(const Positions& shape, const Positions& like) const;

    /// Handles that are as near to their places in a shape, in edge lengths, are arranged as there.
    static constexpr double k_same = 1e-6;

private:
    /// Moves what is free of a piece as what is held does on the average: handles that move together turn nothing.
    static void carry_along(const std::vector<int>& piece, const Eigen::VectorXd& is_held, const Positions& from,
                            Positions& to);

    const Topology* m_topology = nullptr;
    HeldVertices m_held;
    std::vector<std::vector<int>> m_pieces;  // of the net, each with its vertices ascending
    Positions m_from, m_to;
    std::shared_ptr<const TurnedHandles> m_turned;  // null: all go straight
    double m_edge_length = 1, m_length = 0;
    double m_walked = 0, m_stride = 1;  // parts of the way: gone, and of a step
    Eigen::Matrix3Xd m_last_move;
};

}  // namespace chebnet
