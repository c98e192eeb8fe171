#include "io/ply.h"

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace chebnet;
    for (const PlyEncoding encoding : {PlyEncoding::binary, PlyEncoding::text})
        fuzz::fuzz_reader(fuzz::as_text(data, size), read_ply,
                          [&](const Mesh& mesh) { return write_ply(mesh.positions, mesh.faces, encoding); });
    return 0;
}
