#pragma once

#include <string>
#include <vector>

#include "verdicts.h"

namespace chebnet::bench {

/// Writes figures.html into a folder: each figure's claims with verdicts, numbers, nets and plots; beside it the
/// pictures NAME.VARIANT.EDIT.png, the plots NAME.svg and the traces NAME.csv. Throws Error file_access.
void write_page(const std::vector<Result>& results, double seconds, const std::string& folder);
/// The plots, pictures and traces of one figure.
void write_files(const Result& result, const std::string& folder);

}  // namespace chebnet::bench
