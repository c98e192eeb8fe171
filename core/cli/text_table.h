#pragma once

#include <string>
#include <vector>

namespace chebnet {

/// Lines of text in aligned columns, each line indented by two spaces and ended by a newline. All columns but the last
/// are ASCII.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

/// A number in short form: 4000, 1e-06, 0.25.
std::string to_text(double value);

}  // namespace chebnet
