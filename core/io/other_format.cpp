#include "io/other_format.h"

#include <algorithm>
#include <string>

namespace chebnet {

namespace {

using namespace std::string_view_literals;

struct Kind {
    std::string_view signature, name;
};

/// By the first bytes.
constexpr Kind k_beginnings[] = {
    {"PK\3\4"sv, "a ZIP archive"},
    {"\x1f\x8b"sv, "a gzip archive"},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive"},
    {"Rar!\x1a\7"sv, "a RAR archive"},
    {"\x89PNG"sv, "a PNG picture"},
    {"\xff\xd8\xff"sv, "a JPEG picture"},
    {"GIF8"sv, "a GIF picture"},
    {"%PDF-"sv, "a PDF document"},
    {"glTF"sv, "a GLB model"},
    {"3D Geometry File Format "sv, "a 3DM model"},
    {"Kaydara FBX Binary"sv, "an FBX model"},
    {"BLENDER"sv, "a Blender scene"},
    {"ISO-10303-21;"sv, "a STEP model"},
    {"\xff\xfe"sv, "a text in UTF-16"},
    {"\xfe\xff"sv, "a text in UTF-16"},
};

/// Of a file that begins with "<", by the element that comes first in it, in lower case.
constexpr Kind k_elements[] = {
    {"<svg"sv, "an SVG drawing"},
    {"<html"sv, "a web page"},
    {"<!doctype html"sv, "a web page"},
    {"<collada"sv, "a COLLADA model"},
};

/// Length of the front that is searched for the element: comments and a document type may precede it.
constexpr std::size_t k_longest_prologue = 2000;

std::string_view without_blank_front(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf"sv)) bytes.remove_prefix(3);
    bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
    return bytes;
}

std::string_view kind_of_markup(std::string_view text) {
    std::string front(text.substr(0, k_longest_prologue));
    std::transform(front.begin(), front.end(), front.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const auto& [signature, name] : k_elements)
        if (front.find(signature) != std::string::npos) return name;
    return "an XML document";
}

}  // namespace

std::optional<std::string_view> other_format(std::string_view bytes) {
    for (const auto& [signature, name] : k_beginnings)
        if (bytes.starts_with(signature)) return name;
    const std::string_view text = without_blank_front(bytes);
    if (text.starts_with('<')) return kind_of_markup(text);
    if (text.starts_with('{')) return "a JSON document";
    return std::nullopt;
}

}  // namespace chebnet
