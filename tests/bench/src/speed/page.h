#pragma once

#include <string>
#include <vector>

#include "results.h"

namespace chebnet::bench {

/// The measurements of each target as a page of tables, in Markdown.
std::string speed_page(const std::vector<Results>& targets);

}  // namespace chebnet::bench
