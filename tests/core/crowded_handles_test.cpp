#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "edit/editor.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/method.h"

using namespace chebnet;

namespace {

/// Targets of handles such that no net, or only a folded one, can follow.
struct Crowd {
    const char* name;
    Eigen::Vector3d (*place)(const Eigen::Vector3d& rest, int i);
};

const std::vector<Crowd> k_crowds{
    {"at one place",
     [](const Eigen::Vector3d&, int) -> Eigen::Vector3d {
         return {1, 2, 3};
     }},
    {"at two places",
     [](const Eigen::Vector3d&, int i) -> Eigen::Vector3d {
         return {i % 2 * 4.0, 0, 0};
     }},
    {"on a line",
     [](const Eigen::Vector3d& rest, int) -> Eigen::Vector3d {
         return {rest.x(), 0, 0};
     }},
    {"on a line, a step apart",
     [](const Eigen::Vector3d&, int i) -> Eigen::Vector3d {
         return {i * 1.0, 0, 0};
     }},
    {"at places almost the same",
     [](const Eigen::Vector3d&, int i) -> Eigen::Vector3d {
         return {1 + 1e-14 * i, 2, 3};
     }},
};

/// A few, a line of the net, and every vertex.
std::vector<std::vector<int>> choices(const Net& net) {
    std::vector<int> row, all;
    for (int v = 0; v < net.vertex_count(); ++v) all.push_back(v);
    for (int v = 0; v < 9; ++v) row.push_back(v);
    return {{0, 8, 63, 71}, row, {0, 1}, all};
}

}  // namespace

TEST_CASE("Handles at one place or in a line end soon, with a status that is true and positions that are finite") {
    const Net net = samples::patch(9, 8);
    for (const MethodInfo& method : method_table())
        for (const Crowd& crowd : k_crowds)
            for (const std::vector<int>& vertices : choices(net)) {
                CAPTURE(method.name, crowd.name, vertices.size());
                Editor editor(net);
                editor.set_method(method.name);
                editor.set_option("max_iterations", "200");
                std::vector<Handle> handles = samples::handles_at_rest(net, vertices);
                for (std::size_t i = 0; i < handles.size(); ++i)
                    handles[i].target = crowd.place(handles[i].target, static_cast<int>(i));
                editor.set_handles(handles);
                const SolveReport report = editor.solve();
                CHECK(report.status != Status::running);
                CHECK(report.status != Status::non_finite);
                CHECK(editor.positions().allFinite());
                CHECK(editor.handle_error() == 0);
                const bool is_net = max_deviation(net, editor.positions()) < editor.options().threshold;
                CHECK((report.status == Status::converged) == is_net);
                if (!editor.unreachable_pairs().empty()) CHECK(report.status == Status::unreachable);

                editor.reset();
                CHECK(editor.solve().status == Status::converged);
            }
}
