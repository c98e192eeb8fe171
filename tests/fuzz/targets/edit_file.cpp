#include "edit_file.h"

#include <algorithm>
#include <sstream>

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace chebnet;
    using fuzz::require;
    constexpr int vertex_count = 25;
    std::vector<Handle> handles;
    try {
        std::ostringstream remarks;
        handles = parse_edit(fuzz::as_text(data, size), "some file", vertex_count, remarks);
    } catch (const Error& error) {
        fuzz::require_readable(error);
        require(std::string_view(error.what()).starts_with("some file: "), "a message does not name the file");
        return 0;
    }
    std::vector<bool> is_held(vertex_count, false);
    for (const Handle& handle : handles) {
        require(handle.vertex >= 0 && handle.vertex < vertex_count && !is_held[handle.vertex], "a bad vertex");
        is_held[handle.vertex] = true;
        require(handle.target.allFinite() && handle.weight > 0, "a target or a weight that no editor takes");
        require(handle.slides >= k_no_axes && handle.slides < k_all_axes, "axes that no editor takes");
    }
    return 0;
}
