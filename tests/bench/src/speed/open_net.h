#pragma once

#include <string>

#include "net/net.h"

namespace chebnet::bench {

/// `net`: a recipe or an OBJ file. Throws Error.
Net open_net(const std::string& net);

}  // namespace chebnet::bench
