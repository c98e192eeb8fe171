#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace chebnet::bench {

// What was measured on one target. The names of the fields are those of the JSON file, which speed_in_node.mjs writes
// for WebAssembly. `ms` holds every sample.

struct Machine {
    std::string cpu, compiler;
    std::string blas;  ///< the library behind CHOLMOD; empty without CHOLMOD
};

struct KernelResult {
    std::string edit, system, solver;  ///< see Kernel; the edit's handles are held
    int rows;
    double residual;
    std::vector<double> ms;
};

/// A cold solve: handles jump, everything is prepared anew.
struct EditResult {
    std::string edit, method;
    int vertices;
    std::string status;
    int iterations;
    double max_dL, bend, smallest_angle;  ///< angle in degrees
    bool fell_back;                       ///< see fell_back()
    std::vector<double> ms;
};

struct DragResult {
    std::string edit, method;
    int vertices;
    int unsolved_frames, fallback_frames;
    double max_dL;           ///< of the worst frame
    double bend;             ///< at the end
    std::vector<double> ms;  ///< of the frames, in their order
};

struct GrowthResult {
    std::string edit, series, method;
    int vertices;
    std::string status;
    int iterations;
    bool fell_back;
    double peak_mb;
    std::vector<double> ms;
};

/// A size that would have taken too long.
struct GrowthStop {
    std::string edit, series, method;
    double predicted_seconds;
};

struct Results {
    std::string target;  ///< "native" or "wasm"
    Machine machine;
    std::vector<std::string> methods;
    std::vector<GrowthResult> growth;
    std::vector<GrowthStop> stops;
    std::vector<KernelResult> kernels;
    std::vector<EditResult> edits;
    std::vector<DragResult> drags;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Machine, cpu, compiler, blas)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(KernelResult, edit, system, solver, rows, residual, ms)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditResult, edit, method, vertices, status, iterations, max_dL, bend, smallest_angle,
                                   fell_back, ms)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DragResult, edit, method, vertices, unsolved_frames, fallback_frames, max_dL, bend,
                                   ms)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GrowthResult, edit, series, method, vertices, status, iterations, fell_back, peak_mb,
                                   ms)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GrowthStop, edit, series, method, predicted_seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Results, target, machine, methods, growth, stops, kernels, edits, drags)

}  // namespace chebnet::bench
