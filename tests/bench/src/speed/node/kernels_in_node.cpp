// The factorisations in WebAssembly, for Node: see speed_in_node.mjs, which starts this program.
//   without arguments           prints the compiler
//   NET REPEATS VERTEX...       prints a line of JSON for each kernel; NET is a recipe or an OBJ file

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "base/stopwatch.h"
#include "kernels.h"
#include "open_net.h"

namespace {

using namespace chebnet;
using namespace chebnet::bench;

constexpr double k_sample_ms = 100;  // at least: so many runs make one sample

/// Mean of some runs.
double sample(const Kernel& kernel) {
    int runs = 0;
    const Stopwatch watch;
    do {
        kernel.factorize();
        ++runs;
    } while (watch.milliseconds() < k_sample_ms);
    return watch.milliseconds() / runs;
}

void measure(const Net& net, int repeats, const std::vector<int>& handle_vertices) {
    const std::vector<Kernel> kernels = make_kernels(net, handle_vertices);
    std::vector<std::vector<double>> samples(kernels.size());
    for (int repeat = 0; repeat < repeats; ++repeat)
        for (std::size_t i = 0; i < kernels.size(); ++i) samples[i].push_back(sample(kernels[i]));
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        std::printf(R"({"system": "%s", "solver": "%s", "rows": %d, "residual": %g, "ms": [)",
                    kernels[i].system.c_str(), kernels[i].solver.c_str(), kernels[i].rows, kernels[i].residual);
        for (int k = 0; k < repeats; ++k) std::printf("%s%.6g", k == 0 ? "" : ", ", samples[i][k]);
        std::printf("]}\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::printf("Emscripten %d.%d.%d\n", __EMSCRIPTEN_major__, __EMSCRIPTEN_minor__, __EMSCRIPTEN_tiny__);
        return 0;
    }
    try {
        std::vector<int> handle_vertices;
        for (int i = 3; i < argc; ++i) handle_vertices.push_back(std::atoi(argv[i]));
        measure(open_net(argv[1]), std::atoi(argv[2]), handle_vertices);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "speed: %s\n", error.what());
        return 2;
    }
}
