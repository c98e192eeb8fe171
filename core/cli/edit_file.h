#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "edit/editor.h"

namespace chebnet {

/// Reads an edit, `{"handles": [{"vertex": i from 0, "target": [x, y, z]}, …]}`, for a net of `vertex_count` vertices.
/// A handle with a "weight" is soft; one with "slides", an axis or two such as "xy", slides along them. Other keys are
/// passed over, those of handles with a remark on standard error: they may be misspelt. Throws Error file_access,
/// too_large, bad_syntax, index_out_of_range, repeated_vertex; each message names the file and the handle, from 0.
std::vector<Handle> read_edit(const std::string& path, int vertex_count);
/// The same of the text of such a file, which messages call `name`.
std::vector<Handle> parse_edit(std::string_view text, const std::string& name, int vertex_count, std::ostream& remarks);

}  // namespace chebnet
