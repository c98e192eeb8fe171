#include "edit/editor.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "base/error.h"
#include "base/number.h"
#include "constants.h"
#include "counting_method.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/methods/methods.h"

using namespace chebnet;

namespace {

Editor held_patch() {
    Editor editor(samples::patch(9, 8));
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 8, 63, 71}));
    return editor;
}

const Eigen::Vector3d k_pull(-0.7, -0.5, 1.0);

template <typename Action>
ErrorCode code_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.code();
    }
    FAIL("nothing was refused");
    return {};
}

}  // namespace

TEST_CASE("Handles are refused by name and then nothing changes") {
    Editor editor = held_patch();
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const Eigen::Vector3d nowhere(0, std::numeric_limits<double>::infinity(), 0);
    CHECK(code_of([&] { editor.set_handles({{72, origin}}); }) == ErrorCode::index_out_of_range);
    CHECK(code_of([&] { editor.set_handles({{-1, origin}}); }) == ErrorCode::index_out_of_range);
    CHECK(code_of([&] { editor.set_handles({{3, origin}, {3, origin}}); }) == ErrorCode::repeated_vertex);
    CHECK(code_of([&] { editor.set_handles({{3, nowhere}}); }) == ErrorCode::non_finite);
    CHECK(code_of([&] { editor.move_handle(3, origin); }) == ErrorCode::index_out_of_range);
    CHECK(code_of([&] { editor.move_handle(0, nowhere); }) == ErrorCode::non_finite);
    CHECK(code_of([&] { editor.set_method("magic"); }) == ErrorCode::bad_option);
    CHECK(code_of([&] { editor.set_option("magic", "1"); }) == ErrorCode::bad_option);
    CHECK(code_of([&] { editor.set_positions(Positions::Zero(3, 5)); }) == ErrorCode::index_out_of_range);
    CHECK(editor.handles().size() == 4);
    CHECK(editor.method() == k_default_method);
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("Moving handles keeps the symbolic factorisation, changing the set renews it") {
    int prepared = 0;
    Editor editor = held_patch();
    editor.set_method(std::make_unique<samples::CountingMethod>(k_li2022.make(), prepared), "counted");
    for (int frame = 1; frame <= 5; ++frame) {
        editor.move_handle(71, editor.net().rest_positions().col(71) + 0.1 * frame * k_pull);
        CHECK(editor.solve().status == Status::converged);
    }
    std::vector<Handle> handles = editor.handles();
    handles[0].target += 0.1 * k_pull;
    editor.set_handles(handles);
    editor.solve();
    CHECK(prepared == 1);

    handles.pop_back();
    editor.set_handles(handles);
    editor.solve();
    CHECK(prepared == 2);
}

TEST_CASE("A solve in slices is the same solve, bit for bit") {
    Editor whole = held_patch(), sliced = held_patch();
    for (Editor* editor : {&whole, &sliced}) editor->move_handle(71, editor->net().rest_positions().col(71) + k_pull);
    const SolveReport report = whole.solve();
    int iterations = 0;
    for (SolveReport slice; slice.status == Status::running;) {
        slice = sliced.solve({1});
        CHECK(slice.iterations <= 1);
        iterations += slice.iterations;
        if (!slice.trace.empty()) CHECK(slice.trace.back().iteration == iterations);
    }
    CHECK(iterations == report.iterations);
    CHECK(whole.positions() == sliced.positions());
}

TEST_CASE("No time is still enough for one iteration") {
    Editor editor = held_patch();
    editor.move_handle(71, editor.net().rest_positions().col(71) + k_pull);
    const SolveReport report = editor.solve({.milliseconds = 0});
    CHECK(report.status == Status::running);
    CHECK(report.iterations == 1);
}

TEST_CASE("The last frame is the next start: small moves take few iterations") {
    Editor editor = held_patch();
    const Eigen::Vector3d rest = editor.net().rest_positions().col(71);
    editor.move_handle(71, rest + k_pull);
    const int cold = editor.solve().iterations;
    editor.move_handle(71, rest + 1.01 * k_pull);
    CHECK(editor.solve().iterations < cold);
}

TEST_CASE("Handles out of reach are named, the net stays finite, and dragging back recovers") {
    Editor editor = held_patch();
    const Eigen::Vector3d rest = editor.net().rest_positions().col(71);
    const double distance = GENERATE(20.0, 200.0);
    editor.move_handle(71, rest + distance * Eigen::Vector3d::UnitX());
    const auto pairs = editor.unreachable_pairs();
    // The handles at the other two corners; the fourth lies behind each of them.
    REQUIRE(pairs.size() == 2);
    for (const UnreachablePair& pair : pairs) {
        CHECK(pair.vertex_b == 71);
        CHECK(pair.distance > pair.reach);
    }
    CHECK(pairs[0].distance / pairs[0].reach >= pairs[1].distance / pairs[1].reach);
    CHECK(pairs.front().reach == Approx(editor.topology().distances_from(71)[pairs.front().vertex_a]));

    CHECK(editor.solve().status == Status::unreachable);
    CHECK(editor.positions().allFinite());
    CHECK(editor.handle_error() == 0);
    CHECK(editor.positions().cwiseAbs().maxCoeff() < 2 * distance + 20);

    editor.move_handle(71, rest);
    CHECK(editor.unreachable_pairs().empty());
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("Handles joined by an edge must be its length apart") {
    Editor editor = held_patch();
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 1}));
    CHECK(editor.unreachable_pairs().empty());
    const Eigen::Vector3d a = editor.net().rest_positions().col(0), b = editor.net().rest_positions().col(1);
    editor.move_handle(1, a + 0.9 * (b - a));
    REQUIRE(editor.unreachable_pairs().size() == 1);
    CHECK(editor.solve().status == Status::unreachable);
}

TEST_CASE("Pieces that nothing joins have no distance between them") {
    const Net one = samples::patch(4, 4);
    Positions x(3, 32);
    x << one.rest_positions(), one.rest_positions().colwise() + Eigen::Vector3d(10, 0, 0);
    Faces faces = one.faces();
    for (int f = 0; f < one.face_count(); ++f) {
        std::vector<int> moved;
        for (int v : one.faces()[f]) moved.push_back(v + 16);
        faces.add(moved);
    }
    Editor editor{Net(x, faces)};
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 16}));
    editor.move_handle(16, Eigen::Vector3d(1000, 0, 0));
    CHECK(editor.unreachable_pairs().empty());
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("Reset brings net and handles back to rest") {
    Editor editor = held_patch();
    editor.move_handle(71, editor.net().rest_positions().col(71) + k_pull);
    editor.solve();
    editor.reset();
    CHECK(editor.positions() == editor.net().rest_positions());
    CHECK(editor.handle_error() == 0);
    CHECK(editor.solve().iterations == 0);
}

TEST_CASE("A target beyond all numbers ends as an honest status with finite positions") {
    Editor editor = held_patch();
    editor.move_handle(71, Eigen::Vector3d(1e200, 0, 0));
    const Status status = editor.solve().status;
    CHECK((status == Status::non_finite || status == Status::unreachable));
    CHECK(editor.positions().allFinite());
}

TEST_CASE("What is refused is quoted in a line that can be read") {
    Options options;
    const std::string text = "\x01\n\x7f\xff" + std::string(100'000, 'x');
    const auto line_of = [](auto action) {
        try {
            action();
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    for (const std::string& line :
         {line_of([&] { set_option(options, text, "1"); }), line_of([&] { set_option(options, "p_end", text); }),
          line_of([&] { make_method(text); }), line_of([&] { Initialisation{text}; })}) {
        CHECK(line.find("\"????xxx") != line.npos);
        CHECK(line.size() < 500);
    }
}

TEST_CASE("The limit of corners is an angle, and its text a number of degrees, which comes back as it was") {
    Options options;
    CHECK(get_option(options, "shear_limit") == 30);
    for (int hundredths = 0; hundredths <= 6000; ++hundredths) {
        const double degrees = hundredths / 100.0;
        set_option(options, "shear_limit", exact_text(degrees));
        REQUIRE(options.shear_limit == degrees * samples::k_degree);
        REQUIRE(get_option(options, "shear_limit") == degrees);
    }
    options.shear_limit = samples::k_pi / 3;
    check_options(options);
    for (const char* bad : {"-0.1", "60.01"})
        CHECK(code_of([&] { set_option(options, "shear_limit", bad); }) == ErrorCode::bad_option);
}

TEST_CASE("An angle of any digits stays the same by way of its text") {
    std::mt19937 random(1);
    for (int k = 0; k < 10000; ++k) {
        Options options, other;
        set_option(options, "shear_limit", exact_text(60.0 * random() / std::mt19937::max()));
        set_option(other, "shear_limit", exact_text(get_option(options, "shear_limit")));
        REQUIRE(other == options);
    }
}

TEST_CASE("Options are set by name within their range") {
    Options options;
    set_option(options, "p_end", "30");
    set_option(options, "adaptive_p", "off");
    set_option(options, "max_iterations", "7");
    CHECK(options.p_end == 30);
    CHECK_FALSE(options.adaptive_p);
    CHECK(options.max_iterations == 7);
    CHECK(get_option(options, "p_end") == 30);
    for (const char* bad : {"", "1", "-3", "nan", "inf", "30x", "1e9"})
        CHECK(code_of([&] { set_option(options, "p_end", bad); }) == ErrorCode::bad_option);
    CHECK(code_of([&] { set_option(options, "max_iterations", "1.5"); }) == ErrorCode::bad_option);
    CHECK(code_of([&] { set_option(options, "adaptive_p", "maybe"); }) == ErrorCode::bad_option);
    CHECK(options.p_end == 30);

    const Options defaults;
    for (const OptionInfo& info : option_table()) {
        CAPTURE(info.name);
        CHECK(get_option(defaults, info.name) >= info.smallest);
        CHECK(get_option(defaults, info.name) <= info.largest);
    }
}
