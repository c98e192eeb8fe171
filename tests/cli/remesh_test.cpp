// remesh.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "../core/implicit_surface.h"
#include "io/obj.h"
#include "program.h"
#include "samples.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

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

TEST_CASE("remesh follows creases that are marked, and says how near", "[large]") {
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

TEST_CASE("remesh ends nets in a net line at the border if it is told to, or never", "[large]") {
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

TEST_CASE("remesh tells where a net that follows creases leaves much bare, and of the way out, which covers it",
          "[large]") {
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

TEST_CASE("remesh tells where a net leaves much bare for other reasons, and of a way out that covers more", "[large]") {
    const Sandbox box;
    write_grid(box, "rings.obj", 61, false, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, std::cos(6 * std::hypot(x, y)));
    });
    write_grid(box, "tray.obj", 41, false, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, 1.2 * std::sin(5 * x) * std::sin(5 * y));
    });
    struct Case {
        std::string bare, way_out, covering;
    };
    const Case cases[] = {
        {"remesh --surface torso --cells 300 --border never", "--border fitting often covers more",
         "remesh --surface torso --cells 300 --border fitting"},
        {"remesh rings.obj --cells 200", "finely shaped more cells", "remesh rings.obj --cells 1600"},
        {"remesh tray.obj --cells 300", "more cells, or chebnet drape --leave", "remesh tray.obj --cells 1200"},
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

TEST_CASE("remesh tells of limbs that are left off, and where they are") {
    const Sandbox box;
    // A ball with two spikes.
    const Mesh body = samples::implicit_surface(
        50, Eigen::Vector3d::Constant(-2.3), Eigen::Vector3d::Constant(2.3), [](const Eigen::Vector3d& p) {
            const auto outside_spike = [&](const Eigen::Vector3d& tip) {
                return (p - std::clamp(p.dot(tip) / tip.squaredNorm(), 0.0, 1.0) * tip).norm() - 0.08;
            };
            return std::min({p.norm() - 1, outside_spike({2, 0, 0}), outside_spike({0, -1.9, 0.6})});
        });
    box.write("body.obj", write_obj(body.positions, body.faces));
    const Run run = box.run("remesh body.obj --cells 400");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.err, Contains("2 limbs are too thin for cells of this size and left off, near ") &&
                            Contains(": more cells keep them"));
    const json limbs = run.json().at("net").at("left_off");
    REQUIRE(limbs.size() == 2);
    for (const json& limb : limbs) {
        const json& p = limb.at("point");
        CHECK(std::hypot(p[0].get<double>(), p[1].get<double>(), p[2].get<double>()) > 1.8);
        CHECK(limb.at("girth_in_cells") < 5);
    }
    CHECK(box.run("remesh --surface pebble --cells 300").json().at("net").at("left_off").empty());
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
