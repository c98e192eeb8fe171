// Lengths that adapt, seen from JavaScript.

#include <string>

#include "border.h"
#include "edit/length_adapter.h"
#include "session.h"

namespace chebnet {
namespace {

/// `vertices`: an Int32Array of n, `targets`: a Float64Array of 3n.
LengthAdapter* length_adapter(const Session& session, val vertices, val targets) {
    const auto vertex = emscripten::convertJSArrayToNumberVector<int>(vertices);
    const auto target = emscripten::convertJSArrayToNumberVector<double>(targets);
    std::vector<Handle> wanted;
    for (std::size_t i = 0; i < vertex.size(); ++i)
        wanted.push_back({vertex[i], Eigen::Vector3d(target[3 * i], target[3 * i + 1], target[3 * i + 2])});
    return new LengthAdapter(session.editor, wanted);
}

val solve(LengthAdapter& adapter, int iterations, double milliseconds) {
    const AdaptReport report = adapter.solve({iterations, milliseconds});
    val object = val::object();
    object.set("status", std::string(to_string(report.status)));
    object.set("scale", report.scale);
    object.set("iterations", report.iterations);
    object.set("milliseconds", report.milliseconds);
    return object;
}

void accept(const LengthAdapter& adapter, Session& session) { session.editor.set_state(adapter.state()); }

EMSCRIPTEN_BINDINGS(chebnet_lengths) {
    emscripten::function("lengthAdapter", guarded<&length_adapter>, emscripten::allow_raw_pointers());
    emscripten::class_<LengthAdapter>("LengthAdapter")
        .function("solve", guarded<&solve>)
        .function("accept", guarded<&accept>);
}

}  // namespace
}  // namespace chebnet
