#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "change/change.h"
#include "io/mesh_file.h"
#include "io/obj.h"
#include "net/measures.h"
#include "program.h"
#include "shapes/shapes.h"
#include "solve/method.h"
#include "solve/options.h"
#include "surface/guide.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

const std::string k_recipe = "vault:vertices=400";

json edit_entry(int vertex, const Eigen::Vector3d& target) {
    return {{"vertex", vertex}, {"target", {target.x(), target.y(), target.z()}}};
}

/// Anchors at rest; the last handle goes the given fraction of the way to the middle of the net.
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

/// Two vertices of a net about 10 across, 1000 apart.
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

/// A saved result, measured against the lengths of the net it came from.
double max_deviation_of_file(const Sandbox& box, const std::string& name) {
    return max_deviation(make_shape(k_recipe).net, read_obj(box.read(name), name).positions);
}

/// A quad mesh whose edges differ in length.
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

/// n × n vertices at(u, v) for u and v from 0 to 1; of a ring the first and the last for u are the same.
template <class At>
void write_grid(const Sandbox& box, const std::string& name, int n, bool is_ring, At at) {
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

/// The saddle z = x y / 2 over a square.
void write_saddle(const Sandbox& box, const std::string& name, int n) {
    write_grid(box, name, n, false, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, x * y / 2);
    });
}

/// A user sees exit code 2, nothing on standard output, and one line that holds `what`.
void check_refused(const Run& run, const std::string& what) {
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(line_count(run.err) == 1);
    CHECK(run.err.size() < 500);
    CHECK_THAT(run.err, Catch::Matchers::StartsWith("chebnet: ") && Contains(what));
}

}  // namespace

TEST_CASE("help and version answer on standard output") {
    const Sandbox box;
    for (const char* arguments :
         {"--help", "info --help", "make --help", "convert --help", "solve --help", "drag --help", "equalize --help",
          "change --help", "drape --help", "remesh --help", "--version"}) {
        const Run run = box.run(arguments);
        INFO(arguments);
        CHECK(run.exit_code == 0);
        CHECK(run.err.empty());
        CHECK_THAT(run.out, Contains("chebnet") || Contains("Usage"));
    }
}

TEST_CASE("the help of solve and drag lists every method and option") {
    const Sandbox box;
    for (const char* arguments : {"solve --help", "drag --help"}) {
        const std::string help = box.run(arguments).out;
        for (const MethodInfo& method : method_table()) CHECK_THAT(help, Contains(method.name));
        for (const OptionInfo& option : option_table()) CHECK_THAT(help, Contains(option.name));
    }
}

TEST_CASE("make --list shows every shape with its parameters") {
    const Run run = Sandbox().run("make --list");
    CHECK(run.exit_code == 0);
    for (const ShapeInfo& shape : shape_table()) {
        CHECK_THAT(run.out, Contains(shape.name));
        for (const ShapeParameter& parameter : shape.parameters) CHECK_THAT(run.out, Contains(parameter.name));
    }
}

TEST_CASE("info describes a recipe, and the same for the file made from it") {
    const Sandbox box;
    for (const ShapeInfo& shape : shape_table()) {
        const std::string recipe = std::string(shape.name) + ":vertices=300";
        INFO(recipe);
        CHECK(box.run("make " + recipe + " -o net.obj").exit_code == 0);
        json of_recipe = box.run("info " + recipe).json(), of_file = box.run("info net.obj").json();
        CHECK(of_recipe.at("max_dL") < 1e-20);
        CHECK(of_recipe.at("chebyshev") == true);
        for (const char* key : {"vertices", "edges", "faces", "components"}) CHECK(of_recipe.at(key) > 0);
        CHECK(of_recipe.at("mean_length") > 0);
        CHECK(of_recipe.at("singular_vertices_by_valence").is_object());
        of_recipe.erase("net"), of_file.erase("net");
        CHECK(of_recipe == of_file);
    }
}

TEST_CASE("info says how many vertices stand at the place of an earlier one, and that they can be merged") {
    const Sandbox box;
    box.write("apart.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n"
              "f 1 2 3 4\nf 5 6 7 8\n");
    const Run apart = box.run("info apart.obj"), merged = box.run("info apart.obj --repair");
    CHECK(apart.exit_code == 0);
    CHECK(apart.json().at("coinciding_vertices") == 2);
    CHECK(apart.json().at("components") == 2);
    CHECK(line_count(apart.err) == 1);
    CHECK_THAT(apart.err,
               Contains("apart.obj: 2 vertices at the place of an earlier one: 4, 7 (--repair merges them)"));
    CHECK(merged.json().at("coinciding_vertices") == 0);
    CHECK(merged.json().at("components") == 1);
    for (const ShapeInfo& shape : shape_table()) {
        CAPTURE(shape.name);
        const Run own = box.run("info " + std::string(shape.name) + ":vertices=200");
        CHECK(own.err.empty());
        CHECK(own.json().at("coinciding_vertices") == 0);
    }
}

TEST_CASE("info says how a net lies on a surface, as draping it did") {
    const Sandbox box;
    const json draped = box.run("drape --surface hypar --cells 300 -o net.obj").json().at("net");
    const json found = box.run("info net.obj --surface hypar").json().at("on_surface");
    CHECK(found.at("coverage") == draped.at("coverage"));
    CHECK(found.at("gaps") == draped.at("gaps"));
    CHECK(found.at("mean_distance").get<double>() == Approx(draped.at("mean_distance").get<double>()));
    check_refused(box.run("info net.obj --surface nowhere.obj"), "nowhere.obj");
}

TEST_CASE("info writes the edges and their lengths") {
    const Sandbox box;
    box.write("kite.obj", "v 0 0 0\nv 1 0 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4\n");
    CHECK(box.run("info kite.obj --edges edges.csv").json().at("edges") == 4);
    CHECK_THAT(box.read("edges.csv"),
               Catch::Matchers::StartsWith("edge,vertex_a,vertex_b,length,rest_length,deviation\n"
                                           "0,0,1,1,1,0\n1,0,3,3,3,0\n"));
    check_refused(box.run("info kite.obj --edges no/such/folder.csv"), "no/such/folder.csv");
}

TEST_CASE("info and solve write the rods, with the marks where others cross them") {
    const Sandbox box;
    box.write("two.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n");
    CHECK(box.run("info two.obj --rods rods.csv").exit_code == 0);
    const std::string rods = box.read("rods.csv");
    CHECK_THAT(rods, Catch::Matchers::StartsWith("rod,edges,length,closed,vertices,marks\n0,2,2,0,0 1 2,0 1 2\n"));
    box.write("edit.json", R"({"handles": [{"vertex": 0, "target": [0, 0, 0]}]})");
    CHECK(box.run("solve two.obj --edit edit.json --rods again.csv").exit_code == 0);
    CHECK(box.read("again.csv") == rods);
}

TEST_CASE("info measures lengths against their mean") {
    const Sandbox box;
    box.write("kite.obj", "v 0 0 0\nv 1 0 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4\n");
    const json info = box.run("info kite.obj").json();
    CHECK(info.at("mean_length") == 2);
    CHECK(info.at("shortest_length") == 1);
    CHECK(info.at("longest_length") == 3);
    CHECK(info.at("faces_by_arity") == json{{"4", 1}});
    CHECK(info.at("max_dL").get<double>() == Approx(0.5 + 1 / 0.5 - 2));
    CHECK(info.at("chebyshev") == false);
    CHECK(info.at("boundary_loops") == 1);
}

TEST_CASE("Of an edit that crumples a net it is said at how many edges, and what may help") {
    const Sandbox box;
    box.write("edit.json",
              R"({"handles": [{"vertex": 0, "target": [-5, -5, 0]}, {"vertex": 224, "target": [-3, -3, 0]}]})");
    const std::string solve = "solve sheet:vertices=225 --edit edit.json --method ";
    const Run by_lengths = box.run(solve + "projection"), at_rest = box.run(solve + "equilibrium");
    CHECK(by_lengths.exit_code == 0);
    CHECK_THAT(by_lengths.err, Contains("crumpled") && Contains("--method equilibrium"));
    CHECK(by_lengths.json().at("folds_over_60_degrees") > 0);
    CHECK(at_rest.err.empty());
    CHECK(at_rest.json().at("folds_over_60_degrees") == 0);
}

TEST_CASE("solve reports, and writes the net, its edges and the trace") {
    const Sandbox box;
    const json edit = pull_edit(0.2);
    box.write("pull.json", edit.dump());
    const Run run = box.run("solve " + k_recipe + " --edit pull.json -o out.obj --trace trace.csv --edges edges.csv");
    INFO(run.err);
    CHECK(run.exit_code == 0);

    const json report = run.json();
    check_shape_report(report);
    CHECK(report.at("net") == k_recipe);
    CHECK(report.at("method") == std::string(k_default_method));
    CHECK(report.at("status") == "converged");
    CHECK(report.at("max_dL") < 1e-6);
    CHECK(report.at("max_handle_error") == 0);
    CHECK(report.at("iterations") > 0);
    CHECK(report.at("iterations") == sum(report.at("iterations_by_stage")));
    CHECK(report.at("milliseconds") >= report.at("factorisation_milliseconds"));

    CHECK(max_deviation_of_file(box, "out.obj") == report.at("max_dL"));
    CHECK(handle_distance(read_obj(box.read("out.obj"), "out.obj").positions, edit) == 0);
    CHECK(line_count(box.read("trace.csv")) == report.at("iterations").get<int>() + 1);
    CHECK(line_count(box.read("edges.csv")) == box.run("info out.obj").json().at("edges").get<int>() + 1);
}

TEST_CASE("every method solves by its name") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.1).dump());
    for (const MethodInfo& method : method_table()) {
        const Run run = box.run("solve " + k_recipe + " --edit pull.json --method " + method.name);
        INFO(method.name << run.err);
        CHECK(run.exit_code <= 1);
        CHECK(run.json().at("method") == method.name);
    }
}

TEST_CASE("a net so large that nobody waits for it to rest is solved by its edges alone, unless asked otherwise") {
    const Sandbox box;
    box.write("edit.json", R"({"handles": [{"vertex": 0, "target": [0, 0, 0]}]})");
    const auto method = [&](const std::string& arguments) {
        return box.run("solve " + arguments + " --edit edit.json --max-iterations 1").json().at("method");
    };
    CHECK(method("sheet:vertices=900") == "equilibrium");
    CHECK(method("sheet:vertices=14400") == "projection");
    CHECK(method("sheet:vertices=900 --method li2022") == "li2022");
}

TEST_CASE("feet that slide on the ground come in when the middle of a sheet is raised, others hold it down") {
    const Sandbox box;
    const Positions rest = make_shape("sheet:vertices=121").net.rest_positions();
    const std::vector<int> feet{5, 55, 65, 115};  // in the middle of each side
    const auto raise = [&](const char* slides) {
        json edit{{"handles", {edit_entry(60, {0, 0, 1.5})}}};
        for (int foot : feet) {
            edit["handles"].push_back(edit_entry(foot, rest.col(foot)));
            if (slides != nullptr) edit["handles"].back()["slides"] = slides;
        }
        box.write("edit.json", edit.dump());
        return box.run("solve sheet:vertices=121 --edit edit.json -o out.obj").json().at("status");
    };
    CHECK(raise(nullptr) == "unreachable");
    CHECK(raise("yx") == "converged");
    const Positions out = read_obj(box.read("out.obj"), "out.obj").positions;
    for (int foot : feet) {
        CHECK(out(2, foot) == rest(2, foot));
        CHECK(out.col(foot).norm() < rest.col(foot).norm() - 0.05);
    }
}

TEST_CASE("solve reports the forces that hold a heavy sheet, and writes those of its edges") {
    const Sandbox box;
    const json info = box.run("info sheet:vertices=100").json();
    const double length = info.at("mean_length");
    json edit{{"handles", json::array()}};
    for (const int corner : {0, 9, 90, 99}) {
        const Eigen::Vector3d rest = make_shape("sheet:vertices=100").net.rest_positions().col(corner);
        edit["handles"].push_back(edit_entry(corner, 0.95 * rest + Eigen::Vector3d(0, 0, length)));
    }
    box.write("edit.json", edit.dump());
    const std::string solve = "solve sheet:vertices=100 --edit edit.json --edges edges.csv --set gravity=0.01 ";
    const json report = box.run(solve).json();
    CHECK(report.at("to_rest").at("gradient_norm") < 1e-4);
    CHECK(report.at("to_rest").at("corner_lack_in_lengths") < 1e-3);
    double up = 0, energy = 0;
    for (const json& handle : report.at("handle_forces")) up += handle.at("force")[2].get<double>();
    CHECK(up == Approx(0.01 * info.at("edges").get<double>()).epsilon(1e-3));
    for (const char* term : {"bending", "shear", "gravity"}) energy += report.at("energies").at(term).get<double>();
    CHECK(energy != 0);
    CHECK(report.at("edge_that_pulls_most").at("force") > report.at("edge_that_pushes_most").at("force"));
    CHECK_THAT(box.read("edges.csv"), Contains("deviation,force\n"));

    const json without = box.run(solve + "--method projection").json();
    CHECK(without.at("to_rest").is_null());
    CHECK_FALSE(without.contains("handle_forces"));
    CHECK_THAT(box.read("edges.csv"), Contains("deviation\n"));
}

TEST_CASE("the shear limit is asked for by name") {
    const Sandbox box;
    // Ten quads between corners 17.5 edges apart: their diagonals leave corners of 57.7 degrees at most.
    box.write("edit.json", R"({"handles": [{"vertex": 0, "target": [-6.2, -6.2, 0]},
                                           {"vertex": 99, "target": [6.2, 6.2, 0]}]})");
    const auto status = [&](const std::string& limit) {
        return box.run("solve sheet:vertices=100 --edit edit.json --shear-limit " + limit).json().at("status");
    };
    CHECK(status("0") == "converged");
    CHECK(status("50") == "converged");
    CHECK(status("60") == "stalled");
}

TEST_CASE("edges grow as little as handles beyond reach ask for, or by the scale that is given") {
    const Sandbox box;
    // Ten quads in a row, 9 edges along each side, pulled by the ends of a side to 1.5 times as far.
    const double length = box.run("info sheet:vertices=100").json().at("mean_length");
    box.write(
        "edit.json",
        json{{"handles", {{{"vertex", 0}, {"target", {0, 0, 0}}}, {{"vertex", 9}, {"target", {13.5 * length, 0, 0}}}}}}
            .dump());
    const std::string edit = "sheet:vertices=100 --edit edit.json ";
    const auto scale = [&](const std::string& arguments) {
        const auto done = box.run(arguments);
        CHECK(done.json().at("max_dL") < 1e-9);
        CHECK(done.json().at("max_handle_error") == 0);
        return done.json().at("length_scale").get<double>();
    };
    const Run alone_before = box.run("solve " + edit);
    CHECK(alone_before.json().at("status") == "unreachable");
    CHECK_THAT(alone_before.err, Contains("--adapt-lengths"));
    CHECK(scale("solve " + edit + "--adapt-lengths") == Approx(1.5));
    CHECK(scale("drag " + edit + "--frames 3 --adapt-lengths") == Approx(1.5));
    CHECK(scale("solve " + edit + "--length-scale 2") == 2);

    // All solves are told of, and the search between them apart.
    const json alone = box.run("solve " + edit).json();
    const json adapted = box.run("solve " + edit + "--adapt-lengths --trace trace.csv").json();
    CHECK(adapted.at("search_for_lengths").at("iterations") > 0);
    CHECK(adapted.at("iterations") >= alone.at("iterations"));
    CHECK(sum(adapted.at("iterations_by_stage")) == line_count(box.read("trace.csv")) - 1);
    CHECK_FALSE(alone.contains("search_for_lengths"));
    check_refused(box.run("solve " + edit + "--length-scale 5"), "length_scale");
}

TEST_CASE("A search for rest ends at the same net whether handles jump or are dragged") {
    const Sandbox box;
    // Two opposite corners come nearer to each other, and a vertex near the middle goes down between them.
    const json handles{{{"vertex", 0}, {"target", {-5, -5, 0}}},
                       {{"vertex", 399}, {"target", {5, 5, 0}}},
                       {{"vertex", 210}, {"target", {-0.0963, 0.3595, 0}}}};
    box.write("twist.json", json{{"handles", handles}}.dump());
    const std::string edit = "sheet:vertices=400 --edit twist.json ";
    const json jump = box.run("solve " + edit + "--search-rest").json();
    const json drag = box.run("drag " + edit + "--frames 10 --search-rest").json();
    const auto energy = [](const json& report) { return report.at("search_for_rest").at("energy").get<double>(); };
    CHECK(energy(jump) < 0.5 * jump.at("search_for_rest").at("energy_before").get<double>());
    CHECK(energy(jump) == Approx(energy(drag)).epsilon(1e-4));
    for (const json& report : {jump, drag}) {
        CHECK(report.at("status") == "converged");
        CHECK(report.at("max_dL") < 1e-9);
        CHECK(report.at("max_handle_error") == 0);
    }
    CHECK_FALSE(box.run("solve " + edit).json().contains("search_for_rest"));
    check_refused(box.run("solve " + edit + "--method projection --search-rest"), "brings no net to rest");
}

TEST_CASE("options reach the solver, by short names too") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    const std::string solve = "solve " + k_recipe + " --edit pull.json --method li2022 ";
    const json loose = box.run(solve + "--threshold 1e-3").json();
    CHECK(loose.at("iterations") < box.run(solve).json().at("iterations"));
    CHECK(loose.at("iterations") == box.run(solve + "--set adaptive_p=on threshold=1e-3").json().at("iterations"));
    CHECK(loose.at("iterations") ==
          box.run(solve + "--set adaptive_p=on --set threshold=1e-3").json().at("iterations"));
}

TEST_CASE("a solve can begin from another start") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    for (const char* start : {"naive", "arap:5", "local_global:5"}) {
        const Run run = box.run("solve " + k_recipe + " --edit pull.json --init " + start);
        INFO(start << run.err);
        CHECK(run.exit_code == 0);
        CHECK(run.json().at("max_dL") < 1e-6);
    }
}

TEST_CASE("a run that does not converge ends with 1 and still reports and writes") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    const Run run = box.run("solve " + k_recipe + " --edit pull.json --method li2022 --max-iterations 1 -o out.obj");
    CHECK(run.exit_code == 1);
    CHECK(line_count(run.err) == 1);
    CHECK_THAT(run.err, Contains("the iteration limit, 1, was reached") && Contains("--max-iterations"));
    CHECK(run.json().at("status") == "max_iterations");
    CHECK(run.json().at("iterations") == 1);
    CHECK(box.has("out.obj"));
}

TEST_CASE("a solve that gets stuck says so, and which method finds a net") {
    const Sandbox box;
    box.write("edit.json",
              R"({"handles": [{"vertex": 0, "target": [-5, -5, 0]}, {"vertex": 224, "target": [-3, -3, 0]}]})");
    const std::string solve = "solve sheet:vertices=225 --edit edit.json --method ";
    const Run stuck = box.run(solve + "arap");
    CHECK(stuck.exit_code == 1);
    CHECK(stuck.json().at("status") == "stalled");
    CHECK(line_count(stuck.err) == 1);
    CHECK_THAT(stuck.err, Contains("stuck: ") && Contains("--method equilibrium"));
    CHECK(box.run(solve + "equilibrium").exit_code == 0);
}

TEST_CASE("a solve with exact edges and handles that has not come to rest ends with 0") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    const Run run = box.run("solve " + k_recipe + " --edit pull.json --set rest_tolerance=0 -o out.obj");
    CHECK(run.exit_code == 0);
    CHECK(run.json().at("status") == "exact");
    CHECK(run.json().at("max_handle_error") == 0);
    CHECK(max_deviation_of_file(box, "out.obj") < 1e-9);
}

TEST_CASE("a solve that has used up its iterations with exact edges and handles ends with 0") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    const Run run = box.run("solve " + k_recipe + " --edit pull.json --set rest_tolerance=0 --max-iterations 10");
    CHECK(run.exit_code == 0);
    CHECK(run.json().at("status") == "max_iterations");
    CHECK(run.json().at("max_handle_error") == 0);
    CHECK(run.json().at("max_dL") < 1e-6);
}

TEST_CASE("handles out of reach are named") {
    const Sandbox box;
    box.write("far.json", unreachable_edit().dump());
    const Run run = box.run("solve " + k_recipe + " --edit far.json -o out.obj");
    CHECK(run.exit_code == 1);
    CHECK(line_count(run.err) == 1);
    CHECK_THAT(run.err, Contains("handles 0 and 200 are to be 1000 apart") && !Contains("--adapt-lengths"));
    const json report = run.json();
    CHECK(report.at("status") == "unreachable");
    REQUIRE(report.at("unreachable_pairs").size() == 1);
    const json& pair = report.at("unreachable_pairs")[0];
    CHECK(pair.at("vertices") == json{0, 200});
    CHECK(pair.at("distance") == 1000);
    CHECK(pair.at("reach") < 1000);
    CHECK(max_deviation_of_file(box, "out.obj") < std::numeric_limits<double>::infinity());
}

TEST_CASE("drag reports every frame") {
    const Sandbox box;
    const json edit = pull_edit(0.2);
    box.write("pull.json", edit.dump());
    const Run run = box.run("drag " + k_recipe + " --edit pull.json --frames 5 -o out.obj --trace trace.csv");
    INFO(run.err);
    CHECK(run.exit_code == 0);

    const json report = run.json();
    check_shape_report(report);
    CHECK(report.at("status") == "converged");
    CHECK(report.at("max_handle_error") == 0);
    CHECK(report.at("median_milliseconds") <= report.at("percentile_95_milliseconds"));
    const json& frames = report.at("frames");
    REQUIRE(frames.size() == 5);
    int iterations = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        CHECK(frames[i].at("frame") == i + 1);
        CHECK(frames[i].at("status") == "converged");
        CHECK(frames[i].at("max_dL") < 1e-6);
        CHECK(frames[i].at("milliseconds").is_number());
        iterations += frames[i].at("iterations").get<int>();
    }
    CHECK(handle_distance(read_obj(box.read("out.obj"), "out.obj").positions, edit) == 0);
    CHECK_THAT(box.read("trace.csv"), Catch::Matchers::StartsWith("frame,iteration,"));
    CHECK(line_count(box.read("trace.csv")) == iterations + 1);
}

TEST_CASE(
    "a drag beyond where the net goes is held back: every frame is a net within the limit, and that ends with 1") {
    const Sandbox box;
    const double far = 20 * box.run("info sheet:vertices=100").json().at("mean_length").get<double>();
    box.write("far.json", json{{"handles", {edit_entry(0, {-far, -far, 0}), edit_entry(99, {far, far, 0})}}}.dump());
    const Run run = box.run("drag sheet:vertices=100 --edit far.json --frames 10");
    INFO(run.err);
    CHECK(run.exit_code == 1);
    const json report = run.json();
    CHECK(report.at("is_held_back") == true);
    CHECK(report.at("max_dL") < 1e-6);
    CHECK(report.at("smallest_corner_angle_degrees") >= 29.5);
    CHECK(report.at("folds_over_60_degrees") == 0);
    for (const json& frame : report.at("frames")) CHECK(frame.at("max_dL") < 1e-6);
    CHECK(line_count(run.err) == 1);
    CHECK_THAT(run.err, Contains("handles were held back") && Contains("--adapt-lengths"));
    CHECK(box.run("drag sheet:vertices=100 --edit far.json --frames 10 --adapt-lengths").exit_code == 0);
}

TEST_CASE("a drag that the iteration limit stops on its way is not called held back, and goes farther with more") {
    const Sandbox box;
    // A strip of 120 x 3 vertices, its end pushed to three tenths of its length.
    constexpr int n = 120;
    Mesh strip{Positions(3, 3 * n), {}};
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 3; ++j) {
            const int v = 3 * i + j;
            strip.positions.col(v) << i, j, 0;
            if (i + 1 < n && j < 2) strip.faces.add({v, v + 3, v + 4, v + 1});
        }
    box.write("strip.obj", write_obj(strip.positions, strip.faces));
    const json ends = {edit_entry(0, {0, 0, 0}), edit_entry(2, {0, 2, 0}), edit_entry(3 * n - 3, {0.3 * (n - 1), 0, 0}),
                       edit_entry(3 * n - 1, {0.3 * (n - 1), 2, 0})};
    box.write("push.json", json{{"handles", ends}}.dump());
    const std::string drag = "drag strip.obj --edit push.json --frames ";
    const Run stopped = box.run(drag + "10 --max-iterations 20");
    CHECK(stopped.exit_code == 1);
    CHECK(stopped.json().at("status") == "max_iterations");
    CHECK(stopped.json().at("is_held_back") == false);
    CHECK(stopped.json().at("max_handle_error") > 1);
    CHECK_THAT(stopped.err,
               Contains("the iteration limit, 20, stopped handles on their way") && !Contains("held back"));
    for (const char* more : {"10 --max-iterations 1000", "60"}) CHECK(box.run(drag + more).exit_code == 0);
}

TEST_CASE("a drag comes to the same net in whatever order the file has handles that move and handles that stay") {
    const Sandbox box;
    json edit = pull_edit(0.2);
    const auto end_of_drag = [&](const std::string& name) {
        box.write(name + ".json", edit.dump());
        const Run run = box.run("drag " + k_recipe + " --edit " + name + ".json --frames 5 -o " + name + ".obj");
        INFO(run.err);
        CHECK(run.exit_code == 0);
        CHECK(run.json().at("max_handle_error") == 0);
        return read_obj(box.read(name + ".obj"), name).positions;
    };
    const Positions mover_last = end_of_drag("last");
    std::reverse(edit["handles"].begin(), edit["handles"].end());
    CHECK((end_of_drag("first") - mover_last).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("what a surface does to the net needs a surface") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    check_refused(box.run("solve " + k_recipe + " --edit pull.json --guide-mode near"), "--guide");
    const std::string guided = "solve " + k_recipe + " --edit pull.json --guide hypar --method ";
    CHECK_THAT(box.run(guided + "projection").err, Contains("method projection does nothing with a guide"));
    CHECK(box.run(guided + "equilibrium").err.empty());
}

TEST_CASE("a drag with a frame that does not converge ends with 1") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    const Run run = box.run("drag " + k_recipe + " --edit pull.json --method li2022 --frames 2 --max-iterations 1");
    CHECK(run.exit_code == 1);
    CHECK(run.json().at("frames").size() == 2);
    CHECK_THAT(run.err, Contains("the iteration limit, 1, was reached"));
}

TEST_CASE("a drag whose last frame is a net and others are not ends with 1, and says how many") {
    const Sandbox box;
    const Positions rest = make_shape(k_recipe).net.rest_positions();
    const int last = static_cast<int>(rest.cols()) - 1;
    const Eigen::Vector3d goal = 0.8 * rest.col(last) + 0.2 * rest.rowwise().mean();
    const json handles = {edit_entry(0, rest.col(0)), edit_entry(19, rest.col(19)), edit_entry(last, goal)};
    box.write("pull.json", json{{"handles", handles}}.dump());
    const std::string drag = "drag " + k_recipe + " --edit pull.json --method projection --frames 10 --max-iterations ";
    const Run on_the_way = box.run(drag + "5"), longer = box.run(drag + "20");
    CHECK(on_the_way.exit_code == 1);
    CHECK(on_the_way.json().at("max_dL") < 1e-6);
    CHECK_THAT(on_the_way.err, Contains(" of the 10 frames; ") && Contains("--max-iterations"));
    CHECK(longer.exit_code == 0);
}

TEST_CASE("solve and drag keep a net near a guide, which is a file or one of ours") {
    const Sandbox box;
    CHECK(box.run("drape --surface hypar --cells 200 -o net.obj").exit_code == 0);
    const Positions x = read_obj(box.read("net.obj"), "").positions;
    const auto handle = [&](Eigen::Index v, double lift) {
        return json{{"vertex", v}, {"target", {x(0, v), x(1, v), x(2, v) + lift}}};
    };
    box.write("edit.json", json{{"handles", {handle(0, 0), handle(x.cols() - 1, 0.3)}}}.dump());
    const std::string arguments = "solve net.obj --edit edit.json --guide hypar --guide-mode ";
    const auto distance = [&](const char* mode) {
        const Run run = box.run(arguments + mode);
        INFO(run.err);
        CHECK(run.exit_code == 0);
        return run.json().at("distance_from_guide_in_lengths").at("mean").get<double>();
    };
    CHECK(distance("near") < distance("off"));
    CHECK(box.run("drag net.obj --edit edit.json --frames 2 --guide net.obj")
              .json()
              .contains("distance_from_guide_in_lengths"));
    check_refused(box.run(arguments + "inside"), "inside");
    check_refused(box.run("solve net.obj --edit edit.json --guide nothing.obj"), "nothing.obj");
}

TEST_CASE("A net that comes with nearly closed quads is opened, and the report says how many there were") {
    const Sandbox box;
    constexpr int n = 6;
    constexpr double sharp = 20 * EIGEN_PI / 180;
    Mesh rhombi{Positions(3, n * n), {}};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            rhombi.positions.col(j * n + i) << i + j * std::cos(sharp), j * std::sin(sharp), 0;
            if (i + 1 < n && j + 1 < n)
                rhombi.faces.add({j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i});
        }
    box.write("rhombi.obj", write_obj(rhombi.positions, rhombi.faces));
    box.write("edit.json", json{{"handles", {{{"vertex", 0}, {"target", {0, 0, 0}}}}}}.dump());
    const std::string solve = "solve rhombi.obj --edit edit.json";
    const json opened = box.run(solve).json();
    CHECK(opened.at("status") == "converged");
    CHECK(opened.at("quads_beyond_shear_limit") == json{{"at_rest", (n - 1) * (n - 1)}, {"now", 0}});
    const json wider = box.run(solve + " --shear-limit 15").json();
    CHECK(wider.at("quads_beyond_shear_limit") == json{{"at_rest", 0}, {"now", 0}});
    const json left = box.run(solve + " --shear-limit 0").json();
    CHECK(left.at("smallest_corner_angle_degrees") < 20.1);
    CHECK_FALSE(left.contains("quads_beyond_shear_limit"));
}

TEST_CASE("solve and drag say where corners stay sharp, with methods that keep to the limit") {
    const Sandbox box;
    // Handles leave a sheet hardly more than its diagonal.
    constexpr int n = 6;
    Mesh sheet{Positions(3, n * n), {}};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            sheet.positions.col(j * n + i) << i, j, 0;
            if (i + 1 < n && j + 1 < n)
                sheet.faces.add({j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i});
        }
    box.write("sheet.obj", write_obj(sheet.positions, sheet.faces));
    const json apart = {edit_entry(0, {0, 0, 0}), edit_entry(n * n - 1, {7, 7, 0})};
    box.write("apart.json", json{{"handles", apart}}.dump());
    const Run drawn = box.run("solve sheet.obj --edit apart.json");
    CHECK(drawn.exit_code == 0);
    CHECK(drawn.json().at("max_dL") < 1e-6);
    CHECK_THAT(drawn.err, Contains("25 quads have a corner sharper than 30 degrees"));
    CHECK_THAT(box.run("solve sheet.obj --edit apart.json --method projection").err, !Contains("sharper"));
    CHECK_THAT(box.run("solve sheet.obj --edit apart.json --shear-limit 0").err, !Contains("sharper"));
    const Run held = box.run("drag sheet.obj --edit apart.json --frames 20");
    CHECK(held.exit_code == 1);
    CHECK(held.json().at("is_held_back") == true);
    CHECK_THAT(held.err, !Contains("sharper"));

    // Short edges of a kite allow its tip no more.
    box.write("kite.obj", "v 0 0 0\nv 1 -0.08 0\nv 1.06 0 0\nv 1 0.08 0\nf 1 2 3 4\n");
    box.write("tip.json", json{{"handles", {edit_entry(0, {0, 0, 0})}}}.dump());
    for (const char* end : {"solve kite.obj --edit tip.json", "drag kite.obj --edit tip.json --frames 2"}) {
        const Run run = box.run(end);
        CHECK(run.exit_code == 0);
        CHECK(run.json().at("status") == "converged");
        CHECK(run.json().at("quads_beyond_shear_limit").at("now") == 1);
        CHECK_THAT(run.err, Contains("1 quad has a corner sharper than 30 degrees"));
    }
}

TEST_CASE("equalize and change say where corners stay sharp, and end with 0 as every edge has its length") {
    const Sandbox box;
    // A flat ring, its outer border three times as long as the inner one.
    constexpr int around = 30, rows = 10;
    Mesh ring{Positions(3, around * (rows + 1)), {}};
    for (int row = 0; row <= rows; ++row)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * EIGEN_PI * k / around, radius = 1 + 2.0 * row / rows;
            ring.positions.col(around * row + k) << radius * std::cos(angle), radius * std::sin(angle), 0;
            const int inner = around * row + k, beside = around * row + (k + 1) % around;
            if (row < rows) ring.faces.add({inner, beside, beside + around, inner + around});
        }
    box.write("ring.obj", write_obj(ring.positions, ring.faces));
    const Run run = box.run("equalize ring.obj -o net.obj");
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.err, Contains("a corner sharper than 30 degrees"));
    CHECK(run.json().at("status") == "exact");
    CHECK(run.json().at("quads_beyond_shear_limit") > 0);
    CHECK(run.json().at("smallest_corner_angle_degrees") < 30);
    CHECK(run.json().at("max_dL") < 1e-9);
    CHECK(box.has("net.obj"));

    const Run finer = box.run("change net.obj refine");
    CHECK(finer.exit_code == 0);
    CHECK_THAT(finer.err, Contains("a corner sharper than 30 degrees"));
    CHECK(finer.json().at("status") == "exact");
    CHECK(finer.json().at("max_dL") < 1e-9);
}

TEST_CASE("equalize says at how many edges its net is crumpled, and what may help, which does") {
    const Sandbox box;
    write_stretched_vault(box, "raw.obj");
    const std::string held = "equalize raw.obj --hold 0 200 --length ";
    const Run longer = box.run(held + "2"), mean = box.run(held + "mean");
    CHECK(longer.exit_code == 0);
    CHECK(longer.json().at("folds_over_60_degrees_before") == 0);
    CHECK(longer.json().at("folds_over_60_degrees") > 0);
    CHECK_THAT(longer.err, Contains("crumpled") && Contains("more than the mesh did; --length mean"));
    CHECK(mean.json().at("folds_over_60_degrees") == 0);
    CHECK(mean.err.empty());

    // Cells so many times wider outside than inside that no edges in these numbers have one length in the plane.
    write_grid(box, "ring.obj", 21, true, [](double u, double v) {
        const double turn = 2 * std::numbers::pi * u, radius = 1 + 2 * v;
        return Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), 0);
    });
    const Run of_edges_there = box.run("equalize ring.obj"), of_others = box.run("remesh ring.obj --cells 400");
    CHECK(of_edges_there.exit_code == 0);
    CHECK_THAT(of_edges_there.err, Contains("crumpled") && Contains("chebnet remesh"));
    CHECK(of_others.err.empty());
    CHECK(of_others.json().at("net").at("folds_over_60_degrees") == 0);
}

TEST_CASE("equalize gives all edges one length, reports and writes") {
    const Sandbox box;
    write_stretched_vault(box, "raw.obj");
    const Run run = box.run("equalize raw.obj -o net.ply");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    const json report = run.json();
    CHECK(report.at("net") == "raw.obj");
    CHECK(report.at("status") == "converged");
    CHECK(report.at("max_dL") < 1e-9);
    CHECK(report.at("iterations") > 0);
    CHECK(report.at("milliseconds") > 0);
    CHECK(report.at("mean_move_in_lengths") < report.at("max_move_in_lengths"));
    CHECK(report.at("method") == "equilibrium");
    CHECK(report.at("mean_distance_in_lengths") < 0.1);
    CHECK(report.at("mean_distance_in_lengths") <= report.at("largest_distance_in_lengths"));
    CHECK(report.at("smallest_corner_angle_degrees") > 29.99);
    CHECK(report.at("lengths_before").at("longest") > 1.3);
    CHECK(report.at("lengths_after").at("longest") < 1.0001);
    CHECK(report.at("lengths_after").at("shortest") > 0.9999);
    CHECK(report.at("lengths_after").at("standard_deviation") < 1e-4);
    CHECK(report.at("worst_edges").empty());
    CHECK(report.at("unreachable_pairs").empty());

    const json info = box.run("info net.ply").json();
    CHECK(info.at("chebyshev") == true);
    CHECK(info.at("max_dL") < 2e-9);
    CHECK(info.at("mean_length").get<double>() == Approx(report.at("length").get<double>()));
    CHECK(box.run("equalize net.ply -o again.ply").json().at("iterations") == 0);
    CHECK(box.read("again.ply") == box.read("net.ply"));
}

TEST_CASE("equalize says that a border has cut a net") {
    const Sandbox box;
    box.run("drape --surface hemisphere --cells 60 --cut -o cut.obj");
    CHECK_THAT(box.run("equalize cut.obj --method projection").err, Contains("a border has cut this net"));
    box.run("drape --surface hemisphere --cells 60 -o whole.obj");
    CHECK(box.run("equalize whole.obj").err.empty());
}

TEST_CASE("equalize takes a length, and vertices to hold") {
    const Sandbox box;
    write_stretched_vault(box, "raw.obj");
    const json mean = box.run("equalize raw.obj --method projection").json();
    const json fit = box.run("equalize raw.obj --method projection --length fit").json();
    CHECK(mean.at("method") == "projection");
    CHECK(fit.at("length") == mean.at("fitting_length"));
    CHECK(box.run("equalize raw.obj --shear-limit 60").json().at("smallest_corner_angle_degrees") > 59.9);
    CHECK(box.run("equalize raw.obj --length 0.5").json().at("length") == 0.5);

    const Run held = box.run("equalize raw.obj --hold 0 200 -o held.obj");
    CHECK(held.exit_code == 0);
    const Positions before = read_obj(box.read("raw.obj"), "").positions;
    const Positions after = read_obj(box.read("held.obj"), "").positions;
    for (const int vertex : {0, 200}) CHECK(after.col(vertex) == before.col(vertex));
}

TEST_CASE("equalize comes near a guide, which is a file or one of ours") {
    const Sandbox box;
    write_stretched_vault(box, "raw.obj");
    const Net net = make_shape(k_recipe).net;
    const Positions lifted =
        (Eigen::Vector3d(1, 2, 2.7).asDiagonal() * net.rest_positions()).colwise() + Eigen::Vector3d(0, 0, 0.4);
    box.write("guide.obj", write_obj(lifted, net.faces()));
    CHECK(box.run("equalize raw.obj -o own.obj").exit_code == 0);
    const Run run = box.run("equalize raw.obj --guide guide.obj -o guided.obj");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    const json report = run.json();
    CHECK(report.at("method") == "equilibrium");
    CHECK(report.at("max_dL") < 1e-9);
    CHECK(report.at("smallest_corner_angle_degrees") > 29.99);
    const Guide guide(Surface({lifted, net.faces()}));
    const auto distance = [&](const char* file) {
        return distance_to(guide, net, read_obj(box.read(file), "").positions).mean / report.at("length").get<double>();
    };
    CHECK(report.at("mean_distance_in_lengths").get<double>() == Approx(distance("guided.obj")).epsilon(1e-6));
    CHECK(distance("guided.obj") < distance("own.obj") / 2);

    CHECK(box.run("equalize raw.obj --guide hypar").json().contains("mean_distance_in_lengths"));
    check_refused(box.run("equalize raw.obj --guide nothing.obj"), "nothing.obj");
}

TEST_CASE("equalize says what stands in the way") {
    const Sandbox box;
    // Five vertices, all joined, on a Moebius strip: no five points have one distance from each other.
    box.write("five.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n");
    const Run five = box.run("equalize five.obj -o best.obj");
    CHECK(five.exit_code == 1);
    CHECK(line_count(five.err) == 1);
    CHECK_THAT(five.err, Contains("no net with edges of length") && Contains("the worst, from vertex"));
    CHECK(five.json().at("status") != "converged");
    CHECK(five.json().at("max_dL") > 1e-3);
    CHECK(five.json().at("worst_edges")[0].at("vertices").size() == 2);
    CHECK(five.json().at("worst_edges")[0].at("length") > 0);
    CHECK(box.has("best.obj"));

    const Run far = box.run("equalize " + k_recipe + " --length 0.01 --hold 0 200");
    CHECK(far.exit_code == 1);
    CHECK(line_count(far.err) == 1);
    CHECK_THAT(far.err, Contains("held vertices 0 and 200 are") && Contains("--length"));
    CHECK(far.json().at("status") == "unreachable");
    CHECK(far.json().at("unreachable_pairs")[0].at("vertices") == json{0, 200});

    write_stretched_vault(box, "raw.obj");
    check_refused(box.run("equalize raw.obj --length long"), "\"long\"");
    check_refused(box.run("equalize raw.obj --length 0"), "length");
    check_refused(box.run("equalize raw.obj --length fit --hold 3"), "handles");
    check_refused(box.run("equalize raw.obj --method li2022"), "li2022");
    check_refused(box.run("equalize raw.obj --shear-limit 80"), "60");
    check_refused(box.run("equalize raw.obj --hold 4000"), "4000");
    check_refused(box.run("equalize raw.obj -o net.3dm"), "net.3dm");
    box.write("loose.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 9 9 9\nf 1 2 3 4\n");
    check_refused(box.run("equalize loose.obj"), "--repair");
    CHECK(box.run("equalize loose.obj --repair").exit_code == 0);
}

TEST_CASE("change gives a net other faces, exactly") {
    const Sandbox box;
    const int faces = box.run("info " + k_recipe).json().at("faces");
    const Run run = box.run("change " + k_recipe + " refine -o fine.obj");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    CHECK(run.json().at("status") == "converged");
    CHECK(run.json().at("max_dL") < 1e-9);
    CHECK(run.json().at("faces") == 4 * faces);
    CHECK(run.json().at("chebyshev") == true);
    CHECK(box.run("change fine.obj coarsen").json().at("faces") == faces);
    CHECK(box.run("change " + k_recipe + " cut --line 40 41").json().at("pieces") == 2);
    CHECK(box.run("change fine.obj delete_faces --vertices 0").json().at("faces") == 4 * faces - 1);

    // Edges with lengths of their own keep them, which the report says.
    box.write("kite.obj", "v 0 0 0\nv 1 0 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4\n");
    const json kite = box.run("change kite.obj refine -o parts.obj").json();
    CHECK(kite.at("chebyshev") == false);
    CHECK(kite.at("shortest_length") == 0.5);
    CHECK(kite.at("longest_length") == 1.5);

    check_refused(box.run("change fine.obj melt"), "no change is called \"melt\"; known are ");
    check_refused(box.run("change fine.obj cut --line 0 700"), "--line");
    check_refused(box.run("change kite.obj delete_faces --vertices 4"), "the net has no vertex 4, only 0 to 3");
}

TEST_CASE("change refuses a place that it would not read") {
    const Sandbox box;
    const std::string change = "change " + k_recipe + " ";
    check_refused(box.run(change + "refine --line 0 1"), "refine changes the whole net: it takes no --line");
    check_refused(box.run(change + "join --vertices 5"), "it takes no --vertices");
    check_refused(box.run(change + "delete_rows --vertices 5"), "from --line, not from --vertices");
    check_refused(box.run(change + "delete_faces --vertices 5 --line 40 41"), "from --vertices, not from --line");
}

TEST_CASE("change names the option that says where, if it needs one") {
    const Sandbox box;
    for (const ChangeInfo& change : change_table()) {
        if (change.place_part == PlacePart::nothing) continue;
        CAPTURE(change.name);
        const char* option = change.place_part == PlacePart::edges ? "--line A B" : "--vertices";
        check_refused(box.run("change " + k_recipe + " " + change.name),
                      std::string(change.name) + " needs a place: " + option);
    }
}

TEST_CASE("change writes nothing where no net comes of it") {
    const Sandbox box;
    // Folded along the line that goes, so that those beside it lie on each other.
    constexpr int columns = 5, rows = 4;
    Mesh folded{Positions(3, columns * rows), {}};
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int v = j * columns + i;
            folded.positions.col(v) << std::min(i, columns - 1 - i), 1.5 * j, 0;
            if (i + 1 < columns && j + 1 < rows) folded.faces.add({v, v + 1, v + columns + 1, v + columns});
        }
    box.write("folded.obj", write_obj(folded.positions, folded.faces));
    check_refused(box.run("change folded.obj remove_line --line 2 7 -o out.obj"), "length zero");
    CHECK_FALSE(box.has("out.obj"));
}

TEST_CASE("drape tells that it lies on a noisy surface as that is without its noise") {
    const Sandbox box;
    unsigned state = 1;
    const auto noise = [&state] {
        state = state * 1664525u + 1013904223u;
        return 0.03 * (state / 4294967296. - 0.5);
    };
    write_grid(box, "scan.obj", 41, false, [&](double u, double v) { return Eigen::Vector3d(u, v, noise()); });
    const Run run = box.run("drape scan.obj --cells 1000");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.err, Contains("the surface is rough"));
    CHECK(run.json().at("net").at("coverage") > 0.98);
    CHECK(run.json().at("net").at("mean_distance_in_lengths") > 0.02);
    CHECK(box.run("drape --surface hypar --cells 300").err.empty());
}

TEST_CASE("drape tells of folds where a net leaves the surface, and of ways out, which have none") {
    const Sandbox box;
    write_grid(box, "steep.obj", 61, false, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, 2.5 * (x * x - y * y));
    });
    const std::string drape = "drape steep.obj --cells 300 --leave ";
    for (const char* folded : {"1", "1 --cut", "1 --pieces"}) {
        const Run run = box.run(drape + folded);
        CHECK(run.exit_code == 0);
        CHECK(run.json().at("net").at("folds_over_60_degrees") > 0);
        CHECK_THAT(run.err, Contains("crumpled") && Contains("more than the surface does; --leave 0"));
    }
    for (const char* smooth : {"0", "1 --shear-limit 20"}) {
        const Run run = box.run(drape + smooth);
        CHECK(run.json().at("net").at("folds_over_60_degrees") == 0);
        CHECK(run.err.empty());
    }
}

TEST_CASE("drape lays a net on a surface, reports and writes") {
    const Sandbox box;
    write_saddle(box, "saddle.obj", 31);
    const std::string drape = "drape saddle.obj --seed 0.1 0 0 --direction 1 0.2 0 --edge 0.1 ";
    const Run run = box.run(drape + "--out net.obj");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    const json report = run.json();
    CHECK(report.at("surface") == "saddle.obj");
    CHECK(report.at("described").at("triangles") == 1800);
    CHECK(report.at("described").at("boundary_loops") == 1);
    CHECK(report.at("described").at("prospect") == "One uncut piece will cover it.");
    const json& net = report.at("net");
    CHECK(net.at("length") == Approx(0.1));
    CHECK(net.at("max_dL") < 1e-12);
    CHECK(net.at("coverage") > 0.99);
    CHECK(net.at("largest_distance_in_lengths") < 0.1);
    CHECK(net.at("smallest_corner_angle_degrees") > 45);
    CHECK(report.at("milliseconds").at("drape") > 0);

    const json info = box.run("info net.obj").json();
    CHECK(info.at("chebyshev") == true);
    CHECK(info.at("faces") == net.at("cells"));

    CHECK(box.run(drape + "--inside").json().at("net").at("cells") < net.at("cells"));
    CHECK(box.run(drape + "--reach 2").json().at("net").at("cells") == 16);
    const json slanted = box.run(drape + "--angle 60").json();
    CHECK(slanted.at("net").at("smallest_corner_angle_degrees") < 60.5);
    CHECK(net.at("arms") == "geodesic");
    const json strict = box.run(drape + "--shear-limit 80").json();
    CHECK(strict.at("net").at("smallest_corner_angle_degrees") >= 80 - 1e-6);
    CHECK(strict.at("net").at("refused_by_the_shear_limit") > 0);
}

TEST_CASE("drape cuts a surface, lays a net on each piece, and reports of each and of all") {
    const Sandbox box;
    write_saddle(box, "saddle.obj", 31);
    const std::string drape = "drape saddle.obj --edge 0.1 --cut ";
    const Run run = box.run(drape + "--cut-along -1,0.21,-0.1 1,0.33,0.1 --out two.obj");
    CHECK(run.exit_code != 0);  // points are one argument
    const json two = box.run(drape + "--cut-along \"-1,0.21,-0.1 1,0.33,0.1\" --out two.obj").json();
    CHECK(two.at("described").at("components") == 2);
    REQUIRE(two.at("pieces").size() == 2);
    int cells = 0, cut_ends = 0;
    for (const json& piece : two.at("pieces")) {
        CHECK(piece.at("net").at("coverage") > 0.98);
        CHECK(piece.at("net").at("smallest_corner_angle_degrees") >= 30);
        cells += piece.at("net").at("cells").get<int>();
        cut_ends += piece.at("net").at("rod_ends_cut_at_the_border").get<int>();
    }
    CHECK(two.at("net").at("rod_ends_cut_at_the_border") == cut_ends);
    CHECK(cut_ends > 0);
    CHECK(two.at("net").at("cells") == cells);
    CHECK(two.at("net").at("coverage") > 0.98);
    CHECK(two.at("net").at("max_dL") < 1e-12);
    CHECK(box.run("info two.obj").json().at("components") == 2);

    const json slit = box.run(drape + "--cut-along \"-1,0,0 0.2,0,0\"").json();
    CHECK(slit.at("pieces").size() == 1);
    const json cross = box.run(drape + "--cut-along \"-1,0,0 1,0,0\" --cut-along \"0,-1,0 0,1,0\"").json();
    CHECK(cross.at("pieces").size() == 4);
    const json chosen = box.run(drape + "--cut-along \"-1,0,0 1,0,0\" --seed 0 0.5 0 --direction 1 1 0").json();
    CHECK(chosen.at("pieces")[0].at("seed") == json({0, 0.5, 0}));
    CHECK(chosen.at("pieces")[0].contains("net"));
    CHECK(chosen.at("pieces")[1].contains("net"));

    const json tube = box.run("drape --surface torso --cells 300 --cut-between-borders 1").json();
    CHECK(tube.at("described").at("boundary_loops") == 1);
    const json parted = box.run(drape + "--cut-to-border 0,0.2,0 --cut-to-border 0.1,0.2,0").json();
    CHECK(parted.at("pieces").size() == 1);
    CHECK(parted.at("net").at("coverage") > 0.95);

    const json proposed = box.run("drape --surface pebble --cells 300 --propose-cuts 1").json();
    REQUIRE(proposed.at("proposed").at("cuts").size() == 1);
    const json& best = proposed.at("proposed").at("cuts")[0];
    CHECK(best.at("coverage_with_it") > proposed.at("proposed").at("coverage_uncut"));
    CHECK(proposed.at("net").at("coverage") == best.at("coverage_with_it"));

    check_refused(box.run("drape --surface pebble --propose-cuts 1 --seed 0 0 2 --seed 1 0 2"), "from one --seed");
    check_refused(box.run(drape + "--cut-along \"0,0 1,0,0\""), "\"0,0\" should be three numbers");
    check_refused(box.run(drape + "--cut-along \"0,0,0 1,x,0\""), "\"x\" is not a number");
    check_refused(box.run(drape + "--cut-to-border 0,x,0"), "--cut-to-border: \"x\" is not a number");
    check_refused(box.run(drape + "--cut-to-border \"0,0,0 1,0,0\""), "one point");
    check_refused(box.run(drape + "--cut-between-borders 1"), "no two borders");
    check_refused(box.run("drape --surface pebble --cut-to-border 0,0,2"), "no border");
    check_refused(box.run(drape + "--cut-to-border nan,0,0"), "--cut-to-border: \"nan\" is not finite");
    check_refused(box.run(drape + "--cut-along \"0,0,0 inf,0,0\""), "--cut-along: \"inf\" is not finite");
    check_refused(box.run(drape + "--cut-to-border 0,0,1e6"), "the beginning of a cut is 999999");
    check_refused(box.run(drape + "--cut-along \"0,0,0\""), "cut 1 needs at least two points");
    check_refused(box.run(drape + "--cut-along \"0,0,0 0,0,3\""), "away from the surface");
    check_refused(box.run(drape + "--cut-along \"-1,0,0 1,0,0\" --seed 0 0.5 0 --seed 0.1 0.5 0"), "seed 2");
}

TEST_CASE("drape lets arms bend, or run along a curve, and says what came of it") {
    const Sandbox box;
    const std::string shell = "drape --surface shell --seed 1.5 -0.8 1 --cells 1500 ";
    const json straight = box.run(shell).json().at("net"),
               bent = box.run(shell + "--arms least-shear").json().at("net");
    CHECK(bent.at("arms") == "least-shear");
    CHECK(bent.at("part_of_cells_sheared_over_15_degrees") <
          0.5 * straight.at("part_of_cells_sheared_over_15_degrees").get<double>());
    CHECK(bent.at("smallest_corner_angle_degrees") > straight.at("smallest_corner_angle_degrees"));
    CHECK(bent.at("max_dL") < 1e-12);
    CHECK(box.run("drape --surface hypar --seed 0 0 0 --cells 300 --arms least-shear").json().at("net").at("arms") ==
          "geodesic");

    write_saddle(box, "saddle.obj", 31);
    const std::string along = "drape saddle.obj --edge 0.1 --along \"-0.8,-0.3,0 0,0.1,0 0.8,-0.3,0\" ";
    CHECK(box.run(along).json().at("net").at("arms") == "curve");
    const json pieces = box.run(along + "--arms curve --pieces").json();
    CHECK(pieces.at("pieces")[0].at("net").at("arms") == "curve");
    CHECK(pieces.at("net").at("arms") == "curve");
    check_refused(box.run(along + "--arms geodesic"), "--along is for --arms curve");
    check_refused(box.run("drape saddle.obj --edge 0.1 --arms curve"), "needs at least two points");
    check_refused(box.run("drape saddle.obj --edge 0.1 --arms bent"), "--arms");
    check_refused(box.run("drape saddle.obj --edge 0.1 --along \"0,0,0 0.01,0,0\""), "shorter than an edge");
    check_refused(box.run("drape saddle.obj --edge 0.1 --along \"0,0,0 0,0,4\""), "point 2 of the curve");
    check_refused(box.run("drape saddle.obj --edge 0.1 --along \"\""), "--along: has no points");
}

TEST_CASE("drape takes surfaces of our own, and begins in the middle") {
    const Sandbox box;
    const json report = box.run("drape --surface hypar --cells 500 -o net.obj").json();
    CHECK(report.at("surface") == "hypar");
    CHECK(report.at("net").at("cells") > 400);
    CHECK(report.at("net").at("rods") > 40);
    CHECK(box.run("info net.obj").json().at("chebyshev") == true);

    // Where the x axis is upright, the y axis is the direction; numbers may begin with a minus sign.
    box.write("cube.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
              "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    for (const char* options : {"", " --pieces", " --direction 0 -.2 -1"})
        CHECK(
            box.run(std::string("drape cube.obj --cells 100 --seed 1 0.5 0.5") + options).json().at("net").at("cells") >
            10);
    check_refused(box.run("drape cube.obj --cells 100 --seed nan 0 0"), "the seed has a coordinate that is not finite");
    check_refused(box.run("drape cube.obj --cells 100 --seed 1000 0 0"), "the seed is 999");
    check_refused(box.run("drape cube.obj --cells 100 --seed 1 0.5 0.5 --seed 0 0 1000 --pieces"), "seed 2 is");
    check_refused(box.run("drape cube.obj --cells 100 --direction 0 0 0"), "has no length");
    check_refused(box.run("drape cube.obj --cells 100 --seed 1 0.5 0.5 4 5"), "not expected");
    check_refused(box.run("drape cube.obj --cells 100 --seed 1 0.5 0.5 0 0 1"), "not expected");

    const json middle = box.run("drape --surface torso --cells 300").json();
    const json best = box.run("drape --surface torso --cells 300 --best").json();
    CHECK(best.at("net").at("coverage") > middle.at("net").at("coverage"));
    const std::string from_seed = "drape --surface shell --cells 300 --seed 1.5 -0.8 1 ";
    CHECK(box.run(from_seed + "--best --direction 1 0 0").json().at("net") == box.run(from_seed).json().at("net"));
    CHECK(box.run(from_seed + "--best").json().at("net") != box.run(from_seed).json().at("net"));

    // Where only the direction is given, the place is the best one for that, not for another.
    const json along = box.run("drape --surface shell --cells 300 --best --direction 1 1 0").json();
    CHECK(along.at("net").at("part_of_cells_sheared_over_30_degrees") == 0);

    const json few = box.run("drape --surface hemisphere --cells 3 --cut --reach 1").json().at("net");
    CHECK((few.at("smallest_corner_angle_degrees").is_null() || few.at("smallest_corner_angle_degrees") < 91));
}

TEST_CASE("what cannot be draped is refused with one line") {
    const Sandbox box;
    write_saddle(box, "saddle.obj", 5);
    const std::string drape = "drape saddle.obj --seed 0 0 0 ";
    check_refused(box.run("drape"), "--surface");
    check_refused(box.run("drape saddle.obj --surface hypar"), "--surface");
    check_refused(box.run("drape --surface plain"), "hypar");
    check_refused(box.run(drape + "--edge 0.1 --cells 9"), "--cells");
    check_refused(box.run(drape + "--cells 0"), "cell");
    check_refused(box.run(drape + "--direction 1 0 --edge 0.1"), "--direction");
    check_refused(box.run(drape + "--direction 0 0 1 --edge 0.1"), "upright");
    check_refused(box.run(drape + "--direction 1 0 0 --edge 0"), "edge length");
    check_refused(box.run(drape + "--direction 1 0 0 --edge 0.1 --reach 0"), "reach");
    check_refused(box.run(drape + "--direction 1 0 0 --edge 0.1 --shear-limit 95"), "shear limit");
    check_refused(box.run(drape + "--direction 1 0 0 --edge 0.1 -o net.3dm"), "net.3dm");
    check_refused(box.run("drape dome.obj --seed 0 0 0 --direction 1 0 0 --edge 1"), "dome.obj");
    box.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    check_refused(box.run("drape line.obj --edge 0.2"), "line.obj: the surface has no area");
    check_refused(box.run("remesh line.obj --cells 9 --repair"), "line.obj: the surface has no area");
    box.write("twisted.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n");
    const std::string twisted = "drape twisted.obj --seed 0 0 0 --direction 1 1 0 --edge 0.2";
    check_refused(box.run(twisted), "twisted.obj: the two faces at edge 0-1 wind against each other");
    const Run repaired = box.run(twisted + " --repair");
    CHECK(repaired.exit_code == 0);
    CHECK_THAT(repaired.err, Contains("wound against the others, turned round"));
}

TEST_CASE("remesh makes a net over a whole surface, reports and writes") {
    const Sandbox box;
    const Run run = box.run("remesh --surface pebble --cells 300 --out net.obj");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    const json report = run.json();
    CHECK(report.at("surface") == "pebble");
    CHECK(report.at("described").at("boundary_loops") == 0);
    const json& net = report.at("net");
    CHECK(net.at("cells") == Approx(300).epsilon(0.1));
    CHECK(net.at("vertices").get<int>() == net.at("cells").get<int>() + 2);
    CHECK(net.at("max_dL") < 1e-9);
    CHECK(net.at("smallest_corner_angle_degrees") >= 30);
    CHECK(net.at("quads_beyond_shear_limit") == 0);
    CHECK(net.at("singular_vertices_by_valence").at("3") >= 8);
    for (const char* phase : {"tree", "triangles", "field", "grid", "fit"})
        CHECK(report.at("milliseconds").at(phase).is_number());

    const json info = box.run("info net.obj").json();
    CHECK(info.at("chebyshev") == true);
    CHECK(info.at("faces") == net.at("cells"));

    const json given = box.run("remesh net.obj --length 0.8 --shear-limit 40 --crease 60").json();
    CHECK(given.at("net").at("length") == Approx(0.8).epsilon(1e-9));
    CHECK(given.at("net").at("smallest_corner_angle_degrees") >= 40);
}

TEST_CASE("remesh follows creases that are marked, and says how near") {
    const Sandbox box;
    const std::string remesh = "remesh --surface hemisphere --cells 500 ";
    const std::string over = "--crease-along \"-3,0,0 -2.1,0.8,2 0,1.2,2.7 2.1,0.8,2 3,0,0\" ";
    const json net = box.run(remesh + over).json().at("net");
    REQUIRE(net.at("wishes").at("creases").size() == 1);
    CHECK(net.at("wishes").at("creases")[0].at("followed") == true);
    CHECK(net.at("wishes").at("creases")[0].at("distance_in_edges") < 0.15);
    CHECK(net.at("wishes").at("not_kept").empty());
    CHECK(net.at("max_dL") < 1e-9);
    CHECK(box.run(remesh).json().at("net").count("wishes") == 0);
    const json two = box.run(remesh + over + "--crease-along \"1,-1,2.6 2,-1,2\"").json().at("net");
    CHECK(two.at("wishes").at("creases").size() == 2);
    check_refused(box.run(remesh + over + "--crease-along \"0,0,3\""), "marked crease 2 needs at least two points");
    check_refused(box.run(remesh + "--crease-along \"0,0,3 0,0,4\""), "point 2 of marked crease 1");
    check_refused(box.run(remesh + "--crease-along \"0,0 1,0,0\""), "--crease-along: \"0,0\"");
}

TEST_CASE("remesh ends nets in a net line at the border if it is told to, or never") {
    const Sandbox box;
    const auto coverage = [&](const std::string& border) {
        const Run run = box.run("remesh --surface torso --cells 400 " + border);
        INFO(run.err);
        return run.json().at("net").at("coverage").get<double>();
    };
    CHECK(coverage("--border always") > coverage("--border never") + 0.01);
    CHECK(coverage("--border across") > coverage("--border always"));
    CHECK(coverage("--border outer") == coverage("--border always"));  // it has no hole
    CHECK(coverage("") == coverage("--border fitting"));
}

TEST_CASE("remesh tells of a net that lies in folds, and of the way out, which leads to one that does not") {
    const Sandbox box;
    write_grid(box, "tower.obj", 41, true, [](double u, double v) {
        const double turn = 2 * std::numbers::pi * u, z = 2.4 * v - 1.6, r = std::hypot(0.6, z / 1.5);
        return Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), z);
    });
    const std::string remesh = "remesh tower.obj --cells 250 ";
    const Run held = box.run(remesh + "--border always"), fitting = box.run(remesh);
    INFO(held.err);
    CHECK(held.exit_code == 0);
    CHECK_THAT(held.err, Contains("crumpled") && Contains("--border fitting"));
    CHECK(held.json().at("net").at("folds_over_60_degrees") > 0);
    CHECK(fitting.exit_code == 0);
    CHECK(fitting.err.empty());
    CHECK(fitting.json().at("net").at("folds_over_60_degrees") == 0);
}

TEST_CASE("remesh tells where a net that follows creases leaves much bare, and of the way out, which covers it") {
    const Sandbox box;
    // A hip roof.
    box.write("hip.obj",
              "v 0 0 0\nv 12 0 0\nv 12 8 0\nv 0 8 0\nv 3 4 3\nv 9 4 3\n"
              "f 1 2 6\nf 1 6 5\nf 2 3 6\nf 3 4 5\nf 3 5 6\nf 4 1 5\n");
    const Run along = box.run("remesh hip.obj --cells 600 --crease 30"),
              without = box.run("remesh hip.obj --cells 600");
    CHECK(along.json().at("net").at("coverage") < 0.98);
    CHECK_THAT(along.err, Contains(" % of the surface; without --crease it often covers more"));
    CHECK(without.json().at("net").at("coverage") > 0.99);
    CHECK(without.err.empty());
}

TEST_CASE("remesh tells where a net leaves much bare for other reasons, and of a way out that covers more") {
    const Sandbox box;
    write_grid(box, "spike.obj", 61, false, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, 1.5 * std::exp(-20 * (x * x + y * y)));
    });
    write_grid(box, "steep.obj", 41, false, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, 1.5 * (x * x - y * y));
    });
    struct Case {
        std::string bare, way_out, covering;
    };
    const Case cases[] = {
        {"remesh --surface torso --cells 300 --border never", "--border fitting often covers more",
         "remesh --surface torso --cells 300 --border fitting"},
        {"remesh spike.obj --cells 300", "finely shaped more cells", "remesh spike.obj --cells 1600"},
        {"remesh steep.obj --cells 300", "chebnet drape --leave", "drape steep.obj --cells 300 --leave 1"},
        {"remesh --surface pebble --cells 300 --forbid 0,0,2:2.5",
         "without wishes for singular vertices it often covers more", "remesh --surface pebble --cells 300"}};
    for (const auto& [bare, way_out, covering] : cases) {
        CAPTURE(bare);
        const Run less = box.run(bare), more = box.run(covering);
        CHECK(less.json().at("net").at("coverage") < 0.98);
        CHECK_THAT(less.err, Contains(" % of the surface; ") && Contains(way_out));
        CHECK(more.json().at("net").at("coverage") > 0.98);
    }
}

TEST_CASE("remesh takes wishes for singular vertices, and reports which were kept") {
    const Sandbox box;
    const json pebble = box.run("remesh --surface pebble --cells 300 --out net.obj").json().at("net");
    const json& first = pebble.at("singular").at(0);
    CHECK(pebble.at("singular").size() == pebble.at("singular_vertices"));
    CHECK(pebble.count("wishes") == 0);
    const auto coordinates = [&](const json& point) {
        return std::to_string(point.at(0).get<double>()) + "," + std::to_string(point.at(1).get<double>()) + "," +
               std::to_string(point.at(2).get<double>());
    };
    const std::string place = coordinates(first.at("position"));
    const Run run = box.run("remesh --surface pebble --cells 300 --forbid " + place + ":1 --singular " +
                            coordinates(pebble.at("singular").at(1).at("position")) + ":3");
    INFO(run.err);
    const json wishes = run.json().at("net").at("wishes");
    CHECK(wishes.at("vertices").at(0).at("valence") == 3);
    CHECK(wishes.at("vertices").at(0).at("kept") == true);
    CHECK(wishes.at("vertices").at(0).at("distance_in_edges") < 1.5);
    CHECK(wishes.at("forbidden").at(0).at("kept") == true);
    CHECK(wishes.at("forbidden").at(0).at("singular_vertices") == 0);
    CHECK(wishes.at("only") == false);
    CHECK(wishes.at("not_kept").empty());

    check_refused(box.run("remesh --surface pebble --only-these --singular " + place + ":3"),
                  "7 more of valence 3 are missing");
    check_refused(box.run("remesh --surface pebble --singular " + place), "X,Y,Z:VALENCE");
    check_refused(box.run("remesh --surface pebble --singular 0,0,1:3:4"), "X,Y,Z:VALENCE");
    check_refused(box.run("remesh --surface pebble --length 0"), "--length: wants a number above 0, not 0");
    check_refused(box.run("remesh --surface pebble --shear-limit nan"), "the shear limit must be from 0 to 60 degrees");
    check_refused(box.run("drape --surface shell --leave -1"), "--leave");
    check_refused(box.run("remesh --surface pebble --singular 0,0,1:3.5"), "no whole number");
    check_refused(box.run("remesh --surface pebble --singular 0,0,1:7"), "must be 3, 5 or 6");
    check_refused(box.run("remesh --surface pebble --forbid 0,0,x:1"), "X,Y,Z:RADIUS");
    check_refused(box.run("remesh --surface pebble --forbid 0,0,1:-1"), "radius");
}

TEST_CASE("what cannot be remeshed is refused with one line") {
    const Sandbox box;
    write_saddle(box, "saddle.obj", 5);
    check_refused(box.run("remesh"), "--surface");
    check_refused(box.run("remesh saddle.obj --cells 100 --length 0.1"), "--length");
    check_refused(box.run("remesh saddle.obj --cells 0"), "at least 20 cells");
    check_refused(box.run("remesh saddle.obj --cells 10000000"), "100000");
    check_refused(box.run("remesh saddle.obj --length 9"), "too long");
    check_refused(box.run("remesh saddle.obj --length -1"), "--length");
    check_refused(box.run("remesh saddle.obj --shear-limit 80"), "shear limit");
    check_refused(box.run("remesh saddle.obj --smoothing -1"), "smoothing");
    check_refused(box.run("remesh saddle.obj --crease 200"), "angle of creases");
    check_refused(box.run("remesh saddle.obj --border often"), "--border");
    check_refused(box.run("remesh saddle.obj -o net.3dm"), "net.3dm");
}

TEST_CASE("nets are read and written in every format, by extension") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    CHECK(box.run("make " + k_recipe + " -o net.obj").exit_code == 0);
    const std::string solve = " --edit pull.json --max-iterations 3 -o ";
    box.run("solve net.obj" + solve + "solved.obj");
    for (const std::string name : {"net.ply", "net.OFF"}) {
        INFO(name);
        CHECK(box.run("make " + k_recipe + " -o " + name).exit_code == 0);
        CHECK(box.run("convert " + name + " back.obj").exit_code == 0);
        CHECK(box.read("back.obj") == box.read("net.obj"));
        CHECK(box.run("info " + name).json().at("chebyshev") == true);
        box.run("solve " + name + solve + "solved_" + name);
        CHECK(box.run("convert solved_" + name + " back.obj").exit_code == 0);
        CHECK(box.read("back.obj") == box.read("solved.obj"));
    }
    CHECK(box.run("drag net.ply --frames 1" + solve + "dragged.stl").exit_code <= 1);
    CHECK(box.read("dragged.stl").size() > 84);
}

TEST_CASE("PLY is written as text if asked for") {
    const Sandbox box;
    CHECK(box.run("make dome -o binary.ply").exit_code == 0);
    CHECK(box.run("convert binary.ply text.ply --text").exit_code == 0);
    CHECK_THAT(box.read("binary.ply"), Contains("format binary_little_endian"));
    CHECK_THAT(box.read("text.ply"), Contains("format ascii"));
    CHECK(box.run("convert text.ply again.ply").exit_code == 0);
    CHECK(box.read("again.ply") == box.read("binary.ply"));
}

TEST_CASE("a file is repaired only if asked to, and every repair is told") {
    const Sandbox box;
    box.write("loose.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 9 9 9\n"
              "f 1 2 3 4\nf 5 6 7 8\n");
    box.write("points.obj", "v 0 0 0\nv 1 0 0\n");
    box.write("cut.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n");
    const Run cut = box.run("drape cut.obj --edge 0.2");
    CHECK(cut.err == "chebnet: cut.obj: 2 vertices at the place of an earlier one: 3, 4 (--repair merges them)\n");
    CHECK(cut.json().at("described").at("components") == 2);
    CHECK(box.run("drape cut.obj --edge 0.2 --repair").json().at("described").at("components") == 1);
    CHECK_THAT(box.run("drape points.obj").err, Catch::Matchers::EndsWith("the surface has no face\n"));
    check_refused(box.run("info loose.obj"), "loose.obj: vertex 8 belongs to no face (--repair may mend this)");
    const Run run = box.run("info loose.obj --repair");
    CHECK(run.exit_code == 0);
    CHECK(run.err ==
          "chebnet: loose.obj: 2 vertices at the place of an earlier one, merged: 4, 7\n"
          "chebnet: loose.obj: 1 vertex of no face, dropped: 8\n");
    CHECK(run.json().at("vertices") == 6);
    CHECK(run.json().at("edges") == 7);

    CHECK(box.run("convert loose.obj as_it_is.off").err.empty());
    CHECK(read_mesh(box.read("as_it_is.off"), "").positions.cols() == 9);
    CHECK(line_count(box.run("convert --repair loose.obj mended.off").err) == 2);
    CHECK(box.run("info mended.off --repair").err.empty());
    CHECK(box.run("info dome --repair").err.empty());

    box.write("far.obj", "v 1e300 0 0\nv 0 1e300 0\nv 0 0 0\nf 1 2 3\n");
    check_refused(box.run("info far.obj --repair"), "far.obj: vertex 0 has a coordinate beyond 1e150");
}

TEST_CASE("bad usage is refused with one line") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    const std::string solve = "solve " + k_recipe + " --edit pull.json ";
    const std::string drag = "drag " + k_recipe + " --edit pull.json ";
    check_refused(box.run(""), "subcommand");
    check_refused(box.run("fold"), "fold");
    check_refused(box.run("info"), "NET");
    check_refused(box.run("info a.obj b.obj"), "b.obj");
    check_refused(box.run("make"), "RECIPE");
    check_refused(box.run("make dome"), "-o");
    check_refused(box.run("solve " + k_recipe), "--edit");
    check_refused(box.run("convert dome.obj"), "OUT");
    check_refused(box.run("make dome -o net.3dm"), "net.3dm");
    check_refused(box.run("make dome -o net.stl --text"), "--text");
    check_refused(box.run(solve + "-o net.3dm"), "net.3dm");
    check_refused(box.run(solve + "--colour red"), "--colour");
    check_refused(box.run(solve + "--method guess"), "guess");
    check_refused(box.run(solve + "--init guess"), "guess");
    check_refused(box.run(solve + "--threshold small"), "small");
    check_refused(box.run(solve + "--max-iterations -1"), "max_iterations");
    check_refused(box.run(solve + "--set colour=red"), "colour");
    check_refused(box.run(solve + "--set p_end=nan"), "p_end");
    check_refused(box.run(solve + "--set adaptive_p"), "key=value");
    check_refused(box.run(solve + "--shear-limit 20 --set shear_limit=40"), "option shear_limit is given twice");
    check_refused(box.run(solve + "--set threshold=1e-3 --set threshold=1e-9"), "option threshold is given twice");
    check_refused(box.run("solve --set p_end=30 " + k_recipe + " --edit pull.json"), k_recipe);
    check_refused(box.run(drag), "--frames");
    check_refused(box.run(drag + "--frames 0"), "--frames");
    check_refused(box.run(drag + "--frames many"), "many");
}

TEST_CASE("a net that cannot be had is refused with one line") {
    const Sandbox box;
    box.write("three.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4\n");
    box.write("cloud.obj", "v 0 0 0\n");
    check_refused(box.run("info missing.obj"), "missing.obj");
    check_refused(box.run("info missing.ply"), "missing.ply");
    box.write("three.off", "OFF 3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n");
    box.write("three.ply", "ply\nformat ascii 1.0\nend_header\n");
    box.write("picture", "GIF89a");
    box.write("net.stl", "solid\nvertex 0 0\n");
    check_refused(box.run("info three.obj"), "three.obj:4");
    check_refused(box.run("info three.off"), "three.off:5");
    check_refused(box.run("info three.ply"), "three.ply:3");
    check_refused(box.run("info picture"), "picture: this is a GIF picture");
    check_refused(box.run("info net.stl"), "net.stl:2");
    check_refused(box.run("convert missing.off net.obj"), "missing.off: cannot be opened");
    check_refused(box.run("info cloud.obj"), "cloud.obj");
    check_refused(box.run("info vault:colour=3"), "colour");
    check_refused(box.run("info 'two\nlines'"), "two lines");
    check_refused(box.run("make pyramid -o out.obj"), "pyramid");
}

TEST_CASE("a file hides a shape of the same name, a folder does not") {
    const Sandbox box;
    box.make_folder("vault");
    box.make_folder("nets");
    check_refused(box.run("info nets"), "nets: a directory, and as a recipe");
    CHECK(box.run("info vault").exit_code == 0);
    box.write("dome", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    CHECK(box.run("info dome").json().at("vertices") == 3);
}

TEST_CASE("a bad edit is refused, naming file and handle") {
    const auto [text, what] = GENERATE(table<std::string, std::string>({
        {"", "edit.json"},
        {"{\"handles\": [}", "line 1"},
        {"\x7f\x01\xff", "line 1"},
        {std::string(100'000, '['), "line 1"},
        {std::string(100'000, '7'), "JSON"},
        {"[]", "edit.json"},
        {"{}", "handles"},
        {R"({"handles": {}})", "handles"},
        {R"({"handles": [7]})", "handles[0]"},
        {R"({"handles": [{"target": [0, 0, 0]}]})", "handles[0] has no \"vertex\""},
        {R"({"handles": [{"vertex": 1}]})", "handles[0] has no \"target\""},
        {R"({"handles": [{"vertex": 1.5, "target": [0, 0, 0]}]})", "handles[0].vertex"},
        {R"({"handles": [{"vertex": -1, "target": [0, 0, 0]}]})", "handles[0].vertex is -1"},
        {R"({"handles": [{"vertex": 18446744073709551615, "target": [0, 0, 0]}]})", "handles[0].vertex"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0]}]})", "handles[0].target"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, null]}]})", "handles[0].target"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 1e999]}]})", "edit.json"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 0], "slides": ""}]})", "handles[0].slides"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 0], "slides": "xyz"}]})", "handles[0].slides"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 0], "slides": "xx"}]})", "handles[0].slides"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 0], "slides": "w"}]})", "handles[0].slides"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 0], "slides": 3}]})", "handles[0].slides"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 0], "slides": "z", "weight": 1}]})", "handles[0] has a weight"},
        {R"({"handles": [{"vertex": 1, "target": [0, 0, 0]}, {"vertex": 1, "target": [0, 0, 0]}]})", "handles[1]"},
    }));
    const Sandbox box;
    box.write("edit.json", text);
    INFO(text);
    const Run run = box.run("solve " + k_recipe + " --edit edit.json");
    check_refused(run, what);
    CHECK_THAT(run.err, Contains("edit.json"));
}

TEST_CASE("handles that a method lets not slide are said to stay") {
    const Sandbox box;
    json edit = pull_edit(0.05);
    edit["handles"].front()["slides"] = "x";
    box.write("slide.json", edit.dump());
    const std::string solve = "solve " + k_recipe + " --edit slide.json --method ";
    CHECK_THAT(box.run(solve + "li2022").err, Contains("method li2022 lets no handles slide"));
    CHECK(box.run(solve + "equilibrium").err.empty());
}

TEST_CASE("an option that the method does not read is said to be idle, and the report has what differs from usual") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.1).dump());
    const std::string solve = "solve " + k_recipe + " --edit pull.json --shear-limit 20 --method ";
    const Run idle = box.run(solve + "li2022");
    CHECK(idle.exit_code == 0);
    CHECK_THAT(idle.err, Contains("method li2022 does not read option shear_limit"));
    CHECK(json::parse(idle.out).at("options") == json{{"shear_limit", 20}});
    CHECK_THAT(box.run(solve + "equilibrium").err, !Contains("does not read"));
}

TEST_CASE("keys of handles that are not read are said to be so, once each, and keep no edit from opening") {
    const Sandbox box;
    box.write("edit.json", R"({"kind": "pull", "handles": [{"vertex": 0, "target": [0, 0, 0], "wieght": 1},)"
                           R"( {"vertex": 1, "target": [0, 0, 0], "wieght": 1, "name": "foot"}]})");
    const std::string err = box.run("solve " + k_recipe + " --edit edit.json").err;
    const std::string rest = " of a handle is not read; vertex, target, weight and slides are\n";
    CHECK_THAT(err, Catch::Matchers::StartsWith("chebnet: edit.json: \"name\"" + rest +
                                                "chebnet: edit.json: \"wieght\"" + rest));
    // Then that the ends of an edge are to be at one place: longer edges would not bring them there.
    CHECK(line_count(err) == 3);
    CHECK_THAT(err, Contains("handles 0 and 1 are to be 0 apart") && !Contains("--adapt-lengths"));
}

TEST_CASE("output that cannot be written is refused") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.1).dump());
    const std::string solve = "solve " + k_recipe + " --edit pull.json ";
    check_refused(box.run("make dome -o no/such/folder.obj"), "no/such/folder.obj");
    check_refused(box.run(solve + "-o no/such/folder.obj"), "no/such/folder.obj");
    check_refused(box.run(solve + "--trace no/such/folder.csv"), "no/such/folder.csv");
    check_refused(box.run(solve + "--trace table.csv --edges ./table.csv"), "table.csv: is to be written twice");
    check_refused(box.run("info dome --edges table.csv --rods table.csv"), "table.csv: is to be written twice");
    check_refused(box.run("solve " + k_recipe + " --edit missing.json"), "missing.json");
    if (std::filesystem::exists("/dev/full")) check_refused(box.run("info dome", "/dev/full"), "standard output");
}
