#pragma once

#include "plan.h"
#include "results.h"

namespace chebnet::bench {

/// Every method on one edit. They take turns, so that whatever else the machine does hits them alike.
std::vector<EditResult> measure_edit(const Task& task, const Plan& plan);
/// The handles move to their targets in equal steps; here the methods take turns frame by frame.
std::vector<DragResult> measure_drag(const Task& task, const Plan& plan);

/// The solvers on the systems of one net, by Google Benchmark.
std::vector<KernelResult> measure_kernels(const Task& task, const Plan& plan);

/// All sizes of all series, each in a process of its own, which has its own peak of memory. A method that gets too slow
/// leaves out the larger sizes.
void measure_growth(const Plan& plan, Results& results);

/// Whether projecting failed twice, so that projection went on with the costly steps of Gauss and Newton.
bool fell_back(const SolveReport& report);

Machine this_machine();

}  // namespace chebnet::bench
