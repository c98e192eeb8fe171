#include "net_argument.h"

#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "io/file.h"
#include "io/mesh_file.h"
#include "net/repair.h"
#include "shapes/shapes.h"

namespace chebnet {
namespace {

bool is_file_name(const std::string& name) {
    std::error_code none;
    const auto status = std::filesystem::status(name, none);
    // A folder that happens to be called like a shape does not hide the shape.
    return has_mesh_extension(name) || (std::filesystem::exists(status) && !std::filesystem::is_directory(status));
}

[[noreturn]] void fail(const std::string& path, const Error& error, const std::string& hint = "") {
    throw Error(error.code(), path + ": " + error.what() + hint);
}

Mesh repaired(Mesh mesh, const std::string& path) {
    try {
        RepairedMesh result = repair(std::move(mesh), k_all_defects);
        for (const Finding& finding : result.findings)
            std::cerr << "chebnet: " << path << ": " << to_sentence(finding) << '\n';
        return std::move(result.mesh);
    } catch (const Error& error) {
        fail(path, error);
    }
}

const char* repair_hint(ErrorCode code, bool repaired) {
    const bool is_repairable = code == ErrorCode::repeated_vertex || code == ErrorCode::zero_length_edge ||
                               code == ErrorCode::non_manifold_edge || code == ErrorCode::unused_vertex;
    return is_repairable && !repaired ? " (--repair may mend this)" : "";
}

Net net_of_file(const std::string& path, bool repair) {
    Mesh mesh = load_mesh(path, repair);
    try {
        return Net(std::move(mesh.positions), std::move(mesh.faces));
    } catch (const Error& error) {
        fail(path, error, repair_hint(error.code(), repair));
    }
}

Net net_of_recipe(const std::string& recipe) {
    try {
        return make_shape(recipe).net;
    } catch (const Error& error) {
        std::error_code unknown;
        const char* what = std::filesystem::is_directory(recipe, unknown) ? "a directory" : "no such file";
        throw Error(error.code(), recipe + ": " + what + ", and as a recipe: " + error.what());
    }
}

}  // namespace

void add_net_argument(CLI::App& command, NetArgument& argument) {
    command.add_option("NET", argument.name, "File (" + titles_read("or") + ") or recipe of the net")
        ->required()
        ->type_name("");
    add_repair_argument(command, argument.repair);
}

void add_repair_argument(CLI::App& command, bool& repair) {
    command.add_flag(
        "--repair", repair,
        "Merge coinciding vertices, remove faces that name a vertex twice, are double or third at an edge, wind all "
        "one way, drop unused vertices; vertices then count anew");
}

Net load_net(const NetArgument& argument) {
    return is_file_name(argument.name) ? net_of_file(argument.name, argument.repair) : net_of_recipe(argument.name);
}

int tell_coinciding(const Mesh& mesh, const std::string& name) {
    const std::optional<Finding> finding = find_duplicate_vertices(mesh);
    if (!finding) return 0;
    std::cerr << "chebnet: " << name << ": " << to_sentence(*finding) << " (--repair merges them)\n";
    return finding->count;
}

Surface load_surface(const std::string& path, bool repair) {
    const Mesh mesh = load_mesh(path, repair);
    try {
        if (!repair) tell_coinciding(mesh, path);
        return Surface(mesh);
    } catch (const Error& error) {
        fail(path, error, repair_hint(error.code(), repair || has_one_side(mesh.faces)));
    }
}

Mesh load_mesh(const std::string& path, bool repair) {
    Mesh mesh = read_mesh(read_file(path), path);
    return repair ? repaired(std::move(mesh), path) : mesh;
}

}  // namespace chebnet
