#include "solve/options.h"

#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"

namespace chebnet {

namespace {

using Member = std::variant<double Options::*, int Options::*, bool Options::*>;

struct Entry {
    OptionInfo info;
    Member member;
};

constexpr const char* k_number = "number";
constexpr const char* k_integer = "integer";
constexpr const char* k_flag = "flag";

const Entry k_entries[] = {
    {{"threshold", k_number, 1e-24, 1, "Converged when the largest dL is below this (ε3)."}, &Options::threshold},
    {{"energy_tolerance", k_number, 0, 1, "A stage ends when the energy changes by less than this part of it (ε1)."},
     &Options::energy_tolerance},
    {{"gradient_tolerance", k_number, 0, 1e6, "A stage ends when the gradient's norm is below this (ε2)."},
     &Options::gradient_tolerance},
    {{"max_iterations", k_integer, 0, 1e6, "A solve gives up after so many iterations."}, &Options::max_iterations},
    {{"p_start", k_number, 1.5, 200, "Exponent of the energy while edges are far from their length."},
     &Options::p_start},
    {{"p_end", k_number, 1.5, 200, "Exponent that evens out the last deviations."}, &Options::p_end},
    {{"adaptive_p", k_flag, 0, 1, "Begin with the small exponent; off: the large one from the start."},
     &Options::adaptive_p},
    {{"switch_deviation", k_number, 0, 1e6, "The large exponent takes over when the largest dL is below this."},
     &Options::switch_deviation},
    {{"adaptive_reduction", k_flag, 0, 1, "Near the end, move only the vertices close to edges that are still off."},
     &Options::adaptive_reduction},
    {{"reduction_deviation", k_number, 0, 1e6, "Variables are reduced when the largest dL is below this."},
     &Options::reduction_deviation},
    {{"active_fraction", k_number, 0, 1, "An edge is off while its dL is above this part of the threshold (ε4)."},
     &Options::active_fraction},
    {{"active_rings", k_integer, 0, 100, "Rings of neighbours that stay free around an edge that is off."},
     &Options::active_rings},
    {{"reduce_once", k_flag, 0, 1,
      "Choose the vertices to move near the end once, as the paper does, not anew each time."},
     &Options::reduce_once},
    {{"direct_energy", k_flag, 0, 1, "Method li2022 minimises the p-th powers of dL themselves (eq. 2)."},
     &Options::direct_energy},
    {{"shear_limit", k_number, 0, 60,
      "Method equilibrium lets no corner of a quad be sharper, in degrees; 0: no limit."},
     &Options::shear_limit},
    {{"bending_weight", k_number, 1e-6, 1e6, "How much net lines resist bending, in method equilibrium."},
     &Options::bending_weight},
    {{"shear_weight", k_number, 0, 1e6, "How much quads resist shear, in method equilibrium."}, &Options::shear_weight},
    {{"tip_weight", k_number, 0, 1e6,
      "How much singular vertices inside, where net lines end, resist rising to tips, in method equilibrium."},
     &Options::tip_weight},
    {{"straight_rods", k_flag, 0, 1, "Net lines want to be straight, not bent as at rest, in method equilibrium."},
     &Options::straight_rods},
    {{"rod_curvature", k_number, -1e6, 1e6,
      "Curvature that net lines have when free, 1 / radius, above 0 as around a ball; 0: that at rest."},
     &Options::rod_curvature},
    {{"warp_stiffness", k_number, 1e-3, 1e3, "Stiffness of net lines of the first of two families."},
     &Options::warp_stiffness},
    {{"weft_stiffness", k_number, 1e-3, 1e3, "Stiffness of net lines of the second of two families."},
     &Options::weft_stiffness},
    {{"square_corners", k_flag, 0, 1, "Quads want right angles, not those at rest."}, &Options::square_corners},
    {{"gravity", k_number, 0, 1e6, "The weight of an edge, which acts downwards, in method equilibrium."},
     &Options::gravity},
    {{"y_up", k_flag, 0, 1, "Weight acts downwards along y, not along z, in method equilibrium."}, &Options::y_up},
    {{"guide_mode", k_integer, 0, k_guide_modes - 1,
      "What a guide surface does, in method equilibrium: 0 nothing, 1 draws the net near, 2 holds it on, 3 keeps it "
      "outside."},
     &Options::guide_mode},
    {{"guide_weight", k_number, 1e-6, 1e6, "How strongly a guide surface acts, in method equilibrium."},
     &Options::guide_weight},
    {{"rest_tolerance", k_number, 0, 1e6, "Method equilibrium is at rest when the gradient left is below this."},
     &Options::rest_tolerance},
    {{"length_scale", k_number, 0.5, 4, "Every edge is so many times as long as in the net as it came."},
     &Options::length_scale},
};

const Entry& find_entry(std::string_view key) {
    std::string known;
    for (const Entry& entry : k_entries) {
        if (key == entry.info.name) return entry;
        known += known.empty() ? "" : ", ";
        known += entry.info.name;
    }
    throw Error(ErrorCode::bad_option, "unknown option " + quoted(key) + "; known are " + known);
}

[[noreturn]] void refuse(const OptionInfo& info, std::string_view value) {
    std::string wanted = "on or off";
    if (info.kind != k_flag) {
        wanted = std::string(info.kind == k_integer ? "a whole number" : "a number") + " from " +
                 number_text(info.smallest, 6) + " to " + number_text(info.largest, 6);
    }
    throw Error(ErrorCode::bad_option,
                "option " + std::string(info.name) + " must be " + wanted + ", not " + quoted(value));
}

bool parse_flag(const OptionInfo& info, std::string_view value) {
    if (value == "on" || value == "true" || value == "1") return true;
    if (value == "off" || value == "false" || value == "0") return false;
    refuse(info, value);
}

double parse_value(const OptionInfo& info, std::string_view value) {
    const std::optional<double> number = parse_number(value);
    const bool in_range = number && *number >= info.smallest && *number <= info.largest;  // false for NaN
    if (!in_range || (info.kind == k_integer && *number != std::floor(*number))) refuse(info, value);
    return *number;
}

}  // namespace

void set_option(Options& options, std::string_view key, std::string_view value) {
    const Entry& entry = find_entry(key);
    if (const auto* flag = std::get_if<bool Options::*>(&entry.member))
        options.** flag = parse_flag(entry.info, value);
    else if (const auto* integer = std::get_if<int Options::*>(&entry.member))
        options.** integer = static_cast<int>(parse_value(entry.info, value));
    else
        options.*std::get<double Options::*>(entry.member) = parse_value(entry.info, value);
}

double get_option(const Options& options, std::string_view key) {
    return std::visit([&](auto member) { return static_cast<double>(options.*member); }, find_entry(key).member);
}

void check_options(const Options& options) {
    for (const OptionInfo& info : option_table()) {
        const double value = get_option(options, info.name);
        if (!(value >= info.smallest && value <= info.largest)) refuse(info, number_text(value, 6));
    }
}

std::span<const OptionInfo> option_table() {
    static const auto table = [] {
        std::vector<OptionInfo> infos;
        for (const Entry& entry : k_entries) infos.push_back(entry.info);
        return infos;
    }();
    return table;
}

}  // namespace chebnet
