#include "shapes/box_figure.h"
#include "shapes/family.h"
#include "shapes/smooth_figure.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_jack_parameters[] = {
    vertices_parameter(2000),
    {"arm", 1.2, 0.3, 5, "Length of each arm divided by its width."},
    smooth_parameter(),
};

Shape make_jack(const Values& values) {
    const double reach = 1 + 2 * values["arm"];
    const Eigen::Vector3d ones(1, 1, 1);
    Box boxes[3];
    std::vector<Eigen::Vector3d> tips;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d tip = reach * Eigen::Vector3d::Unit(axis);
        const Eigen::Vector3d corner = tip.cwiseMax(ones);
        boxes[axis] = {-corner, corner};
        tips.insert(tips.end(), {-tip, tip});
    }
    if (is_on(values["smooth"])) return make_smooth_figure(boxes, values["vertices"], 0, tips);
    return make_box_figure(boxes, values["vertices"], tips);
}

}  // namespace

constinit const Family k_jack = {
    {"jack", "Jack", "Six square arms around a cube. At its corners three or six edges meet instead of four.",
     k_jack_parameters},
    make_jack};

}  // namespace chebnet
