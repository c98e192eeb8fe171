#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "figures.h"
#include "net/net.h"

namespace chebnet::bench {

/// Where pictures look from: the net stands upright, seen from the front and a little above.
struct Camera {
    Eigen::AlignedBox3d room;             ///< what is to fit into the picture
    double azimuth = 35, elevation = 20;  ///< degrees; azimuth 0 looks along +y
};

/// Draws a net in the paper's colours: blue edges have dL < 1e-6, red ones dL > 2e-6; or pink ones that are longer than
/// L; or faces the redder, the farther their corners are from right angles. Handles at rest are dark dots, others
/// orange. Faces with a corner below 5° are circled where that is what is looked for (Colouring::angle). Throws Error
/// file_access.
void draw_net(const Net& net, const Positions& positions, const std::vector<Handle>& handles, Colouring colouring,
              const Camera& camera, const std::string& path);

}  // namespace chebnet::bench
