#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace chebnet {

/// A row of the table that stands beside an enum: what files and JavaScript call its enumerators.
template <typename T>
struct EnumName {
    const char* name;
    T value;
};

/// Throws Error bad_option: none of the `known` is called so.
[[noreturn]] void fail_with_unknown_name(std::string_view name, const char* what, const std::string& known);

/// The enumerator of that name. Throws Error bad_option; `what` it should be, e.g. "border", is for the message.
template <typename T, std::size_t size>
T named(const EnumName<T> (&table)[size], std::string_view name, const char* what) {
    std::string known;
    for (const EnumName<T>& row : table) {
        if (row.name == name) return row.value;
        known.append(known.empty() ? "" : ", ").append(row.name);
    }
    fail_with_unknown_name(name, what, known);
}

/// The name of an enumerator, of which the table has all.
template <typename T, std::size_t size>
const char* name_of(const EnumName<T> (&table)[size], T value) {
    std::size_t row = 0;
    while (row + 1 < size && table[row].value != value) ++row;
    return table[row].name;
}

}  // namespace chebnet
