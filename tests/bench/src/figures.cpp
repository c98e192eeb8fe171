#include "figures.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/file.h"
#include "io/obj.h"
#include "shapes/shapes.h"

namespace chebnet::bench {
namespace {

using Json = nlohmann::json;

/// Reads the description; `m_folder` holds its meshes.
class Reader {
public:
    explicit Reader(const std::string& path)
        : m_folder(std::filesystem::path(path).parent_path()), m_json(Json::parse(read_file(path))) {}

    std::vector<Figure> figures() const {
        std::vector<Figure> list;
        for (const Json& json : m_json.at("figures")) list.push_back(figure(json));
        return list;
    }

private:
    Figure figure(const Json& json) const {
        Figure figure;
        figure.name = json.at("name");
        if (!json.at("figure").is_null()) figure.number = json.at("figure").get<int>();
        figure.title = text(json.at("title"));
        figure.look = text(json.at("look"));
        for (const std::string name : json.at("edits")) figure.edits.push_back(edit(name));
        for (const Json& each : json.at("variants")) figure.variants.push_back(variant(each));
        for (const std::string name : json.at("plots")) figure.plots.push_back(name);
        for (const Json& each : json.at("claims")) figure.claims.push_back({text(each.at("text")), each.at("check")});
        const std::string field = json.value("field", "deviation");
        figure.colouring = field == "longer"  ? Colouring::longer
                           : field == "angle" ? Colouring::angle
                                              : Colouring::deviation;
        return figure;
    }

    Variant variant(const Json& json) const {
        Variant variant{.name = json.at("name"), .label = text(json.at("label")), .method = json.at("method")};
        variant.initialisation = json.value("initialisation", "naive");
        const Json options = json.value("options", Json::object());
        for (const auto& [key, value] : options.items())
            variant.options.emplace_back(key, value.is_boolean() ? (value.get<bool>() ? "on" : "off") : value.dump());
        if (json.contains("edit")) variant.edit = edit(json.at("edit"));
        variant.frames = json.value("frames", 0);
        variant.remeshes = json.value("remeshes", false);
        variant.is_ours = json.value("ours", false);
        return variant;
    }

    NamedEdit edit(const std::string& name) const {
        const Json json = m_json.at("edits").at(name);
        return {name, [json, folder = m_folder] { return open(json, folder); }};
    }

    static Edit open(const Json& json, const std::filesystem::path& folder) {
        Net net = open_net(json.at("net"), folder);
        std::vector<Handle> handles;
        for (const Json& handle : json.at("handles")) {
            const bool is_anchor = handle.is_number();
            const int vertex = is_anchor ? handle.get<int>() : handle.at(0).get<int>();
            if (vertex < 0 || vertex >= net.vertex_count())
                throw Error(ErrorCode::index_out_of_range, "there is no vertex " + std::to_string(vertex));
            Eigen::Vector3d target = net.rest_positions().col(vertex);
            for (int i = 0; i < 3 && !is_anchor; ++i) target[i] = handle.at(i + 1);
            handles.push_back({vertex, target});
        }
        return {std::move(net), std::move(handles)};
    }

    static Net open_net(const Json& json, const std::filesystem::path& folder) {
        if (json.contains("recipe")) return make_shape(json.at("recipe").get<std::string>()).net;
        const std::string path = folder / "meshes" / (json.at("mesh").get<std::string>() + ".obj");
        Mesh mesh = read_obj(read_file(path), path);
        return Net(std::move(mesh.positions), std::move(mesh.faces));
    }

    /// Of the languages in which the page has it, the one of this program.
    static std::string text(const Json& json) { return json.is_string() ? json : json.at("en"); }

    std::filesystem::path m_folder;
    Json m_json;
};

}  // namespace

std::vector<Figure> read_figures(const std::string& path) {
    try {
        return Reader(path).figures();
    } catch (const nlohmann::json::exception& error) {
        throw Error(ErrorCode::bad_syntax, path + ": " + error.what());
    }
}

}  // namespace chebnet::bench
