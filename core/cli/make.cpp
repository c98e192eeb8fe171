#include <CLI/Error.hpp>
#include <iostream>
#include <memory>

#include "command.h"
#include "net_output.h"
#include "shapes/shapes.h"
#include "text_table.h"

namespace chebnet {
namespace {

struct MakeArguments {
    std::string recipe;
    NetOutput output;
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

void make(const std::string& recipe, const NetOutput& output) {
    const Net net = make_shape(recipe).net;
    write_net(output, net.rest_positions(), net.faces());
}

int run_make(const MakeArguments& arguments) {
    if (arguments.list)
        list_shapes();
    else if (arguments.recipe.empty() || arguments.output.path.empty())
        throw CLI::RequiredError("make: a RECIPE and -o OUT, or --list,");
    else
        make(arguments.recipe, arguments.output);
    return k_success;
}

}  // namespace

Command add_make(CLI::App& program) {
    CLI::App& command = *program.add_subcommand("make", "Make a net from a recipe");
    const auto arguments = std::make_shared<MakeArguments>();
    command.add_option("RECIPE", arguments->recipe, "Shape and parameters, such as vault:vertices=4000")->type_name("");
    add_net_output(command, "-o,--output", arguments->output)->type_name("OUT");
    command.add_flag("--list", arguments->list, "List the shapes and their parameters");
    return {&command, [arguments] { return run_make(*arguments); }};
}

}  // namespace chebnet
