#include "edit/field.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "sample_nets.h"

using namespace chebnet;

TEST_CASE("The numbers of a field follow the positions held now") {
    Editor editor(samples::patch(4, 3, 0));
    const Net& net = editor.net();
    editor.set_positions(2 * net.rest_positions());
    std::vector<std::string> names;
    for (const FieldInfo& field : field_table()) names.push_back(field.name);
    CHECK(names == std::vector<std::string>{"deviation", "angle", "force"});
    const Eigen::VectorXd deviations = field_table()[0].numbers(editor);
    REQUIRE(deviations.size() == net.edge_count());
    CHECK(deviations.isApproxToConstant(0.5));
    const Eigen::VectorXd angles = field_table()[1].numbers(editor);
    REQUIRE(angles.size() == net.vertex_count());
    CHECK(angles.isApproxToConstant(std::acos(0.0)));
}
