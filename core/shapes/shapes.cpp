#include "shapes/shapes.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "shapes/family.h"

namespace chebnet {

namespace {

constexpr std::size_t k_longest_recipe = 1000;  // characters
constexpr double k_shape_size = 10;

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> items;
    for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
        items.push_back(trimmed(text.substr(0, end)));
        text.remove_prefix(end + 1);
    }
    items.push_back(trimmed(text));
    return items;
}

template <typename Named>
std::string names(const Named& named) {
    std::string list;
    for (const auto& one : named) list.append(list.empty() ? "" : ", ").append(one.name);
    return list;
}

[[noreturn]] void fail_syntax(const std::string& what) {
    throw Error(ErrorCode::bad_syntax, what + "; a recipe is NAME or NAME:key=value,key=value");
}

const Family& find_family(std::string_view name) {
    if (name.empty()) fail_syntax("the recipe names no shape");
    for (const Family* family : k_families)
        if (family->info.name == name) return *family;
    throw Error(ErrorCode::bad_option, "there is no shape " + quoted(name) + "; known are " + names(shape_table()));
}

const ShapeParameter& find_parameter(const ShapeInfo& shape, std::string_view key) {
    for (const ShapeParameter& parameter : shape.parameters)
        if (parameter.name == key) return parameter;
    throw Error(ErrorCode::bad_option, std::string(shape.name) + " has no parameter " + quoted(key) + "; known are " +
                                           names(shape.parameters));
}

double read_value(const ShapeParameter& parameter, std::string_view text) {
    const std::optional<double> value = parse_number(text);
    if (!value) fail_syntax(std::string(parameter.name) + " is " + quoted(text) + ", which is not a number");
    // Also refuses NaN, which is not within any range.
    if (*value >= parameter.smallest && *value <= parameter.largest) return *value;
    throw Error(ErrorCode::bad_option, std::string(parameter.name) + " is " + quoted(text) + ", but goes from " +
                                           number_text(parameter.smallest, 6) + " to " +
                                           number_text(parameter.largest, 6));
}

Values read_values(const ShapeInfo& shape, std::string_view list) {
    Values values(shape.parameters);
    std::vector<const ShapeParameter*> given;
    for (const std::string_view item : split(list, ',')) {
        const std::vector<std::string_view> parts = split(item, '=');
        if (parts.size() != 2) fail_syntax(quoted(item) + " is not key=value");
        const ShapeParameter& parameter = find_parameter(shape, parts[0]);
        if (std::count(given.begin(), given.end(), &parameter) > 0)
            fail_syntax(std::string(parameter.name) + " is given twice");
        given.push_back(&parameter);
        values[parameter.name] = read_value(parameter, parts[1]);
    }
    return values;
}

}  // namespace

Values::Values(std::span<const ShapeParameter> parameters) : m_parameters(parameters) {
    for (const ShapeParameter& parameter : parameters) m_values.push_back(parameter.value);
}

std::size_t Values::index(std::string_view name) const {
    const auto named = [name](const ShapeParameter& parameter) { return parameter.name == name; };
    return std::find_if(m_parameters.begin(), m_parameters.end(), named) - m_parameters.begin();
}

Net place_net(Mesh surface) {
    const Eigen::Vector3d low = surface.positions.rowwise().minCoeff();
    const Eigen::Vector3d high = surface.positions.rowwise().maxCoeff();
    const Eigen::Vector3d foot((low.x() + high.x()) / 2, (low.y() + high.y()) / 2, low.z());
    const double scale = k_shape_size / (high - low).maxCoeff();
    surface.positions = scale * (surface.positions.colwise() - foot);
    return Net(std::move(surface.positions), std::move(surface.faces), RestLengths::equal);
}

std::span<const ShapeInfo> shape_table() {
    static const auto table = [] {
        std::array<ShapeInfo, std::size(k_families)> infos;
        std::transform(std::begin(k_families), std::end(k_families), infos.begin(),
                       [](auto family) { return family->info; });
        return infos;
    }();
    return table;
}

Shape make_shape(std::string_view recipe) {
    if (recipe.size() > k_longest_recipe)
        fail_syntax("the recipe is longer than " + std::to_string(k_longest_recipe) + " characters");
    const std::size_t colon = recipe.find(':');
    const Family& family = find_family(trimmed(recipe.substr(0, colon)));
    if (family.make == nullptr)
        throw Error(ErrorCode::left_out, "this shape is not in this module, but in chebnet_core");
    if (colon == std::string_view::npos) return family.make(Values(family.info.parameters));
    return family.make(read_values(family.info, recipe.substr(colon + 1)));
}

}  // namespace chebnet
