#include <cmath>

#include "shapes/box_figure.h"
#include "shapes/family.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_steps_parameters[] = {
    vertices_parameter(2000),
    {"steps", 4, 2, 10, "How many steps lead to the top."},
    {"height", 1.2, 0.3, 3, "Height of a step divided by its depth."},
};

Shape make_steps(const Values& values) {
    const int steps = static_cast<int>(std::lround(values["steps"]));
    const double height = values["height"];
    std::vector<Box> boxes;
    for (int step = 0; step < steps; ++step) {
        const double half_width = steps - step;
        boxes.push_back({{-half_width, -half_width, step * height}, {half_width, half_width, (step + 1) * height}});
    }
    const double corner = steps;
    const Eigen::Vector3d handles[] = {
        {-corner, -corner, 0}, {corner, -corner, 0}, {-corner, corner, 0}, {corner, corner, 0}, {0, 0, steps * height}};
    return make_box_figure(boxes, values["vertices"], handles);
}

}  // namespace

constinit const Family k_steps = {
    {"steps", "Steps", "A stepped pyramid. At its corners three or five edges meet instead of four.",
     k_steps_parameters},
    make_steps};

}  // namespace chebnet
