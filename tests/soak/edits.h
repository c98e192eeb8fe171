#pragma once

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

/// One to many exact handles at random vertices, at rest.
std::vector<Handle> random_handles(const Net& net, Random& random);

}  // namespace chebnet::soak
