#include "samples.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numeric>

#include "io/obj.h"
#include "net/measures.h"
#include "shapes/shapes.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

json edit_entry(int vertex, const Eigen::Vector3d& target) {
    return {{"vertex", vertex}, {"target", {target.x(), target.y(), target.z()}}};
}

json pull_edit(double fraction) {
    const Shape shape = make_shape(k_recipe);
    const Positions& rest = shape.net.rest_positions();
    const Eigen::Vector3d middle = rest.rowwise().mean();
    json edit{{"handles", json::array()}, {"comment", "passed over"}};
    for (const int vertex : shape.suggested_handles) {
        const double t = vertex == shape.suggested_handles.back() ? fraction : 0;
        edit["handles"].push_back(edit_entry(vertex, (1 - t) * rest.col(vertex) + t * middle));
    }
    return edit;
}

json unreachable_edit() { return {{"handles", {edit_entry(0, {0, 0, 0}), edit_entry(200, {1000, 0, 0})}}}; }

int line_count(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

int sum(const json& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0, [](int n, const json& c) { return n + c.get<int>(); });
}

double handle_distance(const Positions& positions, const json& edit) {
    double largest = 0;
    for (const json& handle : edit["handles"]) {
        const auto target = handle["target"].get<std::array<double, 3>>();
        const Eigen::Vector3d position = positions.col(handle["vertex"].get<int>());
        largest = std::max(largest, (position - Eigen::Vector3d::Map(target.data())).norm());
    }
    return largest;
}

double max_deviation_of_file(const Sandbox& box, const std::string& name) {
    return max_deviation(make_shape(k_recipe).net, read_obj(box.read(name), name).positions);
}

void write_stretched_vault(const Sandbox& box, const std::string& name) {
    const Net net = make_shape(k_recipe).net;
    box.write(name, write_obj(Eigen::Vector3d(1, 2, 3).asDiagonal() * net.rest_positions(), net.faces()));
}

void check_shape_report(const json& report) {
    for (const char* key : {"max_dL", "max_handle_error", "bend"}) CHECK(report.at(key).is_number());
    CHECK(report.at("unreachable_pairs").is_array());
    CHECK(report.at("smallest_corner_angle_degrees") > 0);
    CHECK(report.at("largest_corner_angle_degrees") <= 180);
}

void write_grid(const Sandbox& box, const std::string& name, int n, bool is_ring,
                const std::function<Eigen::Vector3d(double, double)>& at) {
    const int columns = is_ring ? n - 1 : n;
    Mesh mesh{Positions(3, columns * n), {}};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto vertex = [&](int k, int l) { return l * columns + k % columns; };
            if (i < columns) mesh.positions.col(vertex(i, j)) = at(i / (n - 1.), j / (n - 1.));
            if (i + 1 < n && j + 1 < n)
                mesh.faces.add({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    box.write(name, write_obj(mesh.positions, mesh.faces));
}

void write_saddle(const Sandbox& box, const std::string& name, int n) {
    write_grid(box, name, n, false, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, x * y / 2);
    });
}

void check_refused(const Run& run, const std::string& what) {
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(line_count(run.err) == 1);
    CHECK(run.err.size() < 500);
    CHECK_THAT(run.err, Catch::Matchers::StartsWith("chebnet: ") && Contains(what));
}
