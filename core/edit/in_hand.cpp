#include <algorithm>
#include <vector>

#include "base/error.h"
#include "edit/editor.h"

// What an editor does with handles in hand: a user's, or those that a solve has taken in hand itself (by_hand.cpp).

namespace chebnet {

void Editor::drag_handle(int vertex, const Eigen::Vector3d& target, Axes along) {
    check_target(vertex, target);
    if (along != k_all_axes && !is_part(along)) throw Error(ErrorCode::bad_option, "a hand keeps to x, y or z");
    const std::size_t place = place_of_handle(vertex);
    if (!m_method->heeds().only_nets) return move_handle(vertex, target);
    if (m_hand.owner() != Hand::Owner::user) let_go();
    Handle& handle = m_handles[place];
    if (handle.is_exact()) {
        if (m_hand.take(vertex, Hand::Owner::user) && m_hand.holds_back()) hold_otherwise();
        m_hand.hold_again(false);
        keep_hand_to(along);
    }
    move(handle, target);
}

std::vector<Handle> Editor::standing_handles() const {
    std::vector<Handle> handles = m_handles;
    if (draws_handles()) return handles;
    for (int vertex : m_hand.vertices()) handles[m_handle_at[vertex]].target = m_positions.col(vertex);
    return handles;
}

/// Those that are still on their way, or held back, stay where they are; those that a solve has taken in hand are to be
/// at their targets.
void Editor::let_go() {
    if (m_hand.is_empty()) return;
    m_handles = standing_handles();
    if (draws_handles()) snap(m_handles, m_positions);
    empty_hand();
}

void Editor::empty_hand() {
    hold_back(false);
    m_hand.empty();
}

void Editor::keep_hand_to(Axes axes) {
    if (m_hand.along() == axes) return;
    m_hand.keep_to(axes);
    if (m_hand.holds_back()) hold_otherwise();
}

void Editor::hold_back(bool on) {
    if (m_hand.holds_back() == on) return;
    m_hand.hold_back(on);
    hold_otherwise();
}

/// What is held at its place is no longer what the method knows of.
void Editor::hold_otherwise() {
    m_prepared = false;
    m_running = false;
}

/// After a solve has ended: whether another way of holding what is in hand is to be tried. Where the net cannot follow,
/// or has followed as far as a walk leads, it is held back, and where that is no net along the axes to which it is
/// kept, in all of them; where it has come near all the same, it is held again, once; and where even that is no net,
/// because of other handles, it is moved as by move_handle().
bool Editor::goes_on_otherwise(Status status) {
    if (m_run.limit_gives_way) return goes_on_past_limit(status);
    if (m_hand.is_empty()) {
        if (!(m_run.may_take_in_hand && m_run.reachable && status == Status::unreachable)) return false;
        take_in_hand();
        return true;  // also without: by lengths alone
    }
    if (status == Status::unreachable && m_hand.holds_back()) {
        if (m_hand.along() != k_all_axes)
            keep_hand_to(k_all_axes);
        else
            empty_hand();
        return true;
    }
    if (status == Status::unreachable || m_run.stops_short) {
        // A core without slides says so here, before it holds anything back: one with them goes on from this state.
        m_running = false;
        if (is_part(m_hand.along())) check_slide(m_hand.vertices().front(), m_hand.along(), true);
        hold_back(true);
        return true;
    }
    if (!m_hand.holds_back() || m_hand.has_held_again() || !is_nearly_there()) return goes_on_let_go();
    m_hand.hold_again(true);
    hold_back(false);
    return true;
}

bool Editor::is_nearly_there() const {
    const double near = k_nearly_there * m_unit_net->mean_length();
    return std::all_of(m_hand.vertices().begin(), m_hand.vertices().end(), [&](int vertex) {
        return (m_unit_positions.col(vertex) - goal(m_handles[m_handle_at[vertex]]) / m_unit).stableNorm() < near;
    });
}

/// Once the user has let go: what was held back is pulled no longer, nor along the axes along which it slides, and the
/// net is free to come home, also where the way of the hand has led it elsewhere.
bool Editor::goes_on_let_go() {
    if (m_hand.owner() != Hand::Owner::released) return false;
    if (m_hand.holds_back() && is_to_be_home())
        empty_hand();
    else
        let_go();
    return true;
}

/// Whether all exact handles are to be where the rest positions have them.
bool Editor::is_to_be_home() const {
    return std::all_of(m_handles.begin(), m_handles.end(), [&](const Handle& handle) {
        return !handle.is_exact() || handle.holds_at(m_net->rest_positions().col(handle.vertex));
    });
}

}  // namespace chebnet
