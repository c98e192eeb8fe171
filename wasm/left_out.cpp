// In chebnet_editor these stand in for functions of the library, so that the linker takes neither them nor what only
// they need: files, shapes that are relaxed, and the methods of which `projection` has no use itself. Called, they throw the code "left_out".

#include <memory>
#include <string>
#include <string_view>

#include "border.h"
#include "io/mesh_file.h"
#include "io/obj.h"
#include "shapes/smooth_figure.h"
#include "solve/composite_majorization.h"
#include "solve/dp.h"
#include "solve/gradient_descent.h"
#include "solve/lbfgs.h"
#include "solve/li2022.h"
#include "solve/projected_newton.h"

namespace chebnet {

namespace {

[[noreturn]] void leave_to_the_whole_core() {
    throw_to_javascript("left_out", "chebnet_core can do this, chebnet_editor cannot");
}

}  // namespace

std::unique_ptr<Method> make_li2022() { leave_to_the_whole_core(); }
std::unique_ptr<Method> make_composite_majorization() { leave_to_the_whole_core(); }
std::unique_ptr<Method> make_projected_newton() { leave_to_the_whole_core(); }
std::unique_ptr<Method> make_dp4() { leave_to_the_whole_core(); }
std::unique_ptr<Method> make_dp8() { leave_to_the_whole_core(); }
std::unique_ptr<Method> make_gradient_descent() { leave_to_the_whole_core(); }
std::unique_ptr<Method> make_lbfgs() { leave_to_the_whole_core(); }

Shape make_smooth_figure(std::span<const Box>, double, std::span<const Eigen::Vector3d>, std::span<const Box>) {
    leave_to_the_whole_core();
}

Mesh read_obj(std::string_view, std::string_view) { leave_to_the_whole_core(); }
std::string write_obj(const Positions&, const Faces&, int) { leave_to_the_whole_core(); }
std::string write_mesh(const Positions&, const Faces&, FileFormat) { leave_to_the_whole_core(); }

}  // namespace chebnet
