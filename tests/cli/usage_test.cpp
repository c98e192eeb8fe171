// Help, and what is refused whatever the subcommand.
#include <catch2/catch.hpp>
#include <string>

#include "program.h"
#include "samples.h"
#include "solve/method.h"
#include "solve/options.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using nlohmann::json;

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

TEST_CASE("bad usage is refused with one line") {
    const Sandbox box;
    box.write("pull.json", pull_edit(0.2).dump());
    const std::string solve = "solve " + k_recipe + " --edit pull.json ";
    const std::string drag = "drag " + k_recipe + " --edit pull.json ";
    check_refused(box.run(""), "subcommand");
    check_refused(box.run("slove dome"), R"(there is no subcommand "slove"; known are info, make,)");
    check_refused(box.run("--colour red"), "--colour");
    check_refused(box.run("info a.obj b.obj c.obj"), "not expected: b.obj c.obj");
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
