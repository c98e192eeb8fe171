#include "edit/resting_near.h"

#include <utility>

namespace chebnet {

namespace {

constexpr double k_rest_tolerance = 0.01;  // coming to rest makes it little fairer in the end

}  // namespace

Editor resting_near(Net net, std::shared_ptr<const Guide> guide, double shear_limit, Rods rods, double tip_weight) {
    const double closeness = closeness_for(rods, net.face_count()) * net.vertex_count() / k_guided_vertices;
    Editor editor(std::move(net));
    EditState state = editor.state();
    state.method = "equilibrium";
    state.guide = std::move(guide);
    state.options.threshold = k_equal_deviation;
    state.options.rest_tolerance = k_rest_tolerance;
    state.options.straight_rods = rods == Rods::straight;
    state.options.tip_weight = tip_weight;
    state.options.guide_weight = closeness;
    state.options.shear_limit = shear_limit;
    editor.change_state(std::move(state));
    return editor;
}

}  // namespace chebnet
