#include "solve/initialisation.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/parts/arap_step.h"
#include "solve/parts/local_global_step.h"

using namespace chebnet;

namespace {

Editor pulled_editor() {
    Editor editor(samples::patch(9, 8));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 8, 63, 71});
    handles.back().target += Eigen::Vector3d(-0.7, -0.5, 1.2);
    editor.set_handles(handles);
    return editor;
}

const std::vector<int> k_handles{0, 8, 63, 71};

}  // namespace

TEST_CASE("An initialisation is so many iterations of its step, from where the net stands") {
    const Editor editor = pulled_editor();
    LaplacianPart part(editor.net(), free_vertices(editor.net().vertex_count(), k_handles));
    Positions by_arap = editor.positions(), by_lengths = by_arap;
    ArapStep arap(part);
    LocalGlobalStep lengths(part);
    for (int k = 0; k < 5; ++k) {
        arap.iterate(by_arap);
        lengths.iterate(by_lengths);
    }
    for (const auto& [name, expected] :
         {std::pair{"naive", editor.positions()}, {"arap:5", by_arap}, {"local_global:5", by_lengths}}) {
        CAPTURE(name);
        Initialisation initialisation(name);
        CHECK(initialisation.name() == name);
        initialisation.prepare(editor.net(), k_handles);
        Positions x = editor.positions();
        const Trace trace = initialisation.apply(x);
        CHECK(x == expected);
        REQUIRE(trace.size() == (name == std::string("naive") ? 0 : 5));
        for (std::size_t k = 0; k < trace.size(); ++k) {
            CHECK(trace[k].iteration == static_cast<int>(k) - 4);
            CHECK(trace[k].stage == 0);
            if (k > 0) CHECK(trace[k].energy <= trace[k - 1].energy);
            if (k > 0) CHECK(trace[k].total_ms >= trace[k - 1].total_ms);
        }
        if (!trace.empty()) CHECK(trace.back().max_deviation == max_deviation(editor.net(), x));
        for (int h : k_handles) CHECK(x.col(h) == editor.positions().col(h));
    }
}

TEST_CASE("Other texts are refused and then nothing changes") {
    Editor editor = pulled_editor();
    editor.set_initialisation("arap:3");
    for (const char* bad : {"", "arap", "arap:", "arap:0", "arap:-1", "arap:1.5", "arap:5x", "arap:10001",
                            "arap:99999999999999", "naive:1", "Naive", "newton:5", ":5", "local_global"}) {
        CAPTURE(bad);
        try {
            editor.set_initialisation(bad);
            FAIL("nothing was refused");
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::bad_option);
        }
    }
    CHECK(editor.initialisation() == "arap:3");
}

TEST_CASE("The trace of a solve begins with what its initialisation did, iterations are the method's") {
    Editor editor = pulled_editor();
    editor.set_initialisation("local_global:5");
    const SolveReport first = editor.solve({2});
    REQUIRE(first.trace.size() == 7);
    CHECK(first.iterations == 2);
    for (int k = 0; k < 7; ++k) CHECK(first.trace[k].iteration == k - 4);
    for (int k = 1; k < 7; ++k) CHECK(first.trace[k].total_ms >= first.trace[k - 1].total_ms);
    CHECK(editor.solve({1}).trace.front().iteration == 3);
}

TEST_CASE("The editor initialises each solve once, for whatever handles there are") {
    Editor by_name = pulled_editor(), by_hand = pulled_editor();
    CHECK(by_name.initialisation() == "naive");
    by_name.set_initialisation("arap:10");
    for (const int added : {40, 30}) {
        std::vector<int> vertices;
        for (const Handle& handle : by_name.handles()) vertices.push_back(handle.vertex);
        Initialisation initialisation("arap:10");
        initialisation.prepare(by_hand.net(), vertices);
        Positions x = by_hand.positions();
        initialisation.apply(x);
        by_hand.set_positions(x);

        CHECK(by_name.solve({1}).status == Status::running);
        CHECK(by_name.solve().status == Status::converged);
        CHECK(by_hand.solve().status == Status::converged);
        CHECK(by_name.positions() == by_hand.positions());

        std::vector<Handle> handles = by_name.handles();
        handles.push_back({added, by_name.positions().col(added) + Eigen::Vector3d(0, 0, 0.3)});
        by_name.set_handles(handles);
        by_hand.set_handles(handles);
    }
}

TEST_CASE("A net that is solved already is not started anew") {
    Editor editor = pulled_editor();
    editor.set_method("projection");
    editor.solve();
    const Positions solved = editor.positions();
    editor.set_initialisation("arap:5");
    CHECK(editor.solve().iterations == 0);
    CHECK(editor.positions() == solved);
}

TEST_CASE("Every initialisation leaves free vertices finite and handles exact, also when the problem is absurd") {
    const std::string name = GENERATE("naive", "arap:5", "local_global:5");
    const Eigen::Vector3d target = GENERATE(Eigen::Vector3d(1e200, 0, 0), Eigen::Vector3d(1e6, 1, 1));
    Editor editor = pulled_editor();
    editor.set_initialisation(name);
    editor.move_handle(71, target);
    editor.solve({1});
    CHECK(editor.positions().allFinite());
    CHECK(editor.handle_error() == 0);
}
