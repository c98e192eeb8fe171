#pragma once

#include <memory>
#include <string>
#include <vector>

#include "figures.h"
#include "solve/trace.h"

namespace chebnet::bench {

/// The state after one iteration, or, in a drag, after one frame: then `iteration` is the frame and `total_ms` its
/// time.
struct Sample {
    TraceRow row;
    double longer_share = 0;  ///< edges longer than their rest length, as part of all; NaN in an initialisation
};

/// The net where a stage of the workflow ends and the next begins.
struct Snapshot {
    int stage;  ///< that has ended
    Positions positions;
};

/// A net made over a surface, with edges as long as those of the net that was edited.
struct NewNet {
    Net net;
    double milliseconds;
};

/// What became of an edit under a variant.
struct Run {
    std::string edit;
    const Variant* variant = nullptr;
    std::shared_ptr<const Edit> problem;
    Status status = Status::running;  ///< of a drag: `converged` if every frame is
    int iterations = 0;               ///< of all frames, by the method
    double milliseconds = 0;          ///< likewise, with the initialisation's
    double max_deviation = 0;         ///< of a drag: the worst frame's
    double bend = 0;                  ///< RMS change of second differences, in units of L; a measure of noise
    double smallest_angle = 0;        ///< radians
    double handle_error = 0;
    std::vector<Sample> samples;
    std::vector<Snapshot> snapshots;
    Positions positions;                    ///< at the end
    std::shared_ptr<const NewNet> new_net;  ///< of a variant that remeshes; null if there is no such net

    bool converged() const { return status == Status::converged; }
    int vertices() const { return problem->net.vertex_count(); }
};

/// Solves, `repeats` times; the fastest run counts. Throws Error.
Run run(const NamedEdit& edit, const Variant& variant, int repeats);

/// Of vertices, RMS, in mean edge lengths. Both runs are of one net.
double distance(const Run& a, const Run& b);
/// Of the vertices and middles of edges of a net, from the surface that a run has led to, in the mean edge lengths of
/// the run's net.
double mean_distance(const Net& net, const Positions& positions, const Run& surface);
int singular_vertices(const Net& net);
/// Edges of which no end has moved since a stage ended.
int edges_at_rest_since(const Run& run, const Snapshot& snapshot);

}  // namespace chebnet::bench
