#include "edit/field.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string_view>

#include "sample_nets.h"
#include "sample_surfaces.h"
#include "surface/guide.h"

using namespace chebnet;

namespace {

Eigen::VectorXd numbers_of(std::string_view name, const Editor& editor) {
    const auto field = std::ranges::find(field_table(), name, &FieldInfo::name);
    REQUIRE(field != field_table().end());
    return field->numbers(editor);
}

}  // namespace

TEST_CASE("The numbers of a field follow the positions held now") {
    Editor editor(samples::patch(4, 3, 0));
    const Net& net = editor.net();
    editor.set_positions(2 * net.rest_positions());
    const Eigen::VectorXd deviations = numbers_of("deviation", editor);
    REQUIRE(deviations.size() == net.edge_count());
    CHECK(deviations.isApproxToConstant(0.5));
    const Eigen::VectorXd angles = numbers_of("angle", editor);
    REQUIRE(angles.size() == net.vertex_count());
    CHECK(angles.isApproxToConstant(std::acos(0.0)));

    CHECK(numbers_of("height", editor).isZero(0));
    editor.set_guide(std::make_shared<const Guide>(Surface(samples::plane(2, 1))));
    editor.set_positions(net.rest_positions().colwise() - Eigen::Vector3d(0, 0, 0.25));
    CHECK(numbers_of("height", editor).isApproxToConstant(-0.25));
}
