#include "edit/edit_state.h"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <memory>

#include "base/error.h"
#include "base/number.h"
#include "constants.h"
#include "counting_method.h"
#include "edit/editor.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "solve/methods/methods.h"
#include "surface/guide.h"

using namespace chebnet;

namespace {

constexpr int k_dragged = 71;

Net net() { return samples::patch(9, 8); }

/// Nothing as it is in a new editor: the net has been dragged within a locality and stands elsewhere than it is held.
Editor edited() {
    Editor editor(net());
    editor.set_option("length_scale", "1.01");
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 8, 63, k_dragged});
    handles[1].weight = 0.5;
    editor.set_handles(handles);
    editor.set_initialisation("arap:3");
    editor.set_option("max_iterations", "70");
    editor.set_option("reduce_once", "on");
    editor.set_guide(std::make_shared<const Guide>(Surface(samples::plane(3, 5))));
    editor.set_locality(6, std::vector{k_dragged});
    editor.move_handle(k_dragged, handles[3].target - 0.4 * Eigen::Vector3d::UnitX());
    editor.solve();
    return editor;
}

void check_same(const EditState& a, const EditState& b) {
    REQUIRE(a.handles.size() == b.handles.size());
    for (std::size_t i = 0; i < a.handles.size(); ++i) {
        CHECK(a.handles[i].vertex == b.handles[i].vertex);
        CHECK(a.handles[i].target == b.handles[i].target);
        CHECK(a.handles[i].weight == b.handles[i].weight);
    }
    CHECK(a.method == b.method);
    CHECK(a.initialisation == b.initialisation);
    for (const OptionInfo& option : option_table()) {
        INFO(option.name);
        CHECK(get_option(a.options, option.name) == get_option(b.options, option.name));
    }
    REQUIRE(a.locality.has_value() == b.locality.has_value());
    if (a.locality) {
        CHECK(a.locality->radius == b.locality->radius);
        CHECK(a.locality->origins == b.locality->origins);
        CHECK(a.locality->held_at == b.locality->held_at);
    }
    CHECK(a.guide == b.guide);
    CHECK(a.positions == b.positions);
}

void drag_on(Editor& editor) {
    for (int frame = 1; frame <= 3; ++frame) {
        editor.move_handle(k_dragged, editor.handles().back().target + 0.1 * Eigen::Vector3d::UnitZ());
        editor.solve();
    }
}

ErrorCode code_of_setting(Editor& editor, const EditState& state) {
    try {
        editor.set_state(state);
    } catch (const Error& error) {
        return error.code();
    }
    FAIL("nothing was refused");
    return {};
}

}  // namespace

TEST_CASE("A second editor takes over every field of the state") {
    const EditState state = edited().state();
    CHECK(state.handles[1].weight == 0.5);
    CHECK(state.initialisation == "arap:3");
    CHECK(state.options.max_iterations == 70);
    CHECK(state.options.length_scale == 1.01);
    REQUIRE(state.locality);
    CHECK(state.locality->radius == 6);
    CHECK(state.locality->origins == std::vector{k_dragged});
    CHECK(state.locality->held_at != state.positions);
    Editor second(net());
    second.set_method("li2022");
    second.set_state(state);
    check_same(second.state(), state);
    CHECK(second.positions() == state.positions);
    CHECK(second.method() == state.method);
}

TEST_CASE("Editors that were set to the same state go on to the same positions, bit for bit") {
    const std::string method = GENERATE(as<std::string>{}, "projection", "li2022", "local_global");
    const bool local = GENERATE(true, false);
    INFO(method);
    EditState state = edited().state();
    state.method = method;
    if (method != "projection") state.handles[1].weight = samples::k_infinity;  // which alone knows soft handles
    if (!local) state.locality.reset();
    Editor first(net()), second(net());
    first.set_state(state);
    check_same(first.state(), state);
    second.set_state(first.state());
    drag_on(first);
    drag_on(second);
    CHECK(first.positions() != state.positions);
    check_same(first.state(), second.state());
}

TEST_CASE("Where a state is no net, the net of another state does not count as its last") {
    const auto at = [](double way) {
        std::vector<Handle> handles = samples::handles_at_rest(net(), {0, 8, 63, k_dragged});
        handles.back().target.x() += way;
        return handles;
    };
    Editor first(net()), second(net());
    first.set_handles(at(30));
    REQUIRE(first.solve().status == Status::unreachable);
    const EditState stretched = first.state();
    first.reset();
    first.set_handles(at(-1.5));
    REQUIRE(keeps_lengths(first.solve().status));
    REQUIRE(first.last_net() != net().rest_positions());
    first.set_state(stretched);
    second.set_state(stretched);
    CHECK(first.last_net() == second.last_net());
}

TEST_CASE("A locality that holds where the net stands now is another than one that says where") {
    Editor editor = edited();
    const Locality there = *editor.state().locality;
    Locality here = there;
    here.held_at.resize(3, 0);
    CHECK(!(here == there));
    CHECK(there == there);
    editor.set_locality(there.radius, there.origins);
    CHECK(editor.state().locality->held_at == editor.positions());
}

TEST_CASE("A state with anything wrong in it is refused whole") {
    const EditState good = edited().state();
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    struct Refusal {
        const char* what;
        ErrorCode code;
        std::function<void(EditState&)> spoil;
    };
    const Refusal refusals[] = {
        {"a handle out of range", ErrorCode::index_out_of_range,
         [&](EditState& s) {
             s.handles = {{72, origin}};
         }},
        {"two handles at a vertex", ErrorCode::repeated_vertex,
         [&](EditState& s) {
             s.handles = {{3, origin}, {3, origin}};
         }},
        {"a target nowhere", ErrorCode::non_finite, [&](EditState& s) { s.handles[0].target.x() = nan; }},
        {"a weight of 0", ErrorCode::bad_option, [&](EditState& s) { s.handles[1].weight = 0; }},
        {"no such method", ErrorCode::bad_option, [&](EditState& s) { s.method = "magic"; }},
        {"a method that knows no soft handles", ErrorCode::bad_option, [&](EditState& s) { s.method = "li2022"; }},
        {"no such initialisation", ErrorCode::bad_option, [&](EditState& s) { s.initialisation = "arap:0"; }},
        {"an option out of range", ErrorCode::bad_option, [&](EditState& s) { s.options.p_end = 1000; }},
        {"an option that is no number", ErrorCode::bad_option, [&](EditState& s) { s.options.threshold = nan; }},
        {"a radius of 0", ErrorCode::bad_option, [&](EditState& s) { s.locality->radius = 0; }},
        {"an origin out of range", ErrorCode::index_out_of_range, [&](EditState& s) { s.locality->origins = {-1}; }},
        {"held positions of another net", ErrorCode::index_out_of_range,
         [&](EditState& s) { s.locality->held_at = Positions::Zero(3, 5); }},
        {"a held position nowhere", ErrorCode::non_finite, [&](EditState& s) { s.locality->held_at(0, 5) = nan; }},
        {"positions of another net", ErrorCode::index_out_of_range,
         [&](EditState& s) { s.positions = Positions::Zero(3, 5); }},
        {"a position nowhere", ErrorCode::non_finite, [&](EditState& s) { s.positions(2, 7) = nan; }},
    };
    for (const Refusal& refusal : refusals) {
        INFO(refusal.what);
        // What else is in it is good, and none of it is as this editor has it.
        EditState state = good;
        refusal.spoil(state);
        Editor editor(net());
        editor.set_handles(samples::handles_at_rest(editor.net(), {1, 70}));
        editor.set_locality(3, std::vector{1});
        const EditState before = editor.state();
        CHECK(code_of_setting(editor, state) == refusal.code);
        check_same(editor.state(), before);
        CHECK(editor.handle_graph().size() == 2);
    }
}

TEST_CASE("The present state, set again, leaves a solve under way and what it has prepared") {
    int prepared = 0;
    Editor editor(net());
    editor.set_method(std::make_unique<samples::CountingMethod>(make_method("li2022"), prepared), "counted");
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 8, 63, k_dragged}));
    editor.set_locality(6, std::vector{k_dragged});
    editor.move_handle(k_dragged, editor.handles().back().target - 0.4 * Eigen::Vector3d::UnitX());
    editor.solve({1});
    editor.set_state(editor.state());
    editor.set_option("max_iterations", number_text(editor.options().max_iterations, 6));
    editor.set_initialisation(editor.initialisation());
    editor.set_method(editor.method());
    CHECK(editor.solve({1}).trace.at(0).iteration == 2);
    editor.set_option("threshold", "1e-9");
    CHECK(editor.solve({1}).trace.at(0).iteration == 1);
    CHECK(prepared == 1);
}

TEST_CASE("A state knows vertices that were far handles once") {
    Editor editor = edited();
    editor.move_handle(k_dragged, Eigen::Vector3d(1e200, 0, 0));
    editor.solve();
    const std::vector<Handle> others(editor.handles().begin(), editor.handles().end() - 1);
    editor.set_handles(others);
    CHECK(editor.positions()(0, k_dragged) == 1e200);
    Editor second(net());
    second.set_state(editor.state());
    check_same(second.state(), editor.state());
    second.solve();
    CHECK(second.positions().cwiseAbs().maxCoeff() < 1e3);
}

TEST_CASE("A locality in a state may be one that begins now, or none") {
    Editor editor = edited();
    EditState state = editor.state();
    state.locality = Locality{3, {k_dragged}, {}};
    editor.set_state(state);
    REQUIRE(editor.region());
    CHECK(editor.state().locality->held_at == editor.positions());
    state.locality->radius = samples::k_infinity;
    editor.set_state(state);
    CHECK_FALSE(editor.region());
    state.locality.reset();
    editor.set_state(state);
    CHECK_FALSE(editor.region());
}

TEST_CASE("Exact handles of a state stand at their targets, and the locality starts from there") {
    Editor editor = edited();
    EditState state = editor.state();
    const Eigen::Vector3d target = state.handles[0].target + Eigen::Vector3d::UnitZ();
    state.handles[0].target = target;
    state.locality->held_at.resize(3, 0);
    editor.set_state(state);
    CHECK(editor.positions().col(0) == target);
    CHECK(editor.state().locality->held_at.col(0) == target);
    CHECK(editor.handle_error() == 0);
}

TEST_CASE("A state with the same handles, method and locality keeps the symbolic factorisation") {
    int prepared = 0;
    Editor editor = edited();
    editor.set_method(std::make_unique<samples::CountingMethod>(make_method("projection"), prepared), "counted");
    const auto solve_moved = [&](EditState state) {
        state.handles.back().target.z() += 0.1;
        editor.set_state(state);
        editor.solve();
    };
    editor.solve();
    CHECK(prepared == 1);
    solve_moved(editor.state());
    CHECK(prepared == 1);
    CHECK(editor.method() == "counted");
    EditState state = editor.state();
    state.options.threshold = 1e-8;
    solve_moved(state);
    CHECK(prepared == 1);
    state.locality->radius = 4;
    solve_moved(state);
    CHECK(prepared == 2);
    state.locality.reset();
    solve_moved(state);
    CHECK(prepared == 3);
    state.handles.erase(state.handles.begin());
    solve_moved(state);
    CHECK(prepared == 4);
    CHECK(editor.handle_graph().size() == 3);
    state.initialisation = "naive";
    solve_moved(state);
    CHECK(prepared == 5);
}

TEST_CASE("A state is taken as it is, also where its positions are the present ones and its lengths are not") {
    Editor first(net());
    first.set_handles(samples::handles_at_rest(net(), {0}));
    first.set_option("length_scale", "1.3");
    first.set_positions(net().rest_positions());
    first.set_locality(3, std::vector{0});
    const EditState state = first.state();
    Editor second(net()), third(net());
    third.set_positions(2 * net().rest_positions());
    for (Editor* editor : {&second, &third}) {
        editor->set_state(state);
        check_same(editor->state(), state);
        CHECK(editor->region());
        editor->solve();
    }
    CHECK(second.positions() == third.positions());

    // The same of a change of the present state, in which the net grows.
    Editor changed(net());
    EditState longer = changed.state();
    longer.options.length_scale = 1.3;
    changed.change_state(longer);
    CHECK(changed.positions() != longer.positions);
    CHECK(changed.solve().iterations == 0);
    changed.set_state(longer);
    CHECK(changed.positions() == longer.positions);
}
