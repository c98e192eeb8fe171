#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "solve/rest_state.h"

namespace chebnet {

/// How a solve stands.
enum class Status {
    running,    ///< not done yet: the budget ran out first
    converged,  ///< max dL is below the threshold, and the method's energy, if it has one, at its least
    exact,      ///< max dL is below the threshold, but no way was found on to the least of the energy
    stalled,    ///< a minimum or a dead end was reached with max dL above the threshold, or corners sharper than the
                ///< limit
    max_iterations,  ///< the limit of iterations was reached first
    unreachable,  ///< two handles stand farther apart than the net between them is long, or no way was found to where
                  ///< they are; the best shape is held
    non_finite,   ///< a number overflowed; the positions are the last finite ones
};
const char* to_string(Status status);
/// Whether a solve that ended so left every edge with its length.
inline bool keeps_lengths(Status status) { return status == Status::converged || status == Status::exact; }

/// What one iteration did.
struct TraceRow {
    int iteration = 0;         ///< from 1, counted since the solve was started; an initialisation's end at 0
    int stage = 0;             ///< from 1, as MethodInfo::stages names them; 0 in an initialisation
    double p = 0;              ///< exponent of the energy; 0 if it has none
    double energy = 0;         ///< the method's own energy after the iteration; 0 where all edges have their length
    double max_deviation = 0;  ///< max dL after the iteration, over all edges, as of exact handles at their targets
    double gradient_norm = 0;  ///< ‖∇E‖ before the step, in units of 1 / mean length
    double step = 0;           ///< part of the direction accepted by the line search
    int free_vertices = 0;     ///< vertices that could move
    double assembly_ms = 0, factorisation_ms = 0, line_search_ms = 0;
    double total_ms = 0;  ///< time since the solve was started
};
using Trace = std::vector<TraceRow>;

/// The trace as CSV: a header line, then a line for each row.
std::string to_csv(const Trace& trace);

/// What a call of Editor::solve did.
struct SolveReport {
    Status status = Status::running;
    double max_deviation = std::numeric_limits<double>::infinity();  ///< over all edges, at the positions held
    double milliseconds = 0;                                         ///< of this call
    double factorisation_ms = 0;                                     ///< part of it
    int iterations = 0;                                              ///< of this call, by the method
    std::optional<ToRest> to_rest;  ///< where a method that brings nets to rest has come so far
    Trace trace;                    ///< a row for each iteration of this call, by the initialisation and by the method
};

}  // namespace chebnet
