#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// A good start, then exact lengths (our own; no paper has it as a whole). In stages:
///
///   1  ARAP iterations on a copy of the net that remembers its rest shape; the net takes over how the copy moves, and
///      goes a small part of its way to the copy, so that frame after frame of a drag bends it no more than one large
///      step would (Sorkine & Alexa 2007);
///   2  quasi-Newton descent on springs, smooth and cheap, until max dL is small (Liu et al. 2017, SpringDescent);
///   3  projection onto the lengths, which converges quadratically (Goldenthal et al. 2007, LengthProjection); where it
///      does not come closer, the net goes back and becomes smoother first, by stage 2, which goes on where it was, and
///      when that has had its share of iterations by
///   4  Gauss–Newton steps (gauss_newton), each as costly as one of the paper's, which go on to the end if need be.
///
/// Where so many edges meet at a vertex that the system of stage 3 would be too large, stage 4 takes its place at once.
///
/// Holds pull the copy in stage 1, which so decides where they are to be; the net's are drawn there by springs of their
/// own, which become weaker where lengths and holds cannot agree, and give way last in stage 3. Stage 4 ignores them.
///
/// Stages 1 to 3 use two systems of fixed pattern: the net's Laplacian, factored once for a set of handles and weights
/// of holds, and the projection's, analysed once for a net. They allocate nothing once they have run.
std::unique_ptr<Method> make_projection();

}  // namespace chebnet
