// The search for a net that is less strained, seen from JavaScript.

#include <string>

#include "border.h"
#include "edit/rest_search.h"
#include "session.h"

namespace chebnet {
namespace {

RestSearch* rest_search(const Session& session) { return new RestSearch(session.editor); }

val solve(RestSearch& search, int iterations, double milliseconds) {
    const RestSearchReport report = search.solve({iterations, milliseconds});
    val object = val::object();
    object.set("status", std::string(to_string(report.status)));
    object.set("done", report.done);
    object.set("energyBefore", report.energy_before);
    object.set("energy", report.energy);
    object.set("iterations", report.iterations);
    object.set("milliseconds", report.milliseconds);
    return object;
}

void accept(const RestSearch& search, Session& session) { session.editor.set_state(search.state()); }

EMSCRIPTEN_BINDINGS(chebnet_rests) {
    emscripten::function("restSearch", guarded<&rest_search>, emscripten::allow_raw_pointers());
    emscripten::class_<RestSearch>("RestSearch")
        .function("solve", guarded<&solve>)
        .function("accept", guarded<&accept>);
}

}  // namespace
}  // namespace chebnet
