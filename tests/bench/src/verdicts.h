#pragma once

#include <string>
#include <vector>

#include "checks.h"
#include "figures.h"

namespace chebnet::bench {

/// A figure that has been run: a group for each edit.
struct Result {
    const Figure* figure;
    std::vector<Group> groups;
};

/// A claim, and what the edits say to it.
struct Verdict {
    const Claim* claim;
    const Check* check;
    std::vector<Outcome> outcomes;  ///< one for each edit

    int held() const;
    /// holds: true of all edits; does not hold: of none; differs: of some.
    const char* word() const;
};
std::vector<Verdict> judge(const Result& result);

/// What the page shows beside the claims (web/src/experiments/verdicts.json): of each figure and claim the verdict and
/// the numbers of the first edit.
std::string verdicts_json(const std::vector<Result>& results);
/// One table of all claims, in Markdown.
std::string verdicts_table(const std::vector<Result>& results);

}  // namespace chebnet::bench
