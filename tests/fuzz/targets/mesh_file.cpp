#include "io/mesh_file.h"

#include <array>

#include "reader.h"

/// Which reader a file gets is found out from its bytes and its name; the first byte of the input chooses the ending.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace chebnet;
    constexpr std::array endings{"", ".obj", ".ply", ".off", ".stl", ".3dm", ".OBJ"};
    if (size == 0) return 0;
    const std::string ending = endings[data[0] % endings.size()];
    fuzz::fuzz_reader(
        fuzz::as_text(data + 1, size - 1),
        [&](std::string_view bytes, const std::string& name) {
            try {
                return read_mesh(bytes, name + ending);
            } catch (const Error& error) {
                // The name of the file stands in front without what has been appended to it.
                const std::string what = error.what();
                throw Error(error.code(), name + what.substr(std::min(what.size(), name.size() + ending.size())));
            }
        },
        [&](const Mesh& mesh) {
            const FormatInfo& ply = find_format("ply");
            return (ending == ".ply" ? ply.write_text : ply.write)(mesh.positions, mesh.faces);
        });
    return 0;
}
