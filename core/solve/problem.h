#pragma once

#include <memory>
#include <span>

#include "net/net.h"
#include "net/topology.h"
#include "solve/pull.h"
#include "solve/slide.h"

namespace chebnet {

class Guide;

/// What a method is to solve: positions in which every edge has its length, fixed vertices stay where they are, and
/// pulls draw as far as the edges let them. Keeps references.
struct Problem {
    const Net& net;
    const Topology& topology;
    std::span<const int> fixed;           ///< distinct: exact handles, and what lies outside the region that may move
    std::span<const Pull> pulls = {};     ///< of free vertices, distinct: soft handles, and the region's border
    bool reachable = true;                ///< false: no such positions exist, as far as the handles' distances tell
    const Positions* last_net = nullptr;  ///< the last positions in which every edge had its length; null: not known
    std::shared_ptr<const Guide> guide = nullptr;  ///< a surface for Options::guide_mode; null: none
    double unit = 1;                               ///< of the net, in that of the guide and of the options' lengths
    bool only_nets = false;                        ///< see Method::start(); for methods that go from net to net
    std::span<const Slide> slides = {};            ///< of free vertices, distinct; for methods that know slides
    bool only_walks = false;                       ///< see Method::start(); for methods that go from net to net
    bool limit_gives_way = false;                  ///< Options::shear_limit, as little as handles make it; likewise
};

}  // namespace chebnet
