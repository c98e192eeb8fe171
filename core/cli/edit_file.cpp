#include "edit_file.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <unordered_map>

#include "base/error.h"
#include "base/text.h"
#include "io/file.h"

namespace chebnet {
namespace {

using nlohmann::json;

json parse_json(std::string_view text, const std::string& name) {
    try {
        return json::parse(text);
    } catch (const json::exception& error) {
        // The library puts its own name, "[json.exception.…] ", in front of what is wrong and where, and repeats the
        // file.
        const std::string what = error.what();
        throw Error(ErrorCode::bad_syntax,
                    name + ": not valid JSON: " + printable(what.substr(what.find("] ") + 2), 200));
    }
}

const json& member(const json& object, const char* key, const std::string& where) {
    const auto found = object.find(key);
    if (found == object.end()) throw Error(ErrorCode::bad_syntax, where + " has no \"" + key + "\"");
    return *found;
}

int read_vertex(const json& value, int vertex_count, const std::string& where) {
    if (!value.is_number_integer()) throw Error(ErrorCode::bad_syntax, where + " is not an integer");
    if (value < 0 || value >= vertex_count)
        throw Error(ErrorCode::index_out_of_range,
                    where + " is " + value.dump() + ", but the vertices are 0 to " + std::to_string(vertex_count - 1));
    return value.get<int>();
}

Eigen::Vector3d read_target(const json& value, const std::string& where) {
    const auto is_number = [](const json& entry) { return entry.is_number(); };
    if (!value.is_array() || value.size() != 3 || !std::ranges::all_of(value, is_number))
        throw Error(ErrorCode::bad_syntax, where + " is not a list of three numbers");
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

double read_weight(const json& value, const std::string& where) {
    if (!value.is_number() || !(value > 0)) throw Error(ErrorCode::bad_syntax, where + " is not a number above 0");
    return value.get<double>();
}

/// "x", "yz": one axis or two, in any order.
Axes read_axes(const json& value, const std::string& where) {
    const std::string letters = "xyz";
    Axes axes = k_no_axes;
    for (const char letter : value.is_string() ? value.get<std::string>() : "") {
        const std::size_t coordinate = letters.find(letter);
        if (coordinate == std::string::npos || has_axis(axes, static_cast<int>(coordinate))) axes = k_all_axes;
        if (axes != k_all_axes) axes |= 1 << coordinate;
    }
    if (axes == k_no_axes || axes == k_all_axes)
        throw Error(ErrorCode::bad_syntax, where + R"( is not one of "x", "y", "z", "xy", "xz", "yz")");
    return axes;
}

void add_keys_not_read(const json& handle, std::set<std::string>& keys) {
    constexpr std::array read{"vertex", "target", "weight", "slides"};
    for (const auto& [key, value] : handle.items())
        if (std::ranges::find(read, key) == read.end()) keys.insert(key);
}

Handle read_handle(const json& value, int vertex_count, const std::string& where) {
    if (!value.is_object()) throw Error(ErrorCode::bad_syntax, where + " is not an object");
    Handle handle{read_vertex(member(value, "vertex", where), vertex_count, where + ".vertex"),
                  read_target(member(value, "target", where), where + ".target")};
    if (const auto weight = value.find("weight"); weight != value.end())
        handle.weight = read_weight(*weight, where + ".weight");
    if (const auto slides = value.find("slides"); slides != value.end()) {
        handle.slides = read_axes(*slides, where + ".slides");
        if (!handle.is_exact()) throw Error(ErrorCode::bad_syntax, where + " has a weight: only exact handles slide");
    }
    return handle;
}

}  // namespace

std::vector<Handle> read_edit(const std::string& path, int vertex_count) {
    return parse_edit(read_file(path), path, vertex_count, std::cerr);
}

std::vector<Handle> parse_edit(std::string_view text, const std::string& name, int vertex_count,
                               std::ostream& remarks) {
    const json edit = parse_json(text, name);
    if (!edit.is_object()) throw Error(ErrorCode::bad_syntax, name + ": not a JSON object");
    const json& list = member(edit, "handles", name + ":");
    if (!list.is_array()) throw Error(ErrorCode::bad_syntax, name + ": \"handles\" is not a list");

    std::vector<Handle> handles;
    std::unordered_map<int, std::size_t> handle_of_vertex;
    std::set<std::string> keys_not_read;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string where = name + ": handles[" + std::to_string(i) + "]";
        handles.push_back(read_handle(list[i], vertex_count, where));
        add_keys_not_read(list[i], keys_not_read);
        const auto [earlier, is_new] = handle_of_vertex.emplace(handles.back().vertex, i);
        if (!is_new)
            throw Error(ErrorCode::repeated_vertex, where + " holds vertex " + std::to_string(earlier->first) +
                                                        ", as handles[" + std::to_string(earlier->second) + "] does");
    }
    for (const std::string& key : keys_not_read)
        remarks << "chebnet: " << name << ": " << chebnet::quoted(key)
                << " of a handle is not read; vertex, target, weight and slides are\n";
    return handles;
}

}  // namespace chebnet
