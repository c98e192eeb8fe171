#include "io/format.h"

#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "io/obj.h"
#include "io/off.h"
#include "io/ply.h"
#include "io/stl.h"

namespace chebnet {

namespace {

constexpr FormatInfo k_formats[] = {k_obj, k_ply, k_off, k_stl};

std::string listed(const std::vector<std::string>& items, std::string_view conjunction) {
    std::string list;
    for (const std::string& item : items) {
        if (&item != &items.front() && &item != &items.back()) list += ", ";
        if (&item != &items.front() && &item == &items.back()) list.append(" ").append(conjunction).append(" ");
        list += item;
    }
    return list;
}

}  // namespace

std::span<const FormatInfo> format_table() { return k_formats; }

const FormatInfo& find_format(std::string_view name) {
    std::string known;
    for (const FormatInfo& format : k_formats) {
        if (name == format.name) return format;
        known.append(known.empty() ? "" : ", ").append(format.name);
    }
    throw Error(ErrorCode::bad_option, "no format is called " + quoted(name) + "; known are " + known);
}

std::string titles_read(std::string_view conjunction) {
    std::vector<std::string> titles;
    for (const FormatInfo& format : k_formats) titles.emplace_back(format.title);
    return listed(titles, conjunction);
}

std::string titles_binary_or_text(std::string_view conjunction) {
    std::vector<std::string> titles;
    for (const FormatInfo& format : k_formats)
        if (format.write_text != nullptr && format.write_text != format.write) titles.emplace_back(format.title);
    return listed(titles, conjunction);
}

std::string extensions_written(std::string_view conjunction) {
    std::vector<std::string> extensions;
    for (const FormatInfo& format : k_formats) extensions.push_back(std::string(1, '.').append(format.name));
    return listed(extensions, conjunction);
}

}  // namespace chebnet
