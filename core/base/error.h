#pragma once

#include <stdexcept>
#include <string>

namespace chebnet {

/// What was wrong with an input. The name of each code is part of the public interface: it is what JavaScript sees as
/// `error.code`, and it never changes its meaning.
enum class ErrorCode {
    no_faces,            ///< the net has no face at all
    index_out_of_range,  ///< a face, a handle or a file names a vertex that does not exist
    repeated_vertex,     ///< one face names a vertex twice, or two handles hold the same vertex
    small_face,          ///< a face has fewer than three vertices
    non_finite,          ///< a coordinate, a target or an option is NaN or infinite
    zero_length_edge,    ///< the two ends of an edge coincide
    bad_scale,           ///< the edges of a net are so long or so short that computing with them would overflow
    non_manifold_edge,   ///< more than two faces meet at an edge
    unused_vertex,       ///< a vertex belongs to no face
    bad_syntax,          ///< a file, a recipe or a JSON text cannot be read; the message names the line
    bad_option,          ///< an option, a method or a shape of that name does not exist, or its value is out of range
    too_large,           ///< the input is above a stated limit
    file_access,         ///< a file cannot be opened or written
    impossible_change,   ///< a net does not allow a change of its faces; the message says why, and what else to do
    left_out,            ///< this build of the core does without it; the whole core has it
};

/// The code's name as text, e.g. "non_manifold_edge".
const char* to_string(ErrorCode code);

/// Every fault of an input is reported by this one exception, where the input enters. The message is one sentence for a
/// person and names what and where: file and line, index, value.
class Error : public std::runtime_error {
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), m_code(code) {}
    ErrorCode code() const { return m_code; }

private:
    ErrorCode m_code;
};

}  // namespace chebnet
