#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// A good start, then exact lengths (our own; no paper has it as a whole). Four stages:
///
///   1  ARAP iterations on a copy of the net that remembers its rest shape; the net takes over how the copy moves, and
///      goes a small part of its way to the copy, so that frame after frame of a drag bends it no more than one large
///      step would (Sorkine & Alexa 2007);
///   2  quasi-Newton descent on springs, smooth and cheap, until max dL is small (Liu et al. 2017, SpringDescent);
///   3  projection onto the lengths, which converges quadratically (Goldenthal et al. 2007, LengthProjection); where it
///      does not come closer, stage 2 goes on to a smaller max dL, up to four times in all;
///   4  only where all of this fails: the method of Li et al. 2022, from the last end of stage 2.
///
/// All but stage 4 use two systems of fixed pattern: the net's Laplacian, factored once for a set of handles, and the
/// projection's, analysed once for a net.
std::unique_ptr<Method> make_projection();

}  // namespace chebnet
