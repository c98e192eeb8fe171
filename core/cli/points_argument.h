#pragma once

#include <string>

#include "net/net.h"

namespace chebnet {

/// "x,y,z x,y,z ...". Throws Error bad_option naming the option.
Positions points_in(const std::string& text, const std::string& option);

}  // namespace chebnet
