#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <utility>

#include "kernels.h"
#include "measure.h"
#include "open_net.h"

namespace chebnet::bench {
namespace {

/// Keeps the mean of each repetition instead of printing it.
class Collector : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration)
                samples[run.run_name.function_name].push_back(run.GetAdjustedRealTime());
    }

    std::map<std::string, std::vector<double>> samples;  // ms, by the name of the benchmark
};

std::string name_of(const Kernel& kernel) { return kernel.system + '/' + kernel.solver; }

void initialize_once() {
    // The repetitions of all solvers in one shuffled row: noise hits them alike.
    static const bool done = [] {
        std::string program = "speed", interleaving = "--benchmark_enable_random_interleaving=true";
        char* arguments[] = {program.data(), interleaving.data(), nullptr};
        int count = 2;
        benchmark::Initialize(&count, arguments);
        return true;
    }();
    (void)done;
}

}  // namespace

std::vector<KernelResult> measure_kernels(const Task& task, const Plan& plan) {
    initialize_once();
    const std::vector<Kernel> kernels = make_kernels(open_net(task.net), handle_vertices(task));
    for (const Kernel& kernel : kernels)
        benchmark::RegisterBenchmark(name_of(kernel).c_str(),
                                     [&kernel](benchmark::State& state) {
                                         for ([[maybe_unused]] auto _ : state) kernel.factorize();
                                     })
            ->Unit(benchmark::kMillisecond)
            ->Repetitions(plan.repeats)
            ->MinTime(0.1);
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::ClearRegisteredBenchmarks();
    std::vector<KernelResult> results;
    for (const Kernel& kernel : kernels)
        results.push_back({task.edit, kernel.system, kernel.solver, kernel.rows, kernel.residual,
                           std::move(collector.samples[name_of(kernel)])});
    return results;
}

}  // namespace chebnet::bench
