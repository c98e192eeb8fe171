#include <algorithm>
#include <cmath>

#include "net/measures.h"
#include "reader.h"
#include "shapes/shapes.h"

using namespace chebnet;
using fuzz::require;

namespace {

/// Numbers of five digits or with an exponent may ask for 100,000 vertices: allowed, but a second of nothing new.
bool may_be_large(std::string_view recipe) {
    int digits = 0;
    return std::any_of(recipe.begin(), recipe.end(), [&digits](unsigned char c) {
        const bool is_exponent = digits > 0 && (c == 'e' || c == 'E');
        digits = std::isdigit(c) || (digits > 0 && c == '.') ? digits + 1 : 0;
        return digits > 4 || is_exponent;
    });
}

void require_exact(const Shape& shape) {
    require(shape.net.is_chebyshev(), "a shape whose edges differ");
    const double dL = max_deviation(shape.net, shape.net.rest_positions());
    require(dL < 1e-24, "a shape with an edge off its length by " + std::to_string(std::sqrt(dL)));
}

void require_handles(const Shape& shape) {
    std::vector<int> handles = shape.suggested_handles;
    std::sort(handles.begin(), handles.end());
    require(!handles.empty() && handles.front() >= 0 && handles.back() < shape.net.vertex_count(),
            "a suggested handle is no vertex");
    require(std::adjacent_find(handles.begin(), handles.end()) == handles.end(), "a handle is suggested twice");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view recipe = fuzz::as_text(data, size);
    if (may_be_large(recipe)) return 0;
    try {
        const Shape shape = make_shape(recipe);
        require_exact(shape);
        require_handles(shape);
    } catch (const Error& error) {
        fuzz::require_readable(error);
        require(error.code() == ErrorCode::bad_syntax || error.code() == ErrorCode::bad_option,
                std::string("a recipe is refused with ") + to_string(error.code()));
    }
    return 0;
}
