#include "edit/resting_near.h"

#include <numbers>
#include <string>
#include <utility>

#include "base/number.h"
#include "solve/options.h"

namespace chebnet {

namespace {

constexpr const char* k_rest_threshold = "1e-9";
// Coming to rest makes it little fairer in the end.
constexpr const char* k_rest_tolerance = "0.01";

}  // namespace

Editor resting_near(Net net, std::shared_ptr<const Guide> guide, double shear_limit, Rods rods, double tip_weight) {
    const double closeness = closeness_for(rods, net.face_count()) * net.vertex_count() / k_guided_vertices;
    Editor editor(std::move(net));
    editor.set_method("equilibrium");
    editor.set_guide(std::move(guide));
    editor.set_option("threshold", k_rest_threshold);
    editor.set_option("rest_tolerance", k_rest_tolerance);
    editor.set_option("straight_rods", rods == Rods::straight ? "on" : "off");
    editor.set_option("tip_weight", number_text(tip_weight, 17));
    editor.set_option("guide_weight", number_text(closeness, 17));
    editor.set_option("shear_limit", number_text(shear_limit * 180 / std::numbers::pi, 17));
    return editor;
}

}  // namespace chebnet
