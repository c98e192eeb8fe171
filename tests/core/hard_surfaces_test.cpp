#include "hard_surfaces.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "../soak/surface_invariants.h"
#include "base/error.h"
#include "drape/bridged_drape.h"
#include "drape/drape.h"
#include "drape/surface_report.h"
#include "net/topology.h"
#include "remesh/one_piece.h"
#include "remesh/pinholes.h"
#include "remesh/remesh.h"
#include "surface/guide.h"

using namespace chebnet;

namespace {

constexpr int k_cells = 400;

std::string all(const invariants::Violations& violations) {
    std::string text;
    for (const std::string& violation : violations) text += violation + "; ";
    return text;
}

std::string judged(const Guide& guide, const Net& net, const invariants::Asked& asked) {
    const DrapeReport report = measure_drape(guide.surface(), guide.tree(), net);
    return all(invariants::of_net_on_surface(guide.surface(), net, report, asked));
}

int characteristic(const Net& net) { return net.vertex_count() - net.edge_count() + net.face_count(); }

}  // namespace

TEST_CASE("On surfaces of all kinds a laid net is exact, within its limit, and its gaps are reported", "[large]") {
    for (const auto& [name, mesh] : samples::hard_surfaces()) {
        INFO(name);
        const auto guide = std::make_shared<const Guide>(Surface(mesh));
        DrapeOptions options = suggested_drape(guide->surface(), guide->tree(), k_cells);
        for (const auto border :
             {DrapeOptions::Border::inside, DrapeOptions::Border::beyond, DrapeOptions::Border::cut}) {
            CAPTURE(static_cast<int>(border));
            options.border = border;
            options.slits = border == DrapeOptions::Border::cut;
            const Drape laid = drape(guide->surface(), guide->tree(), options);
            const invariants::Asked asked{options.smallest_angle, border == DrapeOptions::Border::cut};
            CHECK(judged(*guide, laid.net, asked) == "");
            const SurfaceReport described = describe(guide->surface());
            const double coverage = measure_drape(guide->surface(), guide->tree(), laid.net).coverage;
            if (border == DrapeOptions::Border::beyond && described.components == 1 && coverage < 0.95)
                CHECK(laid.locked + laid.met > 0);
        }
    }
}

TEST_CASE("Surfaces of all kinds get a net over the whole of them, or a sentence that says why not", "[large]") {
    const bool fewest = GENERATE(false, true);
    CAPTURE(fewest);
    int made = 0;
    for (const auto& [name, mesh] : samples::hard_surfaces()) {
        INFO(name);
        const auto guide = std::make_shared<const Guide>(Surface(mesh));
        RemeshOptions options;
        options.cells = k_cells;
        options.fewest = fewest;
        try {
            const Net net = remesh(guide, options).net;
            ++made;
            CHECK(judged(*guide, net, {options.smallest_angle}) == "");
            const double around_cell = 4 * std::sqrt(guide->surface().area() / k_cells);
            const std::optional<Surface> closed = without_pinholes(guide->surface(), around_cell);
            const SurfaceReport report = describe(closed ? *closed : guide->surface());
            const int of_surface = 2 * report.components - 2 * report.genus - report.boundary_loops;
            if (report.boundary_loops > 0 && characteristic(net) != of_surface) {  // left open where it would crumple
                const DrapeReport lies = measure_drape(guide->surface(), guide->tree(), net);
                CHECK(lies.gaps > 0);
                CHECK(lies.folds == 0);
                CHECK(Topology(net).component_count() == report.components);
            } else {
                CHECK(characteristic(net) == of_surface);
                CHECK(std::ssize(Topology(net).boundary_loops()) == report.boundary_loops);
            }
        } catch (const Error& error) {
            const std::string why = error.what();
            CAPTURE(why);
            CHECK(error.code() == ErrorCode::bad_option);
            CHECK(why.find("smaller ones may") != std::string::npos);
        }
    }
    CHECK(made >= 30);
}

TEST_CASE("What grows from one place over a surface is no net over several pieces") {
    const Mesh one = samples::graph(21, 1, [](double x, double y) { return 0.2 * x * y; });
    const Mesh other =
        samples::changed(one, [](const auto& p) { return Eigen::Vector3d(p + Eigen::Vector3d(4, 0, 0)); });
    const auto grown = [](const Mesh& mesh) {
        const Guide guide{Surface(mesh)};
        return one_piece(guide.surface(), guide.tree(), k_cells, 0, std::numbers::pi / 6);
    };
    CHECK(grown(one));
    CHECK(!grown(samples::together(one, other)));
}
