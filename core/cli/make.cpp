#include <CLI/Error.hpp>
#include <iostream>
#include <memory>

#include "command.h"
#include "io/file.h"
#include "net_output.h"
#include "report.h"
#include "shapes/shapes.h"
#include "text_table.h"

namespace chebnet {
namespace {

struct MakeArguments {
    std::string recipe;
    NetOutput output;
    std::string edit;  ///< file to write; empty: none
    bool list = false;
};

std::string parameter_table(std::span<const ShapeParameter> parameters) {
    std::vector<std::vector<std::string>> rows;
    for (const ShapeParameter& parameter : parameters)
        rows.push_back({"", parameter.name, to_text(parameter.value),
                        to_text(parameter.smallest) + " to " + to_text(parameter.largest), parameter.sentence});
    return text_table(rows);
}

void list_shapes() {
    std::cout << "A recipe is NAME or NAME:parameter=value,parameter=value. Parameters: default, range, meaning.\n";
    for (const ShapeInfo& shape : shape_table())
        std::cout << '\n' << shape.name << " - " << shape.sentence << '\n' << parameter_table(shape.parameters);
}

/// An edit that leaves the net as it is, until a target is changed.
std::string edit_at_rest(const Shape& shape) {
    Json handles = Json::array();
    for (const int vertex : shape.suggested_handles) {
        const Eigen::Vector3d place = shape.net.rest_positions().col(vertex);
        handles.push_back({{"vertex", vertex}, {"target", {place.x(), place.y(), place.z()}}});
    }
    return Json{{"handles", handles}}.dump(2) + '\n';
}

void make(const MakeArguments& arguments) {
    check_apart({arguments.output.path, arguments.edit});
    const Shape shape = make_shape(arguments.recipe);
    write_net(arguments.output, shape.net.rest_positions(), shape.net.faces());
    if (!arguments.edit.empty()) write_file(arguments.edit, edit_at_rest(shape));
}

int run_make(const MakeArguments& arguments) {
    if (arguments.list)
        list_shapes();
    else if (arguments.recipe.empty() || arguments.output.path.empty())
        throw CLI::RequiredError("make: a RECIPE and -o OUT, or --list,");
    else
        make(arguments);
    return k_success;
}

}  // namespace

Command add_make(CLI::App& program) {
    CLI::App& command = *program.add_subcommand("make", "Make a net from a recipe");
    const auto arguments = std::make_shared<MakeArguments>();
    command.add_option("RECIPE", arguments->recipe, "Shape and parameters, such as vault:vertices=4000")->type_name("");
    add_net_output(command, "-o,--output", arguments->output)->type_name("OUT");
    command
        .add_option(
            "--edit", arguments->edit,
            "Write the handles suggested for it where they stand, all but the last to be held, as an edit for solve")
        ->type_name("EDIT.json");
    command.add_flag("--list", arguments->list, "List the shapes and their parameters");
    return {&command, [arguments] { return run_make(*arguments); }};
}

}  // namespace chebnet
