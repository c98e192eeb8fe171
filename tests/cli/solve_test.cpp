// solve, and edits as files have them.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "io/obj.h"
#include "program.h"
#include "samples.h"
#include "shapes/shapes.h"
#include "solve/method.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

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

TEST_CASE("what a surface does to the net needs a surface") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    check_refused(box.run("solve " + k_recipe + " --edit pull.json --guide-mode near"), "--guide");
    const std::string guided = "solve " + k_recipe + " --edit pull.json --guide hypar --method ";
    CHECK_THAT(box.run(guided + "projection").err, Contains("method projection does nothing with a guide"));
    CHECK(box.run(guided + "equilibrium").err.empty());
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
