#include "edit/equalize.h"

#include <memory>
#include <optional>
#include <string_view>

#include "arbitrary.h"
#include "require.h"
#include "soak/invariants.h"
#include "surface/guide.h"

using namespace chebnet;
using fuzz::require;

namespace {

std::optional<Net> any_net(FuzzedDataProvider& input) {
    Mesh mesh = fuzz::any_patch(input);
    try {
        return Net(std::move(mesh.positions), std::move(mesh.faces));
    } catch (const Error& error) {
        fuzz::require_readable(error);
        return std::nullopt;
    }
}

EqualizeOptions any_options(FuzzedDataProvider& input) {
    EqualizeOptions options;
    options.choice = input.PickValueInArray({EqualLength::mean, EqualLength::fitting, EqualLength::given});
    options.length = fuzz::any_number(input);
    for (int handles = input.ConsumeIntegralInRange(0, 4); handles > 0; --handles)
        options.handles.push_back(input.ConsumeIntegralInRange(-1, 36));
    return options;
}

/// None most times; else the net's own surface or any other, of which some are far too large or small for it.
std::shared_ptr<const Guide> any_guide(FuzzedDataProvider& input, const Net& net) {
    const int kind = input.ConsumeIntegralInRange(0, 3);
    if (kind < 2) return nullptr;
    try {
        return std::make_shared<const Guide>(
            Surface(kind == 2 ? Mesh{net.rest_positions(), net.faces()} : fuzz::any_patch(input)));
    } catch (const Error& error) {
        fuzz::require_readable(error);
        return nullptr;
    }
}

double largest_deviation_from(double length, const Net& net, const Positions& positions) {
    double largest = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const long double edge =
            (positions.col(net.edges()(0, e)) - positions.col(net.edges()(1, e))).cast<long double>().stableNorm();
        const long double ratio = edge / length;
        largest = std::max(largest, static_cast<double>((ratio - 1) * (ratio - 1) / ratio));
    }
    return largest;
}

void require_step(const Equalizer& equalizer, const EqualizeReport& report, const std::vector<int>& handles) {
    const Net& net = equalizer.original();
    require(equalizer.positions().allFinite(), "a position is not finite");
    if (report.distance)
        require(report.distance->mean >= 0 && report.distance->mean <= report.distance->largest,
                "the distance from the surface is none");
    for (const int v : handles)
        require(equalizer.positions().col(v) == net.rest_positions().col(v), "a handle has moved");
    if (keeps_lengths(report.status))
        require(largest_deviation_from(report.length, net, equalizer.positions()) < 1.01 * k_equal_deviation,
                "it says that edges have one length, but they differ");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider input(data, size);
    EqualizeOptions options = any_options(input);
    std::optional<Net> net = any_net(input);
    if (!net) return 0;
    options.guide = any_guide(input, *net);
    const std::string_view method = input.PickValueInArray({"", "", "equilibrium", "projection", "lbfgs"});
    if (input.ConsumeBool()) options.shear_limit = fuzz::any_number(input);
    try {
        options.way = equalize_way_named(method);
        Equalizer equalizer(std::move(*net), options);
        EqualizeReport report;
        for (int calls = 0; report.status == Status::running && calls < 20; ++calls) {
            report = equalizer.solve({.iterations = input.ConsumeIntegralInRange(1, 8)});
            require_step(equalizer, report, options.handles);
        }
    } catch (const Error& error) {
        fuzz::require_readable(error);
    }
    return 0;
}
