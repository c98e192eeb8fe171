// What chebnet_editor has in place of sources that it does without (left_out.cmake): OBJ, edge tables, flat patterns,
// nets pushed through, shapes that are relaxed, and surfaces. Called, they throw the code "left_out".

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "edit/flip.h"
#include "fabricate/edge_table.h"
#include "io/obj.h"
#include "mesh_border.h"
#include "shapes/smooth_figure.h"
#include "solve/terms/closeness_term.h"

namespace chebnet {

namespace {

[[noreturn]] void leave_to_the_whole_core() {
    throw_to_javascript("left_out", "chebnet_core can do this, chebnet_editor cannot");
}

}  // namespace

Shape make_smooth_figure(std::span<const Box>, double, std::span<const Eigen::Vector3d>, std::span<const Box>) {
    leave_to_the_whole_core();
}

Positions flipped(const Net&, std::span<const Handle>, const Positions&) { leave_to_the_whole_core(); }
Mesh read_obj(std::string_view, std::string_view) { leave_to_the_whole_core(); }
std::string write_obj(const Positions&, const Faces&, int) { leave_to_the_whole_core(); }
std::string edge_table(const Net&, const Positions&) { leave_to_the_whole_core(); }
std::unique_ptr<Term> make_closeness_term(const Net&, const Guide&, double, double, ClosenessTerm::Side) {
    leave_to_the_whole_core();
}
Eigen::VectorXd heights_over(const Guide&, const Positions&) { leave_to_the_whole_core(); }
val flat_pattern_out(const Net&, const Topology&) { leave_to_the_whole_core(); }

}  // namespace chebnet
