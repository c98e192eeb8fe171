// What chebnet_editor has in place of sources that it does without (left_out.cmake): OBJ, edge tables, flat patterns,
// nets pushed through, handles that slide, are soft, turn together or are drawn where no way leads, limits that give
// way, localities, shapes that are relaxed, surfaces, families of net lines and rods that were bent beforehand. Called,
// they throw the code "left_out".

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edit/flip.h"
#include "edit/locality.h"
#include "edit/net_forces.h"
#include "fabricate/rod_table.h"
#include "io/obj.h"
#include "mesh_border.h"
#include "net/families.h"
#include "net/rods.h"
#include "shapes/smooth_figure.h"
#include "solve/parts/coordinate_metric.h"
#include "solve/parts/free_motions.h"
#include "solve/parts/handle_walk.h"
#include "solve/parts/length_system.h"
#include "solve/parts/neighbour_system.h"
#include "solve/parts/rest_descent.h"
#include "solve/parts/tangent_newton.h"
#include "solve/parts/turned_handles.h"
#include "solve/terms/bending_term.h"
#include "solve/terms/closeness_term.h"
#include "solve/terms/penalty_term.h"

namespace chebnet {

namespace {

// Fewer that are held let a net turn as a whole.
constexpr std::size_t k_least_held = 3;

[[noreturn]] void leave_to_the_whole_core() {
    throw_to_javascript("left_out", "chebnet_core can do this, chebnet_editor cannot");
}

}  // namespace

Shape make_smooth_figure(std::span<const Box>, double, double, std::span<const Eigen::Vector3d>, std::span<const Box>) {
    leave_to_the_whole_core();
}

Region region_around(const Net&, const Topology&, const Positions&, std::span<const int>, double) {
    leave_to_the_whole_core();
}
Eigen::VectorXf mobility(const Net&, const Topology&, std::span<const int>, double) { leave_to_the_whole_core(); }
Positions flipped(const Net&, std::span<const Handle>, const Positions&) { leave_to_the_whole_core(); }
Mesh read_obj(std::string_view, std::string_view) { leave_to_the_whole_core(); }
std::string write_obj(const Positions&, const Faces&, int) { leave_to_the_whole_core(); }
std::string edge_table(const Editor&) { leave_to_the_whole_core(); }
std::string rod_table(const Net&, const Topology&, const Positions&) { leave_to_the_whole_core(); }
std::vector<std::vector<int>> rods(const Net&, const Topology&, std::optional<double>) { leave_to_the_whole_core(); }
std::unique_ptr<Term> make_closeness_term(const Net&, const Guide&, double, double, ClosenessTerm::Side) {
    leave_to_the_whole_core();
}
std::unique_ptr<Term> make_yielding_limit(const Net&, double, double) { leave_to_the_whole_core(); }
Eigen::VectorXd heights_over(const Guide&, const Positions&) { leave_to_the_whole_core(); }
std::optional<std::vector<int>> edge_families(const Net&) { leave_to_the_whole_core(); }
void BendingTerm::bend_rest_lines(const Net&, const Positions&, double) { leave_to_the_whole_core(); }
/// The whole core begins the solve again.
bool Editor::take_in_hand() {
    m_positions = m_run.net_before;
    m_running = false;
    leave_to_the_whole_core();
}
/// What is pressed as it stands may stay so here.
bool TangentNewton::find_buckling(std::span<const std::unique_ptr<Term>>, int, Eigen::Matrix3Xd&) { return false; }
// Never called where nothing has been taken in hand.
bool Editor::goes_on_by_hand(SolveReport&) { return false; }
Status Editor::status_by_hand() const { return Status::running; }
void Editor::give_up_by_hand() {}
bool Editor::goes_on_past_limit(Status) { return false; }
double Editor::deviation_with_hand_at_targets() const { return 0; }
Eigen::Vector3d Editor::goal(const Handle& handle) const { return handle.target; }
void Editor::show_found_net() {}
void Editor::take_better_net(SolveReport&) {}
/// Handles that move one by one.
std::shared_ptr<const TurnedHandles> TurnedHandles::find(const Topology& topology, const HeldVertices& held,
                                                         const Positions& from, const Positions& to) {
    for (int v : held.vertices())
        for (int n : topology.neighbours(v))
            if (!held.stands_the_same(v, from, to) && !held.stands_the_same(n, from, to)) leave_to_the_whole_core();
    return nullptr;
}
void TurnedHandles::go(double, const Positions&, const Positions&, const Positions&, Eigen::Matrix3Xd&) const {}
void RestDescent::take_pulls(std::span<const Pull> pulls) {
    m_rest_energy.move_pulls(*m_net, pulls);
    for (const Pull& pull : pulls)
        if (std::isinf(pull.yields)) leave_to_the_whole_core();
}
// Never called without soft handles.
std::span<const Pull> RestDescent::pulls_on_their_way() const { return {}; }
void RestDescent::begin_pull_walk(const Positions&) {}
Status RestDescent::follow_pulls(Positions&, TraceRow&) { return Status::running; }
void RestDescent::follow_lone_pulls(std::span<const std::vector<int>>, std::span<const Pull>, Positions&) {}
void check_slide(int, Axes, bool) { leave_to_the_whole_core(); }
void TangentNewton::find_free_motions(bool is_guided, std::span<const Pull>, const Options&) {
    if (!is_guided && m_fixed.size() < k_least_held) leave_to_the_whole_core();
}
// Of use to such nets alone.
void HandleWalk::carry_along(const std::vector<int>&, const Eigen::VectorXd&, const Positions&, Positions&) {}
// Never called where no handle has passed that check.
void FreeMotions::begin(const Positions&) {}
void FreeMotions::take_out(Eigen::Matrix3Xd&) const {}
void LengthSystem::set_slides(std::span<const Slide>) {}
void LengthSystem::take_off_what_is_kept() {}
void LengthSystem::add_pull_beside_what_is_kept(const Eigen::VectorXd&, Eigen::Matrix3Xd&) const {}
void NeighbourSystem::hold(std::span<const Slide>) {}
std::vector<std::unique_ptr<CoordinateMetric>> metrics_by_coordinate(const Net&, const NeighbourPairs&, const FreePart&,
                                                                     std::span<const Slide>) {
    return {};
}
val flat_pattern_out(const Net&, const Topology&) { leave_to_the_whole_core(); }

}  // namespace chebnet
