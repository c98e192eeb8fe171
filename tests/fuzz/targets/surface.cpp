#include "surface/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "arbitrary.h"
#include "drape/bridged_drape.h"
#include "drape/drape.h"
#include "drape/surface_report.h"
#include "remesh/remesh.h"
#include "require.h"
#include "soak/surface_invariants.h"
#include "surface/guide.h"

using namespace chebnet;
using fuzz::require;

namespace {

// A net of more vertices, or a measure of more samples, takes longer than an input may.
constexpr int k_farthest_reach = 10, k_most_cells = 400;
// So does a net over the whole of more triangles.
constexpr int k_most_remeshed = 100;

/// Anything that a file may hold, or something near a surface that a person would bring.
std::shared_ptr<const Guide> any_surface(FuzzedDataProvider& input) {
    constexpr std::array k_kinds{fuzz::any_mesh, fuzz::any_patch, fuzz::any_tube, fuzz::any_rough_dish};
    Mesh mesh = k_kinds[input.ConsumeIntegralInRange<std::size_t>(0, k_kinds.size() - 1)](input);
    if (input.ConsumeBool()) return std::make_shared<const Guide>(Surface(mesh));
    return std::make_shared<const Guide>(repaired_surface(std::move(mesh), k_all_defects).surface);
}

void require_description(const Surface& surface) {
    const SurfaceReport report = describe(surface);
    require(!report.sentence.empty() && report.components >= 1 && report.genus >= 0, "a description of nothing");
    require(report.triangles == surface.face_count(), "a description of other triangles");
}

double any_angle(FuzzedDataProvider& input) {
    return input.ConsumeBool() ? input.ConsumeFloatingPointInRange(0.0, std::numbers::pi) : fuzz::any_number(input);
}

DrapeOptions any_drape(FuzzedDataProvider& input, const Guide& guide) {
    DrapeOptions options = suggested_drape(guide.surface(), guide.tree(), input.ConsumeIntegralInRange(1, 200));
    if (input.ConsumeBool()) options.seed = guide.surface().positions().col(0);
    if (input.ConsumeBool())
        for (double& coordinate : options.direction) coordinate = fuzz::any_number(input);
    if (input.ConsumeIntegralInRange(0, 7) == 0) options.length = fuzz::any_number(input);
    if (input.ConsumeIntegralInRange(0, 3) == 0) options.angle = any_angle(input);
    if (input.ConsumeIntegralInRange(0, 3) == 0) options.smallest_angle = any_angle(input);
    options.reach = input.ConsumeIntegralInRange(0, k_farthest_reach);
    options.border =
        input.PickValueInArray({DrapeOptions::Border::inside, DrapeOptions::Border::beyond, DrapeOptions::Border::cut});
    options.slits = input.ConsumeBool();
    return options;
}

/// Through vertices of the surface, and now and then a point anywhere.
MarkedCrease any_crease(FuzzedDataProvider& input, const Surface& surface) {
    MarkedCrease points(3, input.ConsumeIntegralInRange(0, 5));
    for (int k = 0; k < points.cols(); ++k)
        points.col(k) = surface.positions().col(input.ConsumeIntegralInRange(0, surface.vertex_count() - 1));
    if (points.cols() > 0 && input.ConsumeIntegralInRange(0, 7) == 0) points(0, 0) = fuzz::any_number(input);
    if (points.cols() > 1 && input.ConsumeBool()) points.rightCols(1) = points.leftCols(1).eval();
    return points;
}

/// Of vertices of the surface, and now and then anywhere or for any valence.
SingularWishes any_wishes(FuzzedDataProvider& input, const Surface& surface) {
    const auto any_place = [&] {
        Eigen::Vector3d place = surface.positions().col(input.ConsumeIntegralInRange(0, surface.vertex_count() - 1));
        if (input.ConsumeIntegralInRange(0, 7) == 0) place.x() = fuzz::any_number(input);
        return place;
    };
    SingularWishes wishes;
    for (int k = input.ConsumeIntegralInRange(0, 3); k > 0; --k) {
        const Eigen::Vector3d place = any_place();
        wishes.vertices.push_back({place, input.ConsumeIntegralInRange(2, 6)});
    }
    for (int k = input.ConsumeIntegralInRange(0, 2); k > 0; --k) {
        const Eigen::Vector3d place = any_place();
        const double part = input.ConsumeFloatingPointInRange(0.01, 1.0);
        wishes.forbidden.push_back(
            {place, input.ConsumeBool() ? part * std::sqrt(surface.area()) : fuzz::any_number(input)});
    }
    wishes.only = input.ConsumeIntegralInRange(0, 3) == 0;
    return wishes;
}

RemeshOptions any_remesh(FuzzedDataProvider& input, const Surface& surface) {
    RemeshOptions options;
    options.cells = input.ConsumeIntegralInRange(15, 80);
    options.smoothing = input.PickValueInArray({1., 0., 10.});
    if (input.ConsumeBool()) options.smallest_angle = any_angle(input);
    if (input.ConsumeBool()) options.crease = any_angle(input);
    for (int k = input.ConsumeIntegralInRange(0, 2); k > 0; --k)
        options.marked_creases.push_back(any_crease(input, surface));
    options.border = input.PickValueInArray({RemeshOptions::Border::always, RemeshOptions::Border::across,
                                             RemeshOptions::Border::never, RemeshOptions::Border::fitting,
                                             RemeshOptions::Border::outer});
    options.fewest = input.ConsumeBool();
    if (input.ConsumeIntegralInRange(0, 3) == 3)
        options.length = input.ConsumeBool() ? fuzz::any_number(input) : std::sqrt(surface.area() / options.cells);
    if (input.ConsumeIntegralInRange(0, 3) == 3) options.singular = any_wishes(input, surface);
    return options;
}

/// Where it can be measured in the time there is: samples of the surface are as many as the cells that would cover it.
void require_net(const Guide& guide, const Net& net, const invariants::Asked& asked,
                 std::optional<double> known = std::nullopt) {
    const double length = known.value_or(net.rest_lengths().maxCoeff());
    if (!(guide.surface().area() < k_most_cells * length * length)) return;
    const DrapeReport report = measure_drape(guide.surface(), guide.tree(), net, known);
    for (const std::string& violation : invariants::of_net_on_surface(guide.surface(), net, report, asked))
        require(false, violation);
}

template <class Make>
void try_to(Make make) {
    try {
        make();
    } catch (const Error& error) {
        fuzz::require_readable(error);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider input(data, size);
    try_to([&] {
        const auto guide = any_surface(input);
        require_description(guide->surface());
        if (input.ConsumeBool() && guide->surface().face_count() <= k_most_remeshed)
            try_to([&] {
                const RemeshOptions options = any_remesh(input, guide->surface());
                const Remesh made = remesh(guide, options);
                require_net(*guide, made.net,
                            {.smallest_angle = made.sharp_quads > 0 ? 0 : options.smallest_angle - 1e-3});
            });
        const DrapeOptions options = any_drape(input, *guide);
        const invariants::Asked asked{options.smallest_angle, options.border == DrapeOptions::Border::cut};
        try_to(
            [&] { require_net(*guide, drape(guide->surface(), guide->tree(), options).net, asked, options.length); });
        const double leave = input.ConsumeBool() ? 1 : fuzz::any_number(input);
        try_to([&] { require_net(*guide, bridged_drape(guide, options, leave).net, asked, options.length); });
    });
    return 0;
}
