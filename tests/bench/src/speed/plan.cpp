#include "plan.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "../edit_case.h"
#include "base/error.h"
#include "shapes/shapes.h"

namespace chebnet::bench {
namespace {

using Json = nlohmann::json;

struct Measurement {
    std::string section;
    EditCase edit;
    std::string series = "";

    std::string name() const { return section + ' ' + edit.name(); }
};

std::string recipe(const std::string& shape, int vertices) { return shape + ":vertices=" + std::to_string(vertices); }

std::vector<Measurement> growth_measurements(bool quick) {
    const std::vector<int> sizes = quick ? std::vector{300, 1000, 3000} : std::vector{1000, 3000, 10000, 30000, 100000};
    std::vector<Measurement> measurements;
    for (const auto& [shape, kind] : {std::pair{"elephant", "bend"}, {"vault", "pull"}})
        for (const int size : sizes)
            measurements.push_back({"growth", {recipe(shape, size), kind, ""}, std::string(shape) + '.' + kind});
    return measurements;
}

std::vector<Measurement> kernel_measurements(bool quick) {
    const std::vector<int> sizes = quick ? std::vector{1000} : std::vector{2000, 8000, 20000};
    std::vector<Measurement> measurements;
    for (const char* shape : {"elephant", "vault", "torus"})
        for (const int size : sizes) measurements.push_back({"kernels", {recipe(shape, size), "pull", ""}});
    return measurements;
}

std::vector<EditCase> own_cases(bool quick) {
    std::vector<EditCase> cases;
    for (const ShapeInfo& shape : shape_table())
        for (const std::string& kind : edit_kinds())
            cases.push_back({recipe(shape.name, quick ? 500 : 4000), kind, ""});
    return cases;
}

std::vector<Measurement> all_measurements(const PlanArguments& arguments) {
    const bool own = arguments.nets.empty();
    const std::vector<EditCase> cases =
        own ? own_cases(arguments.quick) : cases_of_folder(arguments.nets, arguments.edits);
    // Growth comes first: what the program holds from other measurements would count as memory of the smallest sizes.
    std::vector<Measurement> measurements = growth_measurements(arguments.quick);
    for (const Measurement& measurement : kernel_measurements(arguments.quick)) measurements.push_back(measurement);
    std::set<std::string> nets;
    for (const EditCase& edit : cases)
        if (!own && nets.insert(edit.net).second) measurements.push_back({"kernels", edit});
    for (const char* section : {"edits", "drags"})
        for (const EditCase& edit : cases) measurements.push_back({section, edit});
    return measurements;
}

std::vector<Measurement> chosen_measurements(const PlanArguments& arguments) {
    std::vector<Measurement> measurements = all_measurements(arguments);
    std::erase_if(measurements, [&](const Measurement& measurement) {
        return !arguments.only.empty() && std::ranges::none_of(arguments.only, [&](const std::string& text) {
            return measurement.name().find(text) != std::string::npos;
        });
    });
    if (measurements.empty())
        throw Error(ErrorCode::bad_option, "there is nothing of that name to measure; see --list");
    return measurements;
}

Json handles_json(const std::vector<Handle>& handles) {
    Json list = Json::array();
    for (const Handle& handle : handles)
        list.push_back({{"vertex", handle.vertex}, {"target", {handle.target[0], handle.target[1], handle.target[2]}}});
    return list;
}

std::vector<Handle> handles_from_json(const Json& list) {
    std::vector<Handle> handles;
    for (const Json& item : list) {
        const Json& target = item.at("target");
        handles.push_back({item.at("vertex").get<int>(),
                           {target.at(0).get<double>(), target.at(1).get<double>(), target.at(2).get<double>()}});
    }
    return handles;
}

}  // namespace

std::vector<std::string> task_names(const PlanArguments& arguments) {
    std::vector<std::string> names;
    for (const Measurement& measurement : chosen_measurements(arguments)) names.push_back(measurement.name());
    return names;
}

Plan make_plan(const PlanArguments& arguments) {
    for (const std::string& method : arguments.methods) make_method(method);
    const std::vector<Measurement> measurements = chosen_measurements(arguments);
    Plan plan{arguments.methods, arguments.quick ? 3 : 5, 60, {}};
    std::map<std::string, Edit> made;  // several sections measure the same edit
    for (const auto& [section, edit, series] : measurements) {
        auto known = made.find(edit.name());
        if (known == made.end()) known = made.emplace(edit.name(), make_problem(edit)).first;
        const Edit& problem = known->second;
        plan.tasks.push_back({section, edit.name(), series, edit.net, problem.net.vertex_count(), problem.handles});
    }
    return plan;
}

std::vector<int> handle_vertices(const Task& task) {
    std::vector<int> vertices;
    for (const Handle& handle : task.handles) vertices.push_back(handle.vertex);
    return vertices;
}

Json to_json(const Plan& plan) {
    Json tasks = Json::array();
    for (const Task& task : plan.tasks)
        tasks.push_back({{"section", task.section},
                         {"edit", task.edit},
                         {"series", task.series},
                         {"net", task.net},
                         {"vertices", task.vertices},
                         {"handles", handles_json(task.handles)}});
    return {{"methods", plan.methods}, {"repeats", plan.repeats}, {"frames", plan.frames}, {"tasks", tasks}};
}

Plan plan_from_json(const Json& json) {
    Plan plan{json.at("methods"), json.at("repeats"), json.at("frames"), {}};
    for (const Json& task : json.at("tasks"))
        plan.tasks.push_back({task.at("section"), task.at("edit"), task.at("series"), task.at("net"),
                              task.at("vertices"), handles_from_json(task.at("handles"))});
    return plan;
}

}  // namespace chebnet::bench
