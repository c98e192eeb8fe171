#include "solve/trace.h"

#include <cstdio>

namespace chebnet {

const char* to_string(Status status) {
    switch (status) {
        case Status::running:
            return "running";
        case Status::converged:
            return "converged";
        case Status::exact:
            return "exact";
        case Status::stalled:
            return "stalled";
        case Status::max_iterations:
            return "max_iterations";
        case Status::unreachable:
            return "unreachable";
        case Status::non_finite:
            return "non_finite";
    }
    return "unknown";
}

std::string to_csv(const Trace& trace) {
    std::string csv =
        "iteration,stage,p,energy,max_deviation,gradient_norm,step,free_vertices,assembly_ms,factorisation_ms,"
        "line_search_ms,total_ms\n";
    for (const TraceRow& row : trace) {
        char line[320];
        std::snprintf(line, sizeof line, "%d,%d,%g,%.17g,%.17g,%.17g,%g,%d,%.4f,%.4f,%.4f,%.4f\n", row.iteration,
                      row.stage, row.p, row.energy, row.max_deviation, row.gradient_norm, row.step, row.free_vertices,
                      row.assembly_ms, row.factorisation_ms, row.line_search_ms, row.total_ms);
        csv += line;
    }
    return csv;
}

}  // namespace chebnet
