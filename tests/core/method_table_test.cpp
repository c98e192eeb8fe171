#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "sample_nets.h"
#include "shapes/shapes.h"
#include "solve/method.h"
#include "surface/gallery.h"
#include "surface/guide.h"

using namespace chebnet;

namespace {

/// A net pulled as far as gives each stage of each method something to do.
struct Case {
    const char* name;
    std::function<Editor()> make;
};

Editor pulled(const std::string& recipe, const Eigen::Vector3d& by) {
    Shape shape = make_shape(recipe);
    Editor editor(std::move(shape.net));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), shape.suggested_handles);
    handles.back().target += editor.net().mean_length() * by;
    editor.set_handles(handles);
    return editor;
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"a vault pulled down",
         [] {
             return pulled("vault:vertices=150", {0.5, 0, -2});
         }},
        {"a vault pulled far, to the last digit",
         [] {
             Editor editor = pulled("vault:vertices=300", {2, 0, -4});
             editor.set_option("threshold", "1e-15");
             return editor;
         }},
        {"a vault of which from the start only what is near edges that are off moves",
         [] {
             Editor editor = pulled("vault:vertices=300", {0, 0, -1});
             editor.set_option("switch_deviation", "1e6");
             editor.set_option("reduction_deviation", "1e6");
             editor.set_option("threshold", "1e-2");
             return editor;
         }},
        {"a sheet that hangs",
         [] {
             Editor editor = pulled("sheet:vertices=100", {-1, -1, 1});
             editor.set_option("gravity", "0.02");
             return editor;
         }},
        {"stairs that somebody has shaken",
         [] {
             Editor editor = pulled("steps:vertices=150", {0, 0, 0});
             std::mt19937 random(1);
             editor.set_positions(samples::shaken(editor.positions(), 2 * editor.net().mean_length(), random));
             return editor;
         }},
        // Here no method gets to the end.
        {"stairs pulled up",
         [] {
             return pulled("steps:vertices=150", {0, 0, 4});
         }},
        {"beside a surface",
         [] {
             Editor editor = pulled("sheet:vertices=100", {-1, -1, 1});
             editor.set_guide(std::make_shared<const Guide>(make_own_surface("shell")));
             return editor;
         }},
    };
    return all;
}

/// Other values than the usual ones, which make a difference where an option is read.
const std::map<std::string, std::string>& other_values() {
    static const std::map<std::string, std::string> all = {
        {"threshold", "0.5"},
        {"energy_tolerance", "0.3"},
        {"gradient_tolerance", "100"},
        {"max_iterations", "2"},
        {"p_start", "4"},
        {"p_end", "20"},
        {"adaptive_p", "off"},
        {"switch_deviation", "1e-4"},
        {"adaptive_reduction", "off"},
        {"reduction_deviation", "1e-2"},
        {"active_fraction", "0"},
        {"active_rings", "6"},
        {"reduce_once", "on"},
        {"direct_energy", "on"},
        {"shear_limit", "55"},
        {"bending_weight", "20"},
        {"shear_weight", "2"},
        {"tip_weight", "20"},
        {"straight_rods", "on"},
        {"rod_curvature", "0.1"},
        {"warp_stiffness", "10"},
        {"weft_stiffness", "10"},
        {"square_corners", "on"},
        {"gravity", "0.01"},
        {"y_up", "on"},
        {"guide_mode", "2"},
        {"guide_weight", "3"},
        {"rest_tolerance", "1e-9"},
        {"length_scale", "1.1"},
    };
    return all;
}

struct Result {
    Positions positions;
    Status status;
    int iterations;
    bool operator==(const Result& other) const {
        return positions == other.positions && status == other.status && iterations == other.iterations;
    }
};

Result solved(const Case& given, const MethodInfo& method, const std::string& option) {
    Editor editor = given.make();
    editor.set_method(method.name);
    editor.set_option("max_iterations", "60");
    if (!option.empty()) editor.set_option(option, other_values().at(option));
    const SolveReport report = editor.solve();
    return {editor.positions(), report.status, report.iterations};
}

}  // namespace

TEST_CASE("What a method depends on are the options that its row lists, and no others", "[large]") {
    for (const MethodInfo& method : method_table()) {
        std::set<std::string> making_a_difference;
        for (const Case& each : cases()) {
            const Result usual = solved(each, method, "");
            for (const OptionInfo& option : option_table())
                if (!making_a_difference.contains(option.name) && !(solved(each, method, option.name) == usual))
                    making_a_difference.insert(option.name);
        }
        for (const OptionInfo& option : option_table()) {
            CAPTURE(method.name, option.name);
            CHECK(reads(method, option.name) == making_a_difference.contains(option.name));
        }
    }
}

TEST_CASE("Each stage that a trace tells of has a name, which says it in a word or two") {
    for (const MethodInfo& method : method_table()) {
        for (const Case& each : cases()) {
            CAPTURE(method.name, each.name);
            Editor editor = each.make();
            editor.set_method(method.name);
            editor.set_option("max_iterations", "60");
            for (const TraceRow& row : editor.solve().trace) {
                REQUIRE(row.stage >= 1);
                REQUIRE(row.stage <= static_cast<int>(method.stages.size()));
                const std::string name = method.stages[row.stage - 1];
                CHECK(!name.empty());
                CHECK(name.size() <= 16);
            }
        }
    }
}
