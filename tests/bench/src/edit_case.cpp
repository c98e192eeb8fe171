#include "edit_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <filesystem>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "edit_file.h"
#include "io/file.h"
#include "io/obj.h"
#include "shapes/shapes.h"

namespace chebnet::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_size_key = ":vertices=";
constexpr int k_file_handles = 4;    // of an edit made for a file: three anchors and one to move
constexpr double k_reserve = 1.1;    // the edit taken this much farther must still be within reach of the net
constexpr double k_shrinking = 0.7;  // of the motion, as long as it is not

/// Vertices far from one another along the net; the first is far from vertex 0.
std::vector<int> spread_vertices(const Net& net, int count) {
    const Topology topology(net);
    const auto farthest = [](const std::vector<double>& distances) {
        return static_cast<int>(std::ranges::max_element(distances) - distances.begin());
    };
    std::vector<int> chosen{farthest(topology.distances_from(0))};
    std::vector<double> nearest = topology.distances_from(chosen.front());
    while (static_cast<int>(chosen.size()) < count) {
        chosen.push_back(farthest(nearest));
        const auto distances = topology.distances_from(chosen.back());
        std::ranges::transform(nearest, distances, nearest.begin(), [](double a, double b) { return std::min(a, b); });
    }
    return chosen;
}

Shape open_shape(const EditCase& edit) {
    if (edit.is_recipe()) return make_shape(edit.net);
    Mesh mesh = read_obj(read_file(edit.net), edit.net);
    Net net(std::move(mesh.positions), std::move(mesh.faces));
    std::vector<int> handles = spread_vertices(net, k_file_handles);
    return {std::move(net), std::move(handles)};
}

double diagonal(const Net& net) {
    return (net.rest_positions().rowwise().maxCoeff() - net.rest_positions().rowwise().minCoeff()).norm();
}

/// Where the dragged handle goes from `arm`, its place seen from the middle of the anchors. `amount` 1: the whole way.
Eigen::Vector3d moved(const Eigen::Vector3d& arm, const std::string& kind, double size, double amount) {
    constexpr double degree = std::numbers::pi / 180;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    if (kind == "pull") return arm + amount * 0.2 * size * up;
    if (kind == "spread") return arm + amount * 0.15 * size * arm.normalized();
    // An upright arm has no direction to bend in, and would twist on the spot.
    const Eigen::Vector3d across = up.cross(arm);
    const bool upright = across.norm() < 0.1 * arm.norm();
    const Eigen::Vector3d side = Eigen::Vector3d::UnitX();
    if (kind == "twist") return Eigen::AngleAxisd(amount * 60 * degree, upright ? side : up) * arm;
    if (kind != "bend") throw Error(ErrorCode::bad_option, "there is no edit \"" + kind + "\"");
    return Eigen::AngleAxisd(-amount * 45 * degree, upright ? side : across.normalized()) * arm;
}

std::vector<Handle> move_last(const Net& net, const std::vector<int>& vertices, const std::string& kind,
                              double amount) {
    std::vector<Handle> handles;
    for (const int vertex : vertices) handles.push_back({vertex, net.rest_positions().col(vertex)});
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i + 1 < handles.size(); ++i) middle += handles[i].target;
    middle /= std::max<double>(1, static_cast<double>(handles.size()) - 1);
    Handle& last = handles.back();
    last.target = middle + moved(last.target - middle, kind, diagonal(net), amount);
    return handles;
}

/// The motion of the last handle, shortened until the net is long enough for it.
std::vector<Handle> generate_edit(const Net& net, const std::vector<int>& vertices, const std::string& kind) {
    Editor editor(net);
    double amount = 1;
    for (; amount > 0.01; amount *= k_shrinking) {
        editor.set_handles(move_last(net, vertices, kind, k_reserve * amount));
        if (editor.unreachable_pairs().empty()) break;
    }
    return move_last(net, vertices, kind, amount);
}

}  // namespace

std::string EditCase::name() const {
    const std::size_t size = net.find(k_size_key);
    if (!is_recipe()) return fs::path(net).stem().string() + '.' + kind;
    if (size == net.npos) return net + '.' + kind;
    return net.substr(0, size) + '_' + net.substr(size + k_size_key.size()) + '.' + kind;
}

const std::vector<std::string>& edit_kinds() {
    static const std::vector<std::string> kinds{"pull", "bend", "spread", "twist"};
    return kinds;
}

Edit make_problem(const EditCase& edit) {
    Shape shape = open_shape(edit);
    std::vector<Handle> handles = edit.edit_file.empty() ? generate_edit(shape.net, shape.suggested_handles, edit.kind)
                                                         : read_edit(edit.edit_file, shape.net.vertex_count());
    return {std::move(shape.net), std::move(handles)};
}

std::vector<EditCase> cases_of_folder(const std::string& nets_folder, const std::string& edits_folder) {
    if (!fs::is_directory(nets_folder)) throw Error(ErrorCode::file_access, nets_folder + ": not a folder");
    std::vector<std::string> nets;
    for (const auto& entry : fs::directory_iterator(nets_folder))
        if (entry.path().extension() == ".obj") nets.push_back(entry.path().string());
    std::ranges::sort(nets);
    std::vector<EditCase> cases;
    for (const std::string& net : nets)
        for (const std::string& kind : edit_kinds()) {
            const fs::path file = fs::path(edits_folder) / (fs::path(net).stem().string() + "." + kind + ".json");
            const bool has_file = !edits_folder.empty() && fs::exists(file);
            cases.push_back({net, kind, has_file ? file.string() : ""});
        }
    return cases;
}

}  // namespace chebnet::bench
