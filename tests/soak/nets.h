#pragma once

#include <functional>
#include <random>
#include <span>
#include <string>

#include "net/net.h"

namespace chebnet::soak {

using Random = std::mt19937_64;

/// A kind of net to be edited at random: shapes of the gallery, odd topology, odd geometry.
struct NetKind {
    std::string name;
    std::function<Net(Random&)> make;  ///< of a random size up to about `largest` vertices
};

/// `largest`: about how many vertices a net may have, at least 100.
std::vector<NetKind> net_kinds(int largest);

}  // namespace chebnet::soak
