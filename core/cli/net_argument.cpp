#include "net_argument.h"

#include <filesystem>
#include <utility>

#include "io/obj.h"
#include "net/error.h"
#include "shapes/shapes.h"

namespace chebnet {
namespace {

bool is_file_name(const std::string& name) {
    std::error_code none;
    const auto status = std::filesystem::status(name, none);
    // A folder that happens to be called like a shape does not hide the shape.
    return name.ends_with(".obj") || (std::filesystem::exists(status) && !std::filesystem::is_directory(status));
}

Net net_of_file(const std::string& path) {
    Mesh mesh = read_obj(read_file(path), path);
    try {
        return Net(std::move(mesh.positions), std::move(mesh.faces));
    } catch (const Error& error) {
        throw Error(error.code(), path + ": " + error.what());
    }
}

Net net_of_recipe(const std::string& recipe) {
    try {
        return make_shape(recipe).net;
    } catch (const Error& error) {
        throw Error(error.code(), recipe + ": no such file, and as a recipe: " + error.what());
    }
}

}  // namespace

void add_net_argument(CLI::App& command, std::string& name) {
    command.add_option("NET", name, "OBJ file or recipe of the net")->required()->type_name("");
}

Net load_net(const std::string& name) { return is_file_name(name) ? net_of_file(name) : net_of_recipe(name); }

}  // namespace chebnet
