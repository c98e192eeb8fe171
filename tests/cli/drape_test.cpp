// drape.
#include <catch2/catch.hpp>
#include <string>

#include "program.h"
#include "samples.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

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

TEST_CASE("drape cuts a surface, lays a net on each piece, and reports of each and of all", "[large]") {
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
