// Prints every shape and what every method makes of it, to the last bit: a line for each frame of a drag, with how it
// ended, and the hashes of the positions and of what the trace says of the iterations, times apart. Two builds of the
// same sources print the same; tests/same_bits compares them.

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

#include "edit/editor.h"
#include "shapes/shapes.h"

namespace chebnet {
namespace {

constexpr int k_vertices = 200;        // small enough for sanitizers, large enough for the factorisation's supernodes
constexpr int k_more_vertices = 2000;  // of a shape alone: enough that it is relaxed twice
constexpr int k_iterations = 100;      // of one frame: gradient descent would take thousands
constexpr int k_frames = 2;            // the second starts from the first
constexpr double k_pull = 0.1;         // of the way to the middle of the anchors, with each frame

/// FNV-1a, 64 bits.
class Hash {
public:
    template <class T>
    void add(const T& value) {
        for (const std::byte byte : std::as_bytes(std::span(&value, 1)))
            m_value = (m_value ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
    }
    std::uint64_t value() const { return m_value; }

private:
    std::uint64_t m_value = 0xcbf29ce484222325;
};

std::uint64_t hash(const Positions& positions) {
    Hash hash;
    for (const double coordinate : positions.reshaped()) hash.add(coordinate);
    return hash.value();
}

std::uint64_t hash(const Trace& trace) {
    Hash hash;
    for (const TraceRow& row : trace) {
        for (const int number : {row.iteration, row.stage, row.free_vertices}) hash.add(number);
        for (const double number : {row.p, row.energy, row.max_deviation, row.gradient_norm, row.step})
            hash.add(number);
    }
    return hash.value();
}

std::vector<Handle> handles_at_rest(const Shape& shape) {
    std::vector<Handle> handles;
    for (const int vertex : shape.suggested_handles)
        handles.push_back({vertex, shape.net.rest_positions().col(vertex)});
    return handles;
}

/// The way of the last handle to the middle of the others.
Eigen::Vector3d inward(const std::vector<Handle>& handles) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i + 1 < handles.size(); ++i) middle += handles[i].target;
    return middle / static_cast<double>(handles.size() - 1) - handles.back().target;
}

void drag(const std::string& recipe, const Shape& shape, const char* method) {
    const std::vector<Handle> handles = handles_at_rest(shape);
    Editor editor(shape.net);
    editor.set_method(method);
    editor.set_handles(handles);
    for (int frame = 1; frame <= k_frames; ++frame) {
        editor.move_handle(handles.back().vertex, handles.back().target + frame * k_pull * inward(handles));
        const SolveReport report = editor.solve({.iterations = k_iterations});
        std::printf("%s %s frame %d: %s, %d iterations, positions %016" PRIx64 ", trace %016" PRIx64 "\n",
                    recipe.c_str(), method, frame, to_string(report.status), report.iterations,
                    hash(editor.positions()), hash(report.trace));
    }
}

void print_shape(const std::string& recipe) {
    const Shape shape = make_shape(recipe);
    std::printf("%s: positions %016" PRIx64 ", handles", recipe.c_str(), hash(shape.net.rest_positions()));
    for (const int vertex : shape.suggested_handles) std::printf(" %d", vertex);
    std::printf("\n");
}

}  // namespace
}  // namespace chebnet

int main() {
    using namespace chebnet;
    for (const ShapeInfo& info : shape_table()) {
        const std::string recipe = std::string(info.name) + ":vertices=" + std::to_string(k_vertices);
        const Shape shape = make_shape(recipe);
        for (const MethodInfo& method : method_table()) drag(recipe, shape, method.name);
        print_shape(std::string(info.name) + ":vertices=" + std::to_string(k_more_vertices));
    }
    for (const char* name : {"elephant", "jack"})
        print_shape(std::string(name) + ":smooth=1,vertices=" + std::to_string(k_more_vertices));
}
