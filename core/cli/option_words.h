#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>

#include "base/enum_names.h"

namespace chebnet {

/// The enumerators of a table by their names as the command line has them: with hyphens.
template <typename T, std::size_t size>
std::map<std::string, T> option_words(const EnumName<T> (&table)[size]) {
    std::map<std::string, T> words;
    for (const EnumName<T>& row : table) {
        std::string word = row.name;
        std::replace(word.begin(), word.end(), '_', '-');
        words.emplace(word, row.value);
    }
    return words;
}

}  // namespace chebnet
