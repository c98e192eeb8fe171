#pragma once

#include <string>

#include "results.h"

namespace chebnet::bench {

/// What is not the same in two runs, one line each: times that differ by more than the noise of their samples, and how
/// solves end. Ends with the mean ratio of all times.
std::string compare(const Results& before, const Results& after);

}  // namespace chebnet::bench
