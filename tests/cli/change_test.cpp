// change.
#include "change/change.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "io/obj.h"
#include "program.h"
#include "samples.h"

using namespace chebnet;
using nlohmann::json;

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
