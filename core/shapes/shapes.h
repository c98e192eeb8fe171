#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "net/net.h"

namespace chebnet {

/// Nets that are exactly Chebyshev (to 1e-12 of an edge), by construction or relaxed, each made from a recipe.
///
/// A recipe is a short text that fits a link: NAME or NAME:key=value,key=value …, for example `dome` or
/// `vault:vertices=4000,rise=0.4`. Parameters that are not named take their defaults. Every shape has the parameter
/// `vertices`, 100 … 100000: about how many vertices the net is to have (within 15 %, or as near as the shape allows).
/// The edge length is chosen so that the shape is about 10 units across, whatever the number of vertices. z is up.

struct ShapeParameter {
    const char* name;
    double value, smallest, largest;  ///< default and range
    const char* sentence;
};

/// One line of the gallery.
struct ShapeInfo {
    const char* name = "";      ///< as in a recipe
    const char* title = "";     ///< for people
    const char* sentence = "";  ///< what it is
    std::span<const ShapeParameter> parameters;
    const char* offered = nullptr;  ///< the recipe that a gallery opens; null: the name
};
std::span<const ShapeInfo> shape_table();

/// Handles that make a good first edit of a shape: some anchors, and one vertex to drag (the last).
struct Shape {
    Net net;
    std::vector<int> suggested_handles;  ///< distinct vertices; all but the last are anchors
};

/// Makes the shape of a recipe. Throws Error bad_syntax or bad_option, naming what is wrong and what is known, or
/// left_out for one that this build only has the words of.
Shape make_shape(std::string_view recipe);

}  // namespace chebnet
