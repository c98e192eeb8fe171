#include "solve/methods/methods.h"
#include "solve/parts/alternating.h"
#include "solve/parts/arap_step.h"
#include "solve/parts/option_names.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_arap() { return std::make_unique<Alternating>(make_alternating_step<ArapStep>); }

}  // namespace

/// ARAP as a method: it keeps shapes rather than lengths, and as a rule ends `stalled` at its minimum.
constinit const MethodInfo k_arap = {
    "arap",
    "As rigid as possible: the edges at each vertex turn together from rest; keeps shapes, not lengths.",
    "Sorkine, Alexa: As-Rigid-As-Possible Surface Modeling. Symposium on Geometry Processing 2007",
    k_alternating_names,
    k_tolerances,
    in_this_build(make_arap)};

}  // namespace chebnet
