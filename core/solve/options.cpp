#include "solve/options.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/angle.h"
#include "base/error.h"
#include "base/number.h"
#include "base/text.h"

namespace chebnet {

namespace {

using Member = std::variant<double Options::*, int Options::*, bool Options::*, GuideMode Options::*>;

struct Entry {
    const char* name;
    double smallest, largest;
    const char* sentence;
    Member member;
    double unit = 1;  // of a text's number, in that of the member
};

const Entry k_entries[] = {
    {"threshold", 1e-24, 1, "Converged when the largest dL is below this (ε3).", &Options::threshold},
    {"energy_tolerance", 0, 1, "A stage ends when the energy changes by less than this part of it (ε1).",
     &Options::energy_tolerance},
    {"gradient_tolerance", 0, 1e6,
     "A stage ends when the gradient's norm is below this (ε2); dp4 and dp8 take it relative to what it is near the "
     "threshold.",
     &Options::gradient_tolerance},
    {"max_iterations", 0, 1e6, "A solve gives up after so many iterations.", &Options::max_iterations},
    {"p_start", 1.5, 200, "Exponent of the energy while edges are far from their length.", &Options::p_start},
    {"p_end", 1.5, 200, "Exponent that evens out the last deviations.", &Options::p_end},
    {"adaptive_p", 0, 1, "Begin with the small exponent; off: the large one from the start.", &Options::adaptive_p},
    {"switch_deviation", 0, 1e6, "The large exponent takes over when the largest dL is below this.",
     &Options::switch_deviation},
    {"adaptive_reduction", 0, 1, "Near the end, move only the vertices close to edges that are still off.",
     &Options::adaptive_reduction},
    {"reduction_deviation", 0, 1e6, "Variables are reduced when the largest dL is below this.",
     &Options::reduction_deviation},
    {"active_fraction", 0, 1, "An edge is off while its dL is above this part of the threshold (ε4).",
     &Options::active_fraction},
    {"active_rings", 0, 100, "Rings of neighbours that stay free around an edge that is off.", &Options::active_rings},
    {"reduce_once", 0, 1, "Choose the vertices to move near the end once, as the paper does, not anew each time.",
     &Options::reduce_once},
    {"direct_energy", 0, 1, "Method li2022 minimises the p-th powers of dL themselves (eq. 2).",
     &Options::direct_energy},
    {"shear_limit", 0, 60, "Method equilibrium lets no corner of a quad be sharper, in degrees; 0: no limit.",
     &Options::shear_limit, k_degree},
    {"bending_weight", 1e-6, 1e6, "How much net lines resist bending, in method equilibrium.",
     &Options::bending_weight},
    {"shear_weight", 0, 1e6, "How much quads resist shear, in method equilibrium.", &Options::shear_weight},
    {"tip_weight", 0, 1e6,
     "How much singular vertices inside, where net lines end, resist rising to tips, in method equilibrium.",
     &Options::tip_weight},
    {"straight_rods", 0, 1, "Net lines want to be straight, not bent as at rest, in method equilibrium.",
     &Options::straight_rods},
    {"rod_curvature", -1e6, 1e6,
     "Curvature that net lines have when free, 1 / radius, above 0 as around a ball; 0: that at rest.",
     &Options::rod_curvature},
    {"warp_stiffness", 1e-3, 1e3, "Stiffness of net lines of the first of two families.", &Options::warp_stiffness},
    {"weft_stiffness", 1e-3, 1e3, "Stiffness of net lines of the second of two families.", &Options::weft_stiffness},
    {"square_corners", 0, 1, "Quads want right angles, not those at rest.", &Options::square_corners},
    {"gravity", 0, 1e6, "The weight of an edge, which acts downwards, in method equilibrium.", &Options::gravity},
    {"y_up", 0, 1, "Weight acts downwards along y, not along z, in method equilibrium.", &Options::y_up},
    {"guide_mode", 0, k_guide_modes - 1,
     "What a guide surface does, in method equilibrium: 0 nothing, 1 draws the net near, 2 holds it on, 3 keeps it "
     "outside.",
     &Options::guide_mode},
    {"guide_weight", 1e-6, 1e6, "How strongly a guide surface acts, in method equilibrium.", &Options::guide_weight},
    {"rest_tolerance", 0, 1e6, "Method equilibrium is at rest when the gradient left is below this.",
     &Options::rest_tolerance},
    {"length_scale", 0.5, 4, "Every edge is so many times as long as in the net as it came.", &Options::length_scale},
};

OptionKind kind_of(const Member& member) {
    if (std::holds_alternative<bool Options::*>(member)) return OptionKind::flag;
    return std::holds_alternative<double Options::*>(member) ? OptionKind::number : OptionKind::integer;
}

const Entry& find_entry(std::string_view key) {
    std::string known;
    for (const Entry& entry : k_entries) {
        if (key == entry.name) return entry;
        known += known.empty() ? "" : ", ";
        known += entry.name;
    }
    throw Error(ErrorCode::bad_option, "unknown option " + quoted(key) + "; known are " + known);
}

[[noreturn]] void refuse(const Entry& entry, std::string_view value) {
    std::string wanted = "on or off";
    if (const OptionKind kind = kind_of(entry.member); kind != OptionKind::flag) {
        wanted = std::string(kind == OptionKind::integer ? "a whole number" : "a number") + " from " +
                 number_text(entry.smallest, 6) + " to " + number_text(entry.largest, 6);
    }
    throw Error(ErrorCode::bad_option,
                "option " + std::string(entry.name) + " must be " + wanted + ", not " + quoted(value));
}

bool parse_flag(const Entry& entry, std::string_view value) {
    if (value == "on" || value == "true" || value == "1") return true;
    if (value == "off" || value == "false" || value == "0") return false;
    refuse(entry, value);
}

double parse_value(const Entry& entry, std::string_view value) {
    const std::optional<double> number = parse_number(value);
    const bool in_range = number && *number >= entry.smallest && *number <= entry.largest;  // false for NaN
    const bool is_whole = kind_of(entry.member) == OptionKind::integer;
    if (!in_range || (is_whole && *number != std::floor(*number))) refuse(entry, value);
    return *number;
}

double value_of(const Options& options, const Entry& entry) {
    return std::visit([&](auto member) { return static_cast<double>(options.*member); }, entry.member);
}

/// A number that a text has for this value: the one of 15 digits, which people write, or else one that comes out as the
/// same value again.
double number_in(double unit, double value) {
    if (unit == 1) return value;
    const double number = value / unit, infinity = std::numeric_limits<double>::infinity();
    const double written = parse_number(number_text(number, std::numeric_limits<double>::digits10)).value_or(number);
    for (const double each : {written, number, std::nextafter(number, 0), std::nextafter(number, infinity)})
        if (each * unit == value) return each;
    return number;
}

}  // namespace

const char* to_string(OptionKind kind) {
    constexpr const char* names[] = {"number", "integer", "flag"};
    return names[static_cast<int>(kind)];
}

void set_option(Options& options, std::string_view key, std::string_view value) {
    const Entry& entry = find_entry(key);
    if (const auto* flag = std::get_if<bool Options::*>(&entry.member))
        options.** flag = parse_flag(entry, value);
    else if (const auto* integer = std::get_if<int Options::*>(&entry.member))
        options.** integer = static_cast<int>(parse_value(entry, value));
    else if (const auto* mode = std::get_if<GuideMode Options::*>(&entry.member))
        options.** mode = static_cast<GuideMode>(parse_value(entry, value));
    else
        options.*std::get<double Options::*>(entry.member) = parse_value(entry, value) * entry.unit;
}

double get_option(const Options& options, std::string_view key) {
    const Entry& entry = find_entry(key);
    return number_in(entry.unit, value_of(options, entry));
}

void check_options(const Options& options) {
    for (const Entry& entry : k_entries) {
        const double value = value_of(options, entry);
        if (!(value >= entry.smallest * entry.unit && value <= entry.largest * entry.unit))
            refuse(entry, number_text(value / entry.unit, 6));
    }
}

std::span<const OptionInfo> option_table() {
    static const auto table = [] {
        std::vector<OptionInfo> infos;
        for (const auto& [name, smallest, largest, sentence, member, unit] : k_entries)
            infos.push_back({name, kind_of(member), smallest, largest, sentence});
        return infos;
    }();
    return table;
}

}  // namespace chebnet
