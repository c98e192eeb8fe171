#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "net/net.h"
#include "solve/slide.h"

namespace chebnet {

/// The way of exact handles from where a net has them to where they are to be, gone in steps. It knows where handles
/// stand along it; a method makes the net follow. Of a vertex that slides, the way is what it has to go across the axes
/// along which it slides.
class HandleWalk {
public:
    /// `held`: the vertices that are fixed, and those that slide; `axes`: V, along which a vertex may move.
    void set_handles(std::span<const int> held, std::vector<Axes> axes);

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
    /// A shape, turned and shifted to where handles are to be, what slides to where `like` has it, and as far as that
    /// leaves it free, to `like`.
    Positions placed(const Positions& shape, const Positions& like) const;

    /// Takes over what is the handles' to say of all vertices: all of a fixed one, and of one that slides what it
    /// keeps.
    void take_held(const Positions& from, Positions& to) const;
    /// Takes over what is left free of a vertex.
    void take_free(int vertex, const Positions& from, Positions& to) const;
    /// Whether a vertex stands in two states in the same place, as far as it is free.
    bool stands_the_same(int vertex, const Positions& a, const Positions& b) const;

    /// Handles that are as near to their places in a shape, in edge lengths, are arranged as there.
    static constexpr double k_same = 1e-6;

private:
    Eigen::Vector3d held_part(int vertex, const Eigen::Vector3d& move) const;

    std::vector<int> m_held;
    std::vector<Axes> m_axes;
    Positions m_from, m_to;
    double m_edge_length = 1, m_length = 0;
    double m_walked = 0, m_stride = 1;  // parts of the way: gone, and of a step
    Eigen::Matrix3Xd m_last_move;
};

}  // namespace chebnet
