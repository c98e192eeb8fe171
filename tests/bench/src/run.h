#pragma once

#include <string>
#include <utility>
#include <vector>

#include "edit_case.h"
#include "solve/trace.h"

namespace chebnet::bench {

/// How a frame of a drag begins.
enum class FrameStart { last_frame, rest };

/// One way to solve an edit.
struct Variant {
    std::string label;
    std::string method = "li2022";
    std::string initialisation = "naive";
    std::vector<std::pair<std::string, std::string>> options = {};
    Change change = {};
    int frames = 0;  ///< 0: handles jump to their targets; else they are dragged there in so many frames
    FrameStart frame_start = FrameStart::last_frame;
};

/// The state after one iteration, or, in a drag, after one frame: then `iteration` is the frame and `total_ms` its
/// time.
struct Sample {
    TraceRow row;
    double longer_share;  ///< edges longer than their rest length, as part of all
};

/// What became of an edit under a variant.
struct Run {
    std::string edit, variant;
    int vertices = 0, handles = 0;
    Status status = Status::running;  ///< of a drag: `converged` if every frame is
    int iterations = 0;               ///< of all frames
    double milliseconds = 0;          ///< likewise
    double max_deviation = 0;         ///< of a drag: the worst frame's
    double bend = 0, handle_error = 0;
    std::vector<Sample> samples;

    bool converged() const { return status == Status::converged; }
};

/// Solves, `repeats` times; the fastest run counts. Throws Error.
Run run(const EditCase& edit, const Variant& variant, int repeats);

}  // namespace chebnet::bench
