#include "open_net.h"

#include <utility>

#include "io/file.h"
#include "io/obj.h"
#include "shapes/shapes.h"

namespace chebnet::bench {

Net open_net(const std::string& net) {
    if (!net.ends_with(".obj")) return make_shape(net).net;
    Mesh mesh = read_obj(read_file(net), net);
    return Net(std::move(mesh.positions), std::move(mesh.faces));
}

}  // namespace chebnet::bench
