#pragma once

#include <functional>
#include <memory>

#include "remesh/remesh.h"
#include "surface/guide.h"

namespace chebnet {

/// Makes a net over all of a surface. Throws Error bad_option or too_large where there is none.
using WholeRemesh = std::function<Remesh(const std::shared_ptr<const Guide>& guide)>;

/// What `make` makes of a surface, or, where it makes none or a crumpled net, of the surface without limbs too thin for
/// cells of this size if that is clearly less crumpled: then with Remesh::left_off. Nothing is left off where anything
/// is wished for or creases are marked. Throws as the first `make` does where none is made at all.
Remesh with_fitting_limbs(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                          const WholeRemesh& make);

}  // namespace chebnet
