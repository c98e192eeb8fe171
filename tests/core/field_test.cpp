#include "edit/field.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "sample_nets.h"
#include "sample_surfaces.h"
#include "surface/guide.h"

using namespace chebnet;

TEST_CASE("The numbers of a field follow the positions held now") {
    Editor editor(samples::patch(4, 3, 0));
    const Net& net = editor.net();
    editor.set_positions(2 * net.rest_positions());
    std::vector<std::string> names;
    for (const FieldInfo& field : field_table()) names.push_back(field.name);
    CHECK(names == std::vector<std::string>{"deviation", "angle", "force", "height"});
    const Eigen::VectorXd deviations = field_table()[0].numbers(editor);
    REQUIRE(deviations.size() == net.edge_count());
    CHECK(deviations.isApproxToConstant(0.5));
    const Eigen::VectorXd angles = field_table()[1].numbers(editor);
    REQUIRE(angles.size() == net.vertex_count());
    CHECK(angles.isApproxToConstant(std::acos(0.0)));

    CHECK(field_table()[3].numbers(editor).isZero(0));
    editor.set_guide(std::make_shared<const Guide>(Surface(samples::plane(2, 1))));
    editor.set_positions(net.rest_positions().colwise() - Eigen::Vector3d(0, 0, 0.25));
    CHECK(field_table()[3].numbers(editor).isApproxToConstant(-0.25));
}
