// equalize.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "io/obj.h"
#include "program.h"
#include "samples.h"
#include "shapes/shapes.h"
#include "surface/guide.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

TEST_CASE("equalize and change say where corners stay sharp, and end with 0 as every edge has its length", "[large]") {
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

TEST_CASE("equalize says at how many edges its net is crumpled, and what may help, which does", "[large]") {
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

TEST_CASE("equalize says that its net is far from the surface, as one of triangles is on a canopy") {
    const Sandbox box;
    box.run("make canopy:vertices=600 -o canopy.stl");
    const Run far = box.run("equalize canopy.stl");
    CHECK(far.exit_code == 0);
    CHECK(far.json().at("mean_distance_in_lengths") > 0.5);
    CHECK_THAT(far.err, Contains("far from the surface") && Contains("chebnet remesh"));
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
    check_refused(box.run("equalize raw.obj --guide hyper"),
                  R"(no surface is called "hyper"; known are shell, hypar,)");
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
