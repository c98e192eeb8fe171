#include "shapes/box_figure.h"
#include "shapes/family.h"
#include "shapes/smooth_figure.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_elephant_parameters[] = {
    vertices_parameter(3000),
    {"legs", 2.5, 1, 6, "Length of the legs, where the body is 4 high."},
    {"trunk", 4.5, 1, 6, "Length of the trunk, where the body is 4 high."},
    smooth_parameter(),
};

Shape make_elephant(const Values& values) {
    const double belly = values["legs"];
    Boxes boxes;
    const auto add = [&](double x_low, double x_high, double y_low, double y_high, double z_low, double z_high) {
        boxes.add(x_low, x_high, y_low, y_high, belly + z_low, belly + z_high);
    };
    const auto add_pair = [&](double x_low, double x_high, double y_low, double y_high, double z_low, double z_high) {
        boxes.add_pair(x_low, x_high, y_low, y_high, belly + z_low, belly + z_high);
    };
    const double trunk_end = 4 - values["trunk"];
    add(-2, 2, -4, 2.5, 0, 4);                           // body
    add_pair(0.5, 2, -4, -2.5, -belly, 0);               // hind legs
    add_pair(0.5, 2, 1, 2.5, -belly, 0);                 // fore legs
    add(-1.5, 1.5, 2.5, 4.5, 1.5, 5);                    // head
    add_pair(1.5, 4, 3, 3.5, 2, 5.5);                    // ears
    add_pair(1, 1.5, 4.5, 6, 2, 2.5);                    // tusks
    add(-0.5, 0.5, 4.5, 5.5, trunk_end, 4);              // trunk
    add(-0.5, 0.5, 5.5, 6.5, trunk_end, trunk_end + 1);  // its tip
    add(-0.25, 0.25, -4.5, -4, 1, 3.5);                  // tail

    const Eigen::Vector3d handles[] = {
        {1.25, -3.25, 0}, {-1.25, -3.25, 0}, {1.25, 1.75, 0}, {-1.25, 1.75, 0}, {0, 6.5, belly + trunk_end + 0.5}};
    if (is_on(values["smooth"])) return make_smooth_figure(boxes, values["vertices"], 0, handles);
    return make_box_figure(boxes, values["vertices"], handles);
}

}  // namespace

constinit const Family k_elephant = {
    {"elephant", "Elephant", "An elephant of blocks. At its corners three, five or six edges meet instead of four.",
     k_elephant_parameters},
    make_elephant};

}  // namespace chebnet
