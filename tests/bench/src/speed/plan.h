#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edit/editor.h"

namespace chebnet::bench {

/// One thing to measure. It holds all that is needed to do so, for both targets.
struct Task {
    std::string section;  ///< "growth", "kernels", "edits" or "drags"
    std::string edit;     ///< such as "vault_4000.pull"
    std::string series;   ///< of growth: the same edit in all sizes, such as "vault.pull"; otherwise empty
    std::string net;      ///< see open_net()
    int vertices;
    std::vector<Handle> handles;
};

struct Plan {
    std::vector<std::string> methods;  ///< the first is what the others are compared with
    int repeats = 0, frames = 0;
    std::vector<Task> tasks;
};

struct PlanArguments {
    std::vector<std::string> methods{"li2022", "projection"};
    std::string nets, edits;        ///< folders; empty: the project's own shapes
    std::vector<std::string> only;  ///< keep the tasks whose name contains one of these; empty: all
    bool quick = false;
};

/// Section and edit of each task that the arguments ask for. Throws Error if there is none.
std::vector<std::string> task_names(const PlanArguments& arguments);
/// Makes every edit. Throws Error.
Plan make_plan(const PlanArguments& arguments);

std::vector<int> handle_vertices(const Task& task);

nlohmann::json to_json(const Plan& plan);
Plan plan_from_json(const nlohmann::json& json);

}  // namespace chebnet::bench
