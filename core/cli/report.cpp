#include "report.h"

#include <algorithm>
#include <iostream>

#include "base/angle.h"
#include "base/error.h"
#include "base/number.h"
#include "edit/net_forces.h"
#include "net/measures.h"
#include "surface/guide.h"

namespace chebnet {
namespace {

double degrees(double radians) { return radians / k_degree; }

Json distance_report(const Editor& editor) {
    const GuideDistance distance = distance_to(*editor.guide(), editor.net(), editor.positions());
    const double length = editor.net().mean_length();
    return {{"mean", distance.mean / length}, {"largest", distance.largest / length}};
}

int quads_beyond_limit(const Editor& editor, const Positions& positions) {
    return sharp_quads(editor.net(), positions, editor.options().shear_limit - k_limit_tolerance);
}

/// A net that comes with some is opened by methods that know the limit.
Json sharp_quads_report(const Editor& editor) {
    return {{"at_rest", quads_beyond_limit(editor, editor.net().rest_positions())},
            {"now", quads_beyond_limit(editor, editor.positions())}};
}

/// Those that are not as they are unless said otherwise.
Json options_report(const Options& options) {
    Json report = Json::object();
    for (const OptionInfo& info : option_table()) {
        const double value = get_option(options, info.name);
        if (value != get_option(Options{}, info.name)) report[info.name] = value;
    }
    return report;
}

Json force_report(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json edge_report(const Net& net, const Eigen::VectorXd& forces, int edge) {
    return {{"edge", edge}, {"vertices", {net.edges()(0, edge), net.edges()(1, edge)}}, {"force", forces[edge]}};
}

}  // namespace

Json shape_report(const Editor& editor) {
    const AngleRange angles = corner_angle_range(editor.net(), editor.positions());
    Json report{{"options", options_report(editor.options())},
                {"max_dL", max_deviation(editor.net(), editor.positions())},
                {"max_handle_error", editor.handle_error()},
                {"bend", bend(editor.net(), editor.topology(), editor.positions())},
                {"smallest_corner_angle_degrees", degrees(angles.smallest)},
                {"largest_corner_angle_degrees", degrees(angles.largest)},
                {"folds_over_60_degrees", sharp_folds(editor.net(), editor.positions(), k_fold)},
                {"length_scale", editor.options().length_scale},
                {"unreachable_pairs", unreachable_report(editor.unreachable_pairs())}};
    if (editor.options().shear_limit > 0) report["quads_beyond_shear_limit"] = sharp_quads_report(editor);
    if (editor.guide()) report["distance_from_guide_in_lengths"] = distance_report(editor);
    return report;
}

Json unreachable_report(const std::vector<UnreachablePair>& pairs) {
    Json list = Json::array();
    for (const UnreachablePair& pair : pairs)
        list.push_back(
            {{"vertices", {pair.vertex_a, pair.vertex_b}}, {"distance", pair.distance}, {"reach", pair.reach}});
    return list;
}

Json to_rest_report(const std::optional<ToRest>& left) {
    if (!left) return nullptr;
    return {{"gradient_norm", left->gradient_norm},
            {"corner_lack_in_lengths", left->corner_lack},
            {"motion_in_lengths", left->motion}};
}

Json rest_search_report(const RestSearchReport& search) {
    return {{"energy_before", search.energy_before},
            {"energy", search.energy},
            {"iterations", search.iterations},
            {"milliseconds", search.milliseconds}};
}

Json forces_report(const Editor& editor) {
    const std::optional<NetForces> forces = net_forces(editor);
    if (!forces) return Json::object();
    Json energies = Json::object(), handles = Json::array(), corners = Json::array();
    for (const auto& [name, energy] : forces->energies) energies[name] = energy;
    for (std::size_t i = 0; i < editor.handles().size(); ++i)
        handles.push_back({{"vertex", editor.handles()[i].vertex},
                           {"force", force_report(forces->handles.col(static_cast<Eigen::Index>(i)))}});
    for (const auto& [a, b, push] : forces->corners) corners.push_back({{"vertices", {a, b}}, {"push", push}});
    int pulls_most = 0, pushes_most = 0;
    forces->edges.maxCoeff(&pulls_most);
    forces->edges.minCoeff(&pushes_most);
    return {{"energies", energies},
            {"handle_forces", handles},
            {"corner_forces", corners},
            {"edge_that_pulls_most", edge_report(editor.net(), forces->edges, pulls_most)},
            {"edge_that_pushes_most", edge_report(editor.net(), forces->edges, pushes_most)}};
}

bool has_lengths(const Editor& editor, const SolveReport& end) {
    return end.status != Status::unreachable && end.max_deviation < editor.options().threshold &&
           editor.handle_error() == 0;
}

void tell_sharp_quads(int count, double limit) {
    std::cerr << "chebnet: every edge has its length, but " << count << (count == 1 ? " quad has" : " quads have")
              << " a corner sharper than " << number_text(degrees(limit), 4) << " degrees\n";
}

void tell_sharp_quads(const Editor& editor, const SolveReport& end) {
    const MethodInfo& method = *std::ranges::find(method_table(), editor.method(), &MethodInfo::name);
    if (!reads(method, "shear_limit") || !(editor.options().shear_limit > 0) || !has_lengths(editor, end)) return;
    const int count = quads_beyond_limit(editor, editor.positions());
    if (count > 0) tell_sharp_quads(count, editor.options().shear_limit);
}

void tell_crumpled(int edges, std::string_view than, std::string_view way_out) {
    if (edges == 0) return;
    std::cerr << "chebnet: every edge has its length, but the net is crumpled: at " << edges
              << (edges == 1 ? " edge" : " edges") << " it folds by 60 degrees more than " << than
              << (way_out.empty() ? "" : "; ") << way_out << '\n';
}

void tell_crumpled(const Editor& editor, const SolveReport& end, const char* what_helps) {
    if (!has_lengths(editor, end)) return;
    const int count = new_folds(editor.net(), editor.net().rest_positions(), editor.positions());
    const bool is_usual = editor.method() == k_default_method;
    tell_crumpled(count, "before the edit",
                  is_usual ? std::string(what_helps)
                           : "--method " + std::string(k_default_method) + " often leads to a smoother one");
}

void print(const Json& report) {
    // A file name need not be UTF-8, JSON must be.
    std::cout << report.dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
    if (!std::cout) throw Error(ErrorCode::file_access, "cannot write to standard output");
}

}  // namespace chebnet
