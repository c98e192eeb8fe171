// What all bindings have in common. They only translate: numbers, text and flat arrays cross the border by copy, an
// exception becomes a JavaScript Error with a `code`.
#pragma once

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <utility>

#include "base/error.h"

namespace chebnet {

using emscripten::val;

/// A copy on the JavaScript side: a view would be cut off when the memory grows.
template <typename T>
val copy_out(const T* data, std::size_t size) {
    return val(emscripten::typed_memory_view(size, data)).template call<val>("slice");
}

template <typename Container>
val copy_out(const Container& container) {
    return copy_out(container.data(), static_cast<std::size_t>(container.size()));
}

/// The bytes as a Uint8Array.
inline val bytes_out(const std::string& bytes) {
    return copy_out(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

/// An array of what `row_of` makes of each item; of the items themselves, unless it is given.
template <typename Range, typename RowOf = std::identity>
val list_out(const Range& range, const RowOf& row_of = {}) {
    val list = val::array();
    for (const auto& item : range) list.call<void>("push", row_of(item));
    return list;
}

[[noreturn]] inline void throw_to_javascript(const char* code, const char* message) {
    val error = val::global("Error").new_(std::string(message));
    error.set("code", std::string(code));
    error.throw_();
}

/// Throws the C++ exception that is being handled, as JavaScript knows it. In one place: each function that is bound
/// would have all this code otherwise.
[[noreturn]] inline void throw_what_was_caught() {
    try {
        throw;
    } catch (const Error& error) {
        throw_to_javascript(to_string(error.code()), error.what());
    } catch (const std::bad_alloc&) {
        throw_to_javascript("too_large", "there is not enough memory for this");
    } catch (const std::exception& error) {
        throw_to_javascript("internal", error.what());
    }
}

/// `guarded<&f>` is f with its C++ exceptions turned into JavaScript ones.
template <auto function>
struct Guard;

template <typename Result, typename... Arguments, Result (*function)(Arguments...)>
struct Guard<function> {
    static Result call(Arguments... arguments) {
        try {
            return function(std::forward<Arguments>(arguments)...);
        } catch (...) {
            throw_what_was_caught();
        }
    }
};

template <auto function>
constexpr auto guarded = &Guard<function>::call;

}  // namespace chebnet
