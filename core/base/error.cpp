#include "base/error.h"

namespace chebnet {

const char* to_string(ErrorCode code) {
    switch (code) {
        case ErrorCode::no_faces:
            return "no_faces";
        case ErrorCode::index_out_of_range:
            return "index_out_of_range";
        case ErrorCode::repeated_vertex:
            return "repeated_vertex";
        case ErrorCode::small_face:
            return "small_face";
        case ErrorCode::non_finite:
            return "non_finite";
        case ErrorCode::zero_length_edge:
            return "zero_length_edge";
        case ErrorCode::bad_scale:
            return "bad_scale";
        case ErrorCode::non_manifold_edge:
            return "non_manifold_edge";
        case ErrorCode::unused_vertex:
            return "unused_vertex";
        case ErrorCode::bad_syntax:
            return "bad_syntax";
        case ErrorCode::bad_option:
            return "bad_option";
        case ErrorCode::too_large:
            return "too_large";
        case ErrorCode::impossible_change:
            return "impossible_change";
        case ErrorCode::left_out:
            return "left_out";
        case ErrorCode::file_access:
            return "file_access";
    }
    return "unknown";
}

}  // namespace chebnet
