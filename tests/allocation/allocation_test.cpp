/// The frame loop of a drag allocates nothing, or by `equilibrium` hardly anything. A program of its own, because it
/// counts every allocation there is by standing in for the C library's malloc, which sanitizers do too.

#include <dlfcn.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <span>

#include "net/measures.h"
#include "shapes/shapes.h"
#include "solve/method.h"

namespace {

std::atomic<long> g_allocations = 0;

template <typename Function>
Function next_in_line(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" void* malloc(std::size_t size) {
    static const auto real = next_in_line<void* (*)(std::size_t)>("malloc");
    ++g_allocations;
    return real(size);
}

extern "C" void* realloc(void* block, std::size_t size) {
    static const auto real = next_in_line<void* (*)(void*, std::size_t)>("realloc");
    ++g_allocations;
    return real(block, size);
}

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
    static const auto real = next_in_line<void* (*)(std::size_t, std::size_t)>("aligned_alloc");
    ++g_allocations;
    return real(alignment, size);
}

using namespace chebnet;

namespace {

struct Frames {
    long allocations = 0;
    int iterations = 0, stages_seen = 0;
    bool converged = true;
};

/// Drags the last of a shape's handles round a circle of so many frames, which ends where it began, or along as many of
/// them as are to be `made`; a pull stays where it is.
Frames drag(Method& method, const Problem& problem, const Shape& shape, Positions& positions, int count, int made) {
    Frames frames;
    const int dragged = shape.suggested_handles.back();
    const Eigen::Vector3d rest = shape.net.rest_positions().col(dragged);
    const double radius = 3 * shape.net.mean_length();
    const long before = g_allocations;
    for (int frame = 1; frame <= made; ++frame) {
        const double angle = 6.283185307179586 * frame / count;
        positions.col(dragged) = rest + radius * Eigen::Vector3d(std::cos(angle) - 1, std::sin(angle), 0);
        Status status = method.start(problem, positions, Options{});
        for (int k = 0; k < 200 && status == Status::running; ++k) {
            TraceRow row;
            status = method.iterate(positions, row);
            ++frames.iterations;
            frames.stages_seen |= 1 << row.stage;
        }
        frames.converged = frames.converged && status == Status::converged;
    }
    frames.allocations = g_allocations - before;
    return frames;
}

int failures = 0;
void check(bool holds, const std::string& what) {
    std::cout << (holds ? "ok    " : "FAILED  ") << what << "\n";
    failures += holds ? 0 : 1;
}

}  // namespace

int main() {
    const Shape shape = make_shape("elephant:vertices=2000");
    const Topology topology(shape.net);
    const std::unique_ptr<Method> method = make_method("projection");
    Problem problem{shape.net, topology, shape.suggested_handles};
    method->prepare(problem);
    Positions positions = shape.net.rest_positions();

    const Frames first = drag(*method, problem, shape, positions, 20, 20);
    check(first.allocations > 0, "the count sees that the first drag makes room for itself");
    const Frames again = drag(*method, problem, shape, positions, 40, 40);
    check(again.converged, "every frame of the second drag converges");
    check(again.stages_seen == 0b1110, "it goes through stages 1, 2 and 3");
    check(again.allocations == 0, "its " + std::to_string(again.iterations) + " iterations allocate nothing (counted " +
                                      std::to_string(again.allocations) + ")");

    // Pulled to where the drag cannot let it stay, the pull gives way in each frame.
    const int held = shape.net.vertex_count() / 2;
    const Pull pull{held, positions.col(held) + 5 * shape.net.mean_length() * Eigen::Vector3d::UnitX(), 1};
    problem.pulls = {&pull, 1};
    drag(*method, problem, shape, positions, 20, 20);
    const Frames soft = drag(*method, problem, shape, positions, 40, 40);
    check(soft.converged, "every frame of a drag against a pull converges");
    check(soft.allocations == 0, "its " + std::to_string(soft.iterations) + " iterations allocate nothing (counted " +
                                     std::to_string(soft.allocations) + ")");

    // Vectors of its inner iterations; no more for a larger net. Back home it reckons its energy anew.
    const std::unique_ptr<Method> equilibrium = make_method("equilibrium");
    problem.pulls = {};
    equilibrium->prepare(problem);
    positions = shape.net.rest_positions();
    drag(*equilibrium, problem, shape, positions, 40, 39);
    const Frames at_rest = drag(*equilibrium, problem, shape, positions, 40, 39);
    check(at_rest.converged, "every frame of a drag by equilibrium comes to rest");
    check(at_rest.allocations <= 5 * at_rest.iterations, "its " + std::to_string(at_rest.iterations) +
                                                             " iterations allocate five times each at most (counted " +
                                                             std::to_string(at_rest.allocations) + ")");
    return failures == 0 ? 0 : 1;
}
