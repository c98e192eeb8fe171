#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>

#include "net/measures.h"
#include "sample_nets.h"
#include "solve/method.h"

using namespace chebnet;

namespace {

/// A patch with a diagonal in each quad.
Net triangle_mesh() {
    const Net quads = samples::patch(6, 5);
    Faces faces;
    for (int f = 0; f < quads.face_count(); ++f) {
        const std::span<const int> q = quads.faces()[f];
        faces.add({q[0], q[1], q[2]});
        faces.add({q[0], q[2], q[3]});
    }
    return Net(quads.rest_positions(), faces);
}

/// Rows of hexagons, as bricks.
Net hexagon_mesh() {
    const int columns = 9, rows = 4;
    Positions x(3, columns * rows);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) x.col(j * columns + i) << i, j + 0.3 * (i % 2), 0.1 * j * j;
    Faces faces;
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = j % 2; i + 2 < columns; i += 2) {
            const int a = j * columns + i, b = a + columns;
            faces.add({a, a + 1, a + 2, b + 2, b + 1, b});
        }
    return Net(x, faces);
}

struct SampleNet {
    std::string name;
    Net net;
    std::vector<int> handles;  // the last one is pulled
};

std::vector<SampleNet> sample_nets() {
    return {{"patch", samples::patch(8, 7), {0, 7, 48, 55}},
            {"cube", samples::cube(), {0, 7}},
            {"mixed", samples::mixed_mesh(), {0, 4}},
            {"triangles", triangle_mesh(), {0, 24, 29}},
            {"hexagons", hexagon_mesh(), {0, 8, 35}}};
}

Editor pulled(const SampleNet& sample, const std::string& method, double amount) {
    Editor editor(sample.net);
    std::vector<Handle> handles;
    for (int v : sample.handles) handles.push_back({v, sample.net.rest_positions().col(v)});
    const Eigen::Vector3d inward = handles.front().target - handles.back().target;
    handles.back().target += amount * (0.2 * inward + Eigen::Vector3d(0.1, 0.2, 0.3));
    editor.set_handles(handles);
    editor.set_method(method);
    return editor;
}

void check_row(const TraceRow& row, int iteration, int free_vertices) {
    CHECK(row.iteration == iteration);
    CHECK(row.stage >= 1);
    CHECK(row.stage <= 3);
    CHECK(row.energy >= 0);
    CHECK(std::isfinite(row.energy));
    CHECK(std::isfinite(row.max_deviation));
    CHECK(row.gradient_norm >= 0);
    CHECK(std::isfinite(row.gradient_norm));
    CHECK(row.step >= 0);
    CHECK(row.free_vertices <= free_vertices);
    CHECK(row.free_vertices > 0);
    CHECK(row.total_ms >= row.assembly_ms + row.factorisation_ms + row.line_search_ms);
}

}  // namespace

TEST_CASE("The table names each method once, with a sentence and where it comes from") {
    std::set<std::string> names;
    for (const MethodInfo& method : method_table()) {
        CAPTURE(method.name);
        CHECK(names.insert(method.name).second);
        const std::string sentence = method.sentence, citation = method.citation;
        CHECK(sentence.back() == '.');
        CHECK(sentence.size() < 110);
        CHECK(citation.find(": ") != std::string::npos);
        CHECK(std::isdigit(static_cast<unsigned char>(citation.back())));
        CHECK(method.make() != nullptr);
    }
    CHECK(names.count(std::string(k_default_method)) == 1);
}

TEST_CASE("Every method on every kind of net: finite, handles exact, an honest status") {
    const double amount = GENERATE(0.3, 1.0);
    for (const MethodInfo& method : method_table())
        for (const SampleNet& sample : sample_nets()) {
            INFO(method.name << " on " << sample.name);
            Editor editor = pulled(sample, method.name, amount);
            REQUIRE(editor.unreachable_pairs().empty());
            const SolveReport report = editor.solve();
            CHECK(editor.positions().allFinite());
            CHECK(editor.handle_error() == 0);
            CHECK(report.max_deviation == max_deviation(editor.net(), editor.positions()));
            CHECK((report.status != Status::converged || report.max_deviation < editor.options().threshold));
            // The others are done as soon as lengths are.
            const bool rests = method.name == std::string("equilibrium");
            CHECK((report.status == Status::converged || rests || report.max_deviation >= editor.options().threshold));
            CHECK((report.status == Status::converged || report.status == Status::stalled ||
                   report.status == Status::max_iterations));
            CHECK((report.status == Status::max_iterations) ==
                  (report.iterations == editor.options().max_iterations && report.status != Status::converged));
            for (int k = 0; k < report.iterations; ++k)
                check_row(report.trace[k], k + 1, sample.net.vertex_count() - static_cast<int>(sample.handles.size()));
        }
}

TEST_CASE("Methods for lengths keep each edge's own, whatever the faces") {
    for (const char* method : {"li2022", "composite_majorization", "projected_newton", "dp4", "dp8", "lbfgs"})
        for (const SampleNet& sample : sample_nets()) {
            if (sample.name == "triangles") continue;  // as good as rigid: a pull has no solution
            INFO(method << " on " << sample.name);
            Editor editor = pulled(sample, method, 0.5);
            editor.set_option("gradient_tolerance", "0");
            editor.set_option("energy_tolerance", "0");
            editor.set_option("max_iterations", "2000");
            CHECK(editor.solve().status == Status::converged);
            CHECK((edge_ratios(editor.net(), editor.positions()).array() - 1).abs().maxCoeff() < 1.1e-3);
        }
}

TEST_CASE("Out of reach every method stretches the net evenly and says so") {
    for (const MethodInfo& method : method_table()) {
        INFO(method.name);
        Editor editor(samples::patch(8, 7));
        std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 7, 48, 55});
        handles.back().target += Eigen::Vector3d(30, 0, 0);
        editor.set_handles(handles);
        editor.set_method(method.name);
        CHECK(editor.solve().status == Status::unreachable);
        CHECK(editor.positions().allFinite());
        CHECK(editor.handle_error() == 0);
        CHECK(editor.positions().cwiseAbs().maxCoeff() < 60);
    }
}

TEST_CASE("Every method survives targets beyond all numbers, collapsed edges, and nets that are all handles") {
    for (const MethodInfo& method : method_table()) {
        INFO(method.name);
        Editor far(samples::patch(4, 4));
        far.set_method(method.name);
        far.set_handles(samples::handles_at_rest(far.net(), {0, 15}));
        far.move_handle(15, Eigen::Vector3d(1e200, 0, 0));
        const Status status = far.solve().status;
        CHECK((status == Status::non_finite || status == Status::unreachable));
        CHECK(far.positions().allFinite());

        Editor jump(samples::patch(8, 8));
        jump.set_method(method.name);
        std::vector<Handle> handles = samples::handles_at_rest(jump.net(), {0, 27});
        handles[1].target = jump.net().rest_positions().col(28);
        jump.set_handles(handles);
        jump.solve();
        CHECK(jump.positions().allFinite());

        Editor all(samples::cube());
        all.set_method(method.name);
        all.set_handles(samples::handles_at_rest(all.net(), {0, 1, 2, 3, 4, 5, 6, 7}));
        CHECK(all.solve().status == Status::converged);
        all.move_handle(0, Eigen::Vector3d(-0.3, 0, 0));
        CHECK(all.solve().status == Status::unreachable);
    }
}

TEST_CASE("A method repeats bit for bit, in one go or in slices") {
    for (const MethodInfo& method : method_table()) {
        INFO(method.name);
        Editor whole = pulled(sample_nets()[0], method.name, 1), sliced = pulled(sample_nets()[0], method.name, 1);
        const int iterations = whole.solve().iterations;
        int count = 0;
        for (SolveReport slice; slice.status == Status::running; count += slice.iterations) slice = sliced.solve({3});
        CHECK(count == iterations);
        CHECK(whole.positions() == sliced.positions());
    }
}

TEST_CASE("D_p is not taken for done by slopes that are small for its exponent") {
    for (const char* method : {"dp4", "dp8"}) {
        INFO(method);
        Editor editor = pulled(sample_nets()[0], method, 1);
        const SolveReport report = editor.solve();
        CHECK(report.status == Status::converged);
        CHECK(report.max_deviation < editor.options().threshold);
        // Relative to what is near the threshold it ends by its slope all the same.
        Editor rough = pulled(sample_nets()[0], method, 1);
        rough.set_option("gradient_tolerance", "1e6");
        CHECK(rough.solve().status == Status::stalled);
    }
}

TEST_CASE("D_p ends with an exponent of its own") {
    for (const auto& [method, p] : {std::pair{"dp4", 4.0}, {"dp8", 8.0}}) {
        Editor editor = pulled(sample_nets()[0], method, 1);
        editor.set_option("gradient_tolerance", "0");
        editor.set_option("energy_tolerance", "0");
        const SolveReport report = editor.solve();
        CHECK(report.status == Status::converged);
        CHECK(report.trace.front().p == editor.options().p_start);
        CHECK(report.trace.back().p == p);
        CHECK(editor.options().p_end == Options{}.p_end);
    }
}

TEST_CASE("The direct energy of eq. 2 is an option of the paper's method") {
    Editor editor = pulled(sample_nets()[0], "li2022", 1);
    editor.set_option("direct_energy", "on");
    editor.set_option("max_iterations", "1");
    const TraceRow row = editor.solve().trace.back();
    double sum = 0;
    for (double r : edge_ratios(editor.net(), editor.positions())) sum += std::pow(deviation(r), row.p);
    CHECK(row.energy == Approx(sum));
}
