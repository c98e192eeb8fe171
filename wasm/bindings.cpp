// The editor and its tables, seen from JavaScript. wasm/facade.js gives them the shape of wasm/chebnet.d.ts.

#include <emscripten/heap.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "border.h"
#include "edit/editor.h"
#include "edit/field.h"
#include "edit/flip.h"
#include "edit/net_forces.h"
#include "fabricate/rod_table.h"
#include "io/format.h"
#include "io/obj.h"
#include "mesh_border.h"
#include "net/measures.h"
#include "net/net.h"
#include "net/rods.h"
#include "session.h"
#include "shapes/shapes.h"
#include "solve/initialisation.h"
#include "solve/method.h"
#include "solve/options.h"

namespace chebnet {
namespace {

// ------------------------------------------------------------------------------------------------------------ tables

void set_text(val& row, const char* name, const char* text) { row.set(name, std::string(text)); }

val parameter_out(const ShapeParameter& parameter) {
    val row = val::object();
    set_text(row, "name", parameter.name);
    row.set("value", parameter.value);
    row.set("smallest", parameter.smallest);
    row.set("largest", parameter.largest);
    set_text(row, "sentence", parameter.sentence);
    return row;
}

val shapes() {
    return list_out(shape_table(), [](const ShapeInfo& shape) {
        val row = val::object();
        set_text(row, "name", shape.name);
        set_text(row, "title", shape.title);
        set_text(row, "sentence", shape.sentence);
        row.set("parameters", list_out(shape.parameters, parameter_out));
        set_text(row, "offered", shape.offered != nullptr ? shape.offered : shape.name);
        return row;
    });
}

val texts(NameList names) {
    return list_out(names, [](const char* name) { return std::string(name); });
}

val options_of(const MethodInfo& method) {
    val list = val::array();
    for (const OptionInfo& option : option_table())
        if (reads(method, option.name)) list.call<void>("push", std::string(option.name));
    return list;
}

val methods() {
    return list_out(method_table(), [](const MethodInfo& method) {
        val row = val::object();
        set_text(row, "name", method.name);
        set_text(row, "sentence", method.sentence);
        set_text(row, "citation", method.citation);
        row.set("slides", method.heeds.slides);
        row.set("stages", texts(method.stages));
        row.set("options", options_of(method));
        return row;
    });
}

val initialisations() {
    return list_out(initialisation_table(), [](const InitialisationInfo& initialisation) {
        val row = val::object();
        set_text(row, "name", initialisation.name);
        row.set("counted", initialisation.counted);
        set_text(row, "sentence", initialisation.sentence);
        set_text(row, "citation", initialisation.citation);
        return row;
    });
}

val formats() {
    return list_out(format_table(), [](const FormatInfo& format) {
        val row = val::object();
        set_text(row, "name", format.name);
        set_text(row, "title", format.title);
        set_text(row, "sentence", format.sentence);
        set_text(row, "mediaType", format.media_type);
        return row;
    });
}

val option_rows(const Options& values) {
    return list_out(option_table(), [&](const OptionInfo& option) {
        val row = val::object();
        set_text(row, "name", option.name);
        set_text(row, "kind", to_string(option.kind));
        row.set("value", get_option(values, option.name));
        row.set("smallest", option.smallest);
        row.set("largest", option.largest);
        set_text(row, "sentence", option.sentence);
        return row;
    });
}

val default_options() { return option_rows(Options{}); }

// ----------------------------------------------------------------------------------------------------------- opening

Session* open_recipe(std::string recipe) {
    Shape shape = make_shape(recipe);
    return new Session{Editor(std::move(shape.net)), std::move(shape.suggested_handles)};
}

constexpr EnumName<RestLengths> k_rest_lengths[] = {
    {"automatic", RestLengths::automatic}, {"equal", RestLengths::equal}, {"own", RestLengths::own}};

Session* open(Mesh mesh, const std::string& rest_lengths) {
    Net net(std::move(mesh.positions), std::move(mesh.faces),
            named(k_rest_lengths, rest_lengths, "choice of rest lengths"));
    return new Session{Editor(std::move(net)), {}};
}

Session* open_obj(std::string text, std::string name, std::string rest_lengths) {
    return open(read_obj(text, name), rest_lengths);
}

Session* open_mesh(val mesh, std::string rest_lengths) { return open(mesh_in(mesh), rest_lengths); }

// ----------------------------------------------------------------------------------------------------------- the net

/// An object of counts by their size.
val counts_out(const std::map<int, int>& counts) {
    val object = val::object();
    for (const auto& [size, count] : counts) object.set(size, count);
    return object;
}

val info(const Session& session) {
    const Net& net = session.editor.net();
    const Topology& topology = session.editor.topology();
    const LengthRange lengths = edge_length_range(net, net.rest_positions());
    val info = val::object();
    info.set("vertices", net.vertex_count());
    info.set("edges", net.edge_count());
    info.set("faces", net.face_count());
    info.set("boundaryLoops", static_cast<int>(topology.boundary_loops().size()));
    info.set("components", topology.component_count());
    info.set("facesByArity", counts_out(faces_by_arity(net.faces())));
    info.set("singularVertices", counts_out(topology.singular_vertices()));
    info.set("shortestLength", lengths.shortest);
    info.set("meanLength", net.mean_length());
    info.set("longestLength", lengths.longest);
    info.set("edgeLength", shared_length(net).value_or(net.mean_length()));
    info.set("maxDeviationFromMean", max_deviation_from_mean(net));
    info.set("isChebyshev", net.is_chebyshev());
    return info;
}

val edges(const Session& session) { return copy_out(session.editor.net().edges()); }
val face_start(const Session& session) { return copy_out(session.editor.net().faces().start); }
val face_vertices(const Session& session) { return copy_out(session.editor.net().faces().vertices); }
val rest_positions(const Session& session) { return copy_out(session.editor.net().rest_positions()); }
val rest_lengths(const Session& session) { return copy_out(session.editor.net().rest_lengths()); }
val net_lines(const Session& session) { return lists_out(session.editor.topology().net_lines()); }
val rod_lines(const Session& session) { return lists_out(rods(session.editor.net(), session.editor.topology())); }
val boundary_loops(const Session& session) { return lists_out(session.editor.topology().boundary_loops()); }
val flat_pattern(const Session& session) { return flat_pattern_out(session.editor.net(), session.editor.topology()); }
val suggested_handles(const Session& session) { return copy_out(session.suggested_handles); }

// --------------------------------------------------------------------------------------------------- what is asked for

std::string method(const Session& session) { return session.editor.method(); }
std::string initialisation(const Session& session) { return session.editor.initialisation(); }
val options(const Session& session) { return option_rows(session.editor.options()); }

val handle_vertices(const Session& session) {
    std::vector<int> vertices;
    for (const Handle& handle : session.editor.handles()) vertices.push_back(handle.vertex);
    return copy_out(vertices);
}

val handle_targets(const Session& session) {
    std::vector<double> targets;
    for (const Handle& handle : session.editor.standing_handles())
        targets.insert(targets.end(), handle.target.begin(), handle.target.end());
    return copy_out(targets);
}

val handle_weights(const Session& session) {
    std::vector<double> weights;
    for (const Handle& handle : session.editor.handles()) weights.push_back(handle.weight);
    return copy_out(weights);
}

/// The axes along which each slides, as Axes.
val handle_slides(const Session& session) {
    std::vector<int> slides;
    for (const Handle& handle : session.editor.handles()) slides.push_back(handle.slides);
    return copy_out(slides);
}

/// `vertices` and `slides`: an Int32Array of n, `targets`: a Float64Array of 3n, `weights`: a Float64Array of n.
std::vector<Handle> handles_in(val vertices, val targets, val weights, val slides) {
    const auto vertex = emscripten::convertJSArrayToNumberVector<int>(vertices);
    const auto target = emscripten::convertJSArrayToNumberVector<double>(targets);
    const auto weight = emscripten::convertJSArrayToNumberVector<double>(weights);
    const auto axes = emscripten::convertJSArrayToNumberVector<int>(slides);
    std::vector<Handle> handles;
    for (std::size_t i = 0; i < vertex.size(); ++i)
        handles.push_back(
            {vertex[i], Eigen::Vector3d(target[3 * i], target[3 * i + 1], target[3 * i + 2]), weight[i], axes[i]});
    return handles;
}

/// null: everything may move.
val locality(const Session& session) {
    const std::optional<Locality> locality = session.editor.state().locality;
    if (!locality) return val::null();
    val object = val::object();
    object.set("radius", locality->radius);
    object.set("origins", copy_out(locality->origins));
    object.set("heldAt", copy_out(locality->held_at));
    return object;
}

/// 5 numbers a ball: the vertex, the centre, the radius.
val reach(const Session& session, int vertex) {
    std::vector<double> numbers;
    for (const Ball& ball : session.editor.reach(vertex))
        numbers.insert(numbers.end(), {static_cast<double>(ball.vertex), ball.centre.x(), ball.centre.y(),
                                       ball.centre.z(), ball.radius});
    return copy_out(numbers);
}

val flipped(const Session& session) {
    const Editor& editor = session.editor;
    return copy_out(flipped(editor.net(), editor.handles(), editor.positions()));
}

val mobility(const Session& session, double radius, val origins) {
    return copy_out(session.editor.mobility(radius, emscripten::convertJSArrayToNumberVector<int>(origins)));
}

/// `along`: k_no_axes if the hand is kept to none.
void drag_handle(Session& session, int vertex, double x, double y, double z, Axes along) {
    session.editor.drag_handle(vertex, Eigen::Vector3d(x, y, z), along == k_no_axes ? k_all_axes : along);
}

void release_handles(Session& session) { session.editor.release_handles(); }

bool holds_back(const Session& session) { return session.editor.holds_back(); }

void move_handle(Session& session, int vertex, double x, double y, double z) {
    session.editor.move_handle(vertex, Eigen::Vector3d(x, y, z));
}

/// `flat`: a Float64Array whose length is a multiple of 3.
Positions positions_in(val flat) {
    const auto numbers = emscripten::convertJSArrayToNumberVector<double>(flat);
    return Eigen::Map<const Positions>(numbers.data(), 3, static_cast<Eigen::Index>(numbers.size() / 3));
}

/// By set_state() or change_state(). `options`: names and values in turn; those not named are at their defaults.
/// `locality`: as locality() gives it.
template <void (Editor::*go_to)(EditState)>
void set_state(Session& session, std::string method, std::string initialisation, val options, val handles, val locality,
               val positions) {
    EditState state;
    state.method = std::move(method);
    state.initialisation = std::move(initialisation);
    const auto words = emscripten::vecFromJSArray<std::string>(options);
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) set_option(state.options, words[i], words[i + 1]);
    state.handles = handles_in(handles["vertices"], handles["targets"], handles["weights"], handles["slides"]);
    if (!locality.isNull())
        state.locality = Locality{locality["radius"].as<double>(),
                                  emscripten::convertJSArrayToNumberVector<int>(locality["origins"]),
                                  positions_in(locality["heldAt"])};
    state.guide = session.editor.guide();
    state.positions = positions_in(positions);
    (session.editor.*go_to)(std::move(state));
}

// ------------------------------------------------------------------------------------------------------------ solving

/// 12 numbers a row, in the order of TraceRow.
val flat_trace(const Trace& trace) {
    std::vector<double> numbers;
    numbers.reserve(12 * trace.size());
    for (const TraceRow& row : trace) {
        numbers.insert(numbers.end(),
                       {static_cast<double>(row.iteration), static_cast<double>(row.stage), row.p, row.energy,
                        row.max_deviation, row.gradient_norm, row.step, static_cast<double>(row.free_vertices),
                        row.assembly_ms, row.factorisation_ms, row.line_search_ms, row.total_ms});
    }
    return copy_out(numbers);
}

val to_rest_out(const ToRest& left) {
    val object = val::object();
    object.set("gradientNorm", left.gradient_norm);
    object.set("cornerLack", left.corner_lack);
    object.set("motion", left.motion);
    return object;
}

val solve(Session& session, int iterations, double milliseconds) {
    const SolveReport report = session.editor.solve({iterations, milliseconds});
    val result = val::object();
    result.set("status", std::string(to_string(report.status)));
    result.set("maxDeviation", report.max_deviation);
    result.set("milliseconds", report.milliseconds);
    result.set("factorisationMs", report.factorisation_ms);
    result.set("iterations", report.iterations);
    result.set("toRest", report.to_rest ? to_rest_out(*report.to_rest) : val::null());
    result.set("trace", flat_trace(report.trace));
    return result;
}

void reset(Session& session) { session.editor.reset(); }

// ---------------------------------------------------------------------------------------------------------- the result

val positions(const Session& session) { return copy_out(session.editor.positions()); }

val fields(const Session& session) {
    val result = val::object();
    for (const FieldInfo& field : field_table()) {
        const Eigen::VectorXf numbers = field.numbers(session.editor).cast<float>();
        result.set(field.name, copy_out(numbers));
    }
    return result;
}

double bend_of(const Session& session) {
    return bend(session.editor.net(), session.editor.topology(), session.editor.positions());
}

double smallest_angle(const Session& session) {
    return corner_angle_range(session.editor.net(), session.editor.positions()).smallest;
}

double handle_error(const Session& session) { return session.editor.handle_error(); }

val unreachable_pairs(const Session& session) { return pairs_out(session.editor.unreachable_pairs()); }

std::string to_obj(const Session& session, int digits) {
    return write_obj(session.editor.positions(), session.editor.net().faces(), digits);
}

std::string edges_to_csv(const Session& session) { return edge_table(session.editor); }

std::string rods_to_csv(const Session& session) {
    const Editor& editor = session.editor;
    return rod_table(editor.net(), Topology(editor.net()), editor.positions());
}

/// `name`: of a format; `ply_text` is the PLY that is text, another name for a way to write rather than for a format.
val to_file(const Session& session, std::string name) {
    WriteMesh* const write = name == "ply_text" ? find_format("ply").write_text : find_format(name).write;
    if (write == nullptr) throw Error(ErrorCode::left_out, "files are not written by this module, but by chebnet_core");
    return bytes_out(write(session.editor.positions(), session.editor.net().faces()));
}

/// As a number that JavaScript has, above 2 GB too.
double memory() { return static_cast<double>(emscripten_get_heap_size()); }

EMSCRIPTEN_BINDINGS(chebnet) {
    emscripten::constant("largestSize", k_largest_size);
    emscripten::function("shapes", guarded<&shapes>);
    emscripten::function("methods", guarded<&methods>);
    emscripten::function("initialisations", guarded<&initialisations>);
    emscripten::function("formats", guarded<&formats>);
    emscripten::function("defaultOptions", guarded<&default_options>);
    emscripten::function("memory", guarded<&memory>);
    emscripten::function("openRecipe", guarded<&open_recipe>, emscripten::allow_raw_pointers());
    emscripten::function("openObj", guarded<&open_obj>, emscripten::allow_raw_pointers());
    emscripten::function("openMesh", guarded<&open_mesh>, emscripten::allow_raw_pointers());
    emscripten::class_<Session>("Session")
        .function("info", guarded<&info>)
        .function("edges", guarded<&edges>)
        .function("faceStart", guarded<&face_start>)
        .function("faceVertices", guarded<&face_vertices>)
        .function("restPositions", guarded<&rest_positions>)
        .function("restLengths", guarded<&rest_lengths>)
        .function("netLines", guarded<&net_lines>)
        .function("rods", guarded<&rod_lines>)
        .function("boundaryLoops", guarded<&boundary_loops>)
        .function("flatPattern", guarded<&flat_pattern>)
        .function("suggestedHandles", guarded<&suggested_handles>)
        .function("method", guarded<&method>)
        .function("initialisation", guarded<&initialisation>)
        .function("options", guarded<&options>)
        .function("handleVertices", guarded<&handle_vertices>)
        .function("handleTargets", guarded<&handle_targets>)
        .function("handleWeights", guarded<&handle_weights>)
        .function("handleSlides", guarded<&handle_slides>)
        .function("locality", guarded<&locality>)
        .function("reach", guarded<&reach>)
        .function("flipped", guarded<&flipped>)
        .function("mobility", guarded<&mobility>)
        .function("moveHandle", guarded<&move_handle>)
        .function("dragHandle", guarded<&drag_handle>)
        .function("releaseHandles", guarded<&release_handles>)
        .function("holdsBack", guarded<&holds_back>)
        .function("setState", guarded<&set_state<&Editor::set_state>>)
        .function("changeState", guarded<&set_state<&Editor::change_state>>)
        .function("solve", guarded<&solve>)
        .function("reset", guarded<&reset>)
        .function("positions", guarded<&positions>)
        .function("fields", guarded<&fields>)
        .function("bend", guarded<&bend_of>)
        .function("smallestAngle", guarded<&smallest_angle>)
        .function("handleError", guarded<&handle_error>)
        .function("unreachablePairs", guarded<&unreachable_pairs>)
        .function("toObj", guarded<&to_obj>)
        .function("edgeTable", guarded<&edges_to_csv>)
        .function("rodTable", guarded<&rods_to_csv>)
        .function("toFile", guarded<&to_file>);
}

}  // namespace
}  // namespace chebnet
