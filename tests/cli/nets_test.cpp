// make, info and convert; files of nets.
#include <catch2/catch.hpp>
#include <string>

#include "io/mesh_file.h"
#include "program.h"
#include "samples.h"
#include "shapes/shapes.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

TEST_CASE("make writes an edit at rest, which solve takes, and which moves the net once a target does") {
    const Sandbox box;
    CHECK(box.run("make dome:vertices=300 -o dome.obj --edit edit.json").exit_code == 0);
    Run solved = box.run("solve dome.obj --edit edit.json -o out.obj");
    CHECK(solved.exit_code == 0);
    CHECK(solved.json().at("bend") < 1e-6);

    nlohmann::json edit = nlohmann::json::parse(box.read("edit.json"));
    REQUIRE(edit.at("handles").size() == 5);
    edit["handles"].back()["target"][2] = edit["handles"].back()["target"][2].get<double>() + 0.5;
    box.write("edit.json", edit.dump());
    solved = box.run("solve dome.obj --edit edit.json -o out.obj");
    CHECK(solved.exit_code == 0);
    CHECK(solved.json().at("bend") > 1e-3);

    check_refused(box.run("make dome -o dome.obj --edit dome.obj"), "dome.obj");
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
