#include "io/obj.h"

#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace chebnet;
    fuzz::fuzz_reader(fuzz::as_text(data, size), read_obj,
                      [](const Mesh& mesh) { return write_obj(mesh.positions, mesh.faces); });
    return 0;
}
