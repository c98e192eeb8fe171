#pragma once

#include <string>
#include <vector>

#include "experiments.h"

namespace chebnet::bench {

/// An experiment that has been run: a group for each case.
struct Result {
    const Experiment* experiment;
    std::vector<Group> groups;
};

/// Writes NAME.csv (traces), NAME.json (results) and NAME.svg into a folder. Throws Error.
void write_files(const Result& result, const std::string& folder);
/// Writes results.md, which sets each claim beside what was measured. Throws Error.
void write_page(const std::vector<Result>& results, double seconds, const std::string& folder);

}  // namespace chebnet::bench
