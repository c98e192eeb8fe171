// drag.
#include <catch2/catch.hpp>
#include <string>

#include "io/obj.h"
#include "program.h"
#include "samples.h"
#include "shapes/shapes.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

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

TEST_CASE("a drag that the iteration limit stops on its way is not called held back, and goes farther with more",
          "[large]") {
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
