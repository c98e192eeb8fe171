#include "report.h"

#include <iostream>

#include "base/error.h"
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

}  // namespace

Json shape_report(const Editor& editor) {
    const AngleRange angles = corner_angle_range(editor.net(), editor.positions());
    Json report{{"max_dL", max_deviation(editor.net(), editor.positions())},
                {"max_handle_error", editor.handle_error()},
                {"bend", bend(editor.net(), editor.topology(), editor.positions())},
                {"smallest_corner_angle_degrees", degrees(angles.smallest)},
                {"largest_corner_angle_degrees", degrees(angles.largest)},
                {"length_scale", editor.options().length_scale},
                {"unreachable_pairs", unreachable_report(editor.unreachable_pairs())}};
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

void print(const Json& report) {
    // A file name need not be UTF-8, JSON must be.
    std::cout << report.dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
    if (!std::cout) throw Error(ErrorCode::file_access, "cannot write to standard output");
}

}  // namespace chebnet
