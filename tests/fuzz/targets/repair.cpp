#include "net/repair.h"

#include <algorithm>

#include "arbitrary.h"
#include "require.h"

using namespace chebnet;
using fuzz::require;

namespace {

std::vector<Defect> any_defects(FuzzedDataProvider& input) {
    std::vector<Defect> chosen;
    for (const Defect defect : k_all_defects)
        if (input.ConsumeBool()) chosen.push_back(defect);
    return chosen;
}

void require_findings(const RepairedMesh& result) {
    for (const Finding& finding : result.findings) {
        require(finding.count >= 1 && std::ssize(finding.examples) <= finding.count, "a finding of nothing");
        require(std::is_sorted(finding.examples.begin(), finding.examples.end()), "examples out of order");
        require(!to_sentence(finding).empty(), "a finding without words");
    }
}

void require_numbers(const Mesh& given, const RepairedMesh& result) {
    require(std::ssize(result.new_vertex) == given.positions.cols(), "vertices without a new number");
    for (const int now : result.new_vertex)
        require(now >= -1 && now < result.mesh.positions.cols(), "a vertex went to " + std::to_string(now));
    require(result.mesh.positions.allFinite(), "a vertex is not finite");
    for (const int v : result.mesh.faces.vertices)
        require(v >= 0 && v < result.mesh.positions.cols(), "a face names vertex " + std::to_string(v));
}

/// Calls visit(a, b) with the ends of every side of every face.
template <class Visit>
void for_each_side(const Mesh& mesh, Visit visit) {
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t k = 0; k < mesh.faces[f].size(); ++k)
            visit(mesh.faces[f][k], mesh.faces[f][(k + 1) % mesh.faces[f].size()]);
}

bool has_length(const Mesh& mesh) {
    bool has = false;
    for_each_side(mesh, [&](int a, int b) { has = has || mesh.positions.col(a) != mesh.positions.col(b); });
    return has;
}

/// After all repairs a mesh that had any length has no edge without, and a Net takes it but for its scale.
void require_net(const Mesh& given, const Mesh& repaired) {
    if (has_length(given))
        for_each_side(repaired, [&](int a, int b) {
            require(repaired.positions.col(a) != repaired.positions.col(b), "an edge without a length is left");
        });
    try {
        Net(repaired.positions, repaired.faces);
    } catch (const Error& error) {
        fuzz::require_readable(error);
        const bool is_expected = error.code() == ErrorCode::no_faces || error.code() == ErrorCode::bad_scale ||
                                 (error.code() == ErrorCode::zero_length_edge && !has_length(given));
        require(is_expected, std::string("a repaired mesh is refused: ") + error.what());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider input(data, size);
    const std::vector<Defect> chosen = input.ConsumeBool() ? k_all_defects : any_defects(input);
    const double tolerance = input.ConsumeBool() ? k_merge_tolerance : fuzz::any_number(input);
    const Mesh mesh = input.ConsumeBool() ? fuzz::any_mesh(input) : fuzz::any_patch(input);
    try {
        const RepairedMesh result = repair(mesh, chosen, tolerance);
        require_findings(result);
        require_numbers(mesh, result);
        if (chosen == k_all_defects) require_net(mesh, result.mesh);
    } catch (const Error& error) {
        fuzz::require_readable(error);
        require(error.code() == ErrorCode::bad_option || error.code() == ErrorCode::non_finite,
                std::string("repair refuses with ") + error.what());
    }
    return 0;
}
