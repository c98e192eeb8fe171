#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "edit/editor.h"
#include "nets.h"

namespace chebnet::soak {

/// A way to choose where handles are to go.
struct EditKind {
    const char* name;
    int weight;  ///< how often it is chosen
    std::vector<Handle> (*move)(const Editor&, Random&);
};

std::span<const EditKind> edit_kinds();
const EditKind& random_edit_kind(Random& random);

/// What the net is of, as a user may choose for method `equilibrium`: most often the usual, else other limits of the
/// corners, straight rods, weights, gravity.
Options random_behaviour(Random& random);

/// One to many handles at random vertices, at rest. Most nets have exact ones alone; of others some are soft or slide,
/// where the method of this name knows that.
std::vector<Handle> random_handles(const Net& net, std::string_view method, Random& random);

/// How handles come to the targets of an edit, and in how many frames.
struct Manner {
    bool drags = false;  ///< by a hand, which lets go in the end; else all are set, or those that go elsewhere moved
    double radius = 0;   ///< above 0: only so far around the handle that goes elsewhere may the net move
    int iterations = 0;  ///< of one frame, before the solve is left to come to its end; 0: it is at once
    Axes along = k_all_axes;  ///< to which a hand is kept
};
Manner random_manner(Random& random);

}  // namespace chebnet::soak
