#pragma once

#include <span>
#include <string>
#include <vector>

#include "run.h"

namespace chebnet::bench {

/// One edit under all variants of a figure, in their order.
struct Group {
    std::vector<Run> runs;

    bool has(const std::string& variant) const;
    /// The run under the variant of that name. Throws Error if there is none.
    const Run& operator[](const std::string& variant) const;
};

/// A number that speaks for or against a claim. The page knows the same units.
struct Value {
    std::string variant;
    double value;      ///< infinity: never
    const char* unit;  ///< iterations, ms, times, dL, L, degrees, vertices, edges, share, frames; or none
};

/// Whether one edit bears a claim out, and the numbers that say so.
struct Outcome {
    bool holds;
    std::vector<Value> values;
};

/// How one edit is asked whether a claim is so.
struct Check {
    const char* name;
    const char* criterion;
    const char* if_not;  ///< a possible reason, shown if the claim does not hold everywhere; may be empty
    bool about_time;     ///< runs are repeated, and the fastest counts
    Outcome (*ask)(const Group& group);
};
std::span<const Check> check_table();
/// Throws Error bad_option.
const Check& find_check(const std::string& name);

/// Such as "p = 2: 12 iterations, p = 50: never".
std::string to_words(const std::vector<Value>& values, const Group& group);

}  // namespace chebnet::bench
