#pragma once

namespace chebnet {

/// `function`, for a row of a table; or null in sources compiled for the texts of their rows only, without the code
/// (wasm/left_out.cmake).
template <typename Function>
static consteval Function* in_this_build([[maybe_unused]] Function* function) {
#ifdef CHEBNET_WORDS_ONLY
    return nullptr;
#else
    return function;
#endif
}

}  // namespace chebnet
