#pragma once

#include <string>
#include <vector>

#include "run.h"

namespace chebnet::bench {

/// One edit under all variants of an experiment.
struct Group {
    std::vector<Run> runs;

    /// The run under a variant of that label, which must exist.
    const Run& operator[](const std::string& variant) const;
    bool any_converged() const;
    bool any_moved() const;  ///< false: the edit leaves the net as it is
};

/// Whether one edit bears a claim out, and the numbers that say so.
struct Outcome {
    bool holds;
    std::string numbers;
};

/// What the paper says, and how one edit is asked whether it is so.
struct Claim {
    std::string text;
    std::string criterion;
    std::string if_not;  ///< a possible reason, shown if the claim does not hold everywhere
    Outcome (*check)(const Group& group);
};

/// One kind of plot: a curve for each run, or, if `is_trend`, a point for each run joined over the variants.
struct View {
    const char* x_label;
    const char* y_label;
    bool log_x, log_y;
    double (*x)(const Run& run, const Sample& sample);
    double (*y)(const Run& run, const Sample& sample);
    bool is_trend = false;
};

/// One figure of the paper, on nets of our own. Everything that is run is a case under a variant.
struct Experiment {
    std::string name;
    int figure;
    std::string title;
    std::vector<Claim> claims;
    std::vector<EditCase> cases;
    std::vector<Variant> variants;  ///< times and shapes are compared with the first
    std::vector<View> views;
    int repeats = 1;             ///< of each run, where a claim is about time
    bool needs_solution = true;  ///< an edit that no variant solves says nothing and is left out
    bool needs_recipes = false;  ///< cannot be run on files
};

const std::vector<Experiment>& experiments();

}  // namespace chebnet::bench
