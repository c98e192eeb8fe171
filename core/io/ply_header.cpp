#include "io/ply_header.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace chebnet::ply {

namespace {

constexpr std::pair<std::string_view, Encoding> k_encodings[] = {
    {"ascii", Encoding::text},
    {"binary_little_endian", Encoding::little_endian},
    {"binary_big_endian", Encoding::big_endian},
};

/// Turk's own names and those by size.
constexpr std::pair<std::string_view, Scalar> k_scalars[] = {
    {"char", Scalar::int8},     {"int8", Scalar::int8},       {"uchar", Scalar::uint8},    {"uint8", Scalar::uint8},
    {"short", Scalar::int16},   {"int16", Scalar::int16},     {"ushort", Scalar::uint16},  {"uint16", Scalar::uint16},
    {"int", Scalar::int32},     {"int32", Scalar::int32},     {"uint", Scalar::uint32},    {"uint32", Scalar::uint32},
    {"float", Scalar::float32}, {"float32", Scalar::float32}, {"double", Scalar::float64}, {"float64", Scalar::float64},
};

/// Names are compared each with each; real files declare a few dozen.
constexpr int k_max_declarations = 1000;

template <class Table>
auto look_up(const Table& table, std::string_view name) {
    const auto found = std::find_if(std::begin(table), std::end(table), [&](auto& row) { return row.first == name; });
    return found == std::end(table) ? std::nullopt : std::optional(found->second);
}

template <class Named>
const Named* find_named(const std::vector<Named>& list, std::string_view name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Named& entry) { return entry.name == name; });
    return found == list.end() ? nullptr : &*found;
}

class HeaderReader {
public:
    HeaderReader(Lines& lines, std::string_view name) : m_lines(lines), m_name(name) {}

    Header read() {
        if (m_words = m_lines.take(); take_word(m_words) != "ply") fail("a PLY file begins with a line \"ply\"");
        while (read_statement()) {
        }
        if (!m_encoding) fail("the header names no format, such as \"format ascii 1.0\"");
        check_elements();
        return {*m_encoding, std::move(m_elements)};
    }

private:
    /// False at the end of the header.
    bool read_statement() {
        if (m_lines.at_end()) fail("the file ends within its header, before a line \"end_header\"");
        m_words = m_lines.take();
        const std::string_view keyword = take_word(m_words);
        if (keyword == "end_header") return false;
        if (keyword == "format")
            read_format();
        else if (keyword == "element")
            read_element();
        else if (keyword == "property")
            read_property();
        else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty())
            fail(quoted(keyword) + " is not a statement of a PLY header");
        return true;
    }

    void read_format() {
        const std::string_view format = take_word(m_words);
        m_encoding = look_up(k_encodings, format);
        if (!m_encoding) fail("the format is ascii, binary_little_endian or binary_big_endian, not " + quoted(format));
    }

    void read_element() {
        count_declaration();
        const std::string_view element = take_word(m_words), count_word = take_word(m_words);
        const std::optional<std::int64_t> count = parse_count(count_word);
        if (!count) fail(quoted(count_word) + " is not a number of elements");
        if (find_named(m_elements, element)) fail("the element " + quoted(element) + " is declared twice");
        m_elements.push_back({std::string(element), *count, {}});
    }

    void read_property() {
        count_declaration();
        if (m_elements.empty()) fail("a property stands before the first element");
        std::vector<Property>& properties = m_elements.back().properties;
        Property property = read_type();
        property.name = take_word(m_words);
        if (property.name.empty()) fail("a property has no name");
        if (find_named(properties, property.name)) fail("the property " + quoted(property.name) + " is declared twice");
        properties.push_back(std::move(property));
    }

    Property read_type() {
        const std::string_view type = take_word(m_words);
        if (type != "list") return {"", read_scalar(type), std::nullopt};
        const Scalar count_type = read_scalar(take_word(m_words));
        return {"", read_scalar(take_word(m_words)), count_type};
    }

    Scalar read_scalar(std::string_view type) const {
        const std::optional<Scalar> scalar = look_up(k_scalars, type);
        if (!scalar) fail(quoted(type) + " is not a type of PLY, such as uchar, int, float or double");
        return *scalar;
    }

    void count_declaration() {
        if (++m_declaration_count > k_max_declarations)
            fail_at_line(ErrorCode::too_large, m_name, m_lines.number(),
                         "more than " + std::to_string(k_max_declarations) + " elements and properties");
    }

    /// A row without properties takes no room, so that a file could declare any number of them.
    void check_elements() const {
        for (const Element& element : m_elements)
            if (element.properties.empty() && element.count > 0)
                fail("the element " + quoted(element.name) + " has no properties");
    }

    [[noreturn]] void fail(const std::string& what) const {
        fail_at_line(ErrorCode::bad_syntax, m_name, m_lines.number(), what);
    }

    Lines& m_lines;
    std::string_view m_name, m_words;
    std::optional<Encoding> m_encoding;
    std::vector<Element> m_elements;
    int m_declaration_count = 0;
};

}  // namespace

std::optional<std::size_t> Element::find(std::string_view property_name) const {
    const Property* const property = find_named(properties, property_name);
    return property ? std::optional<std::size_t>(property - properties.data()) : std::nullopt;
}

const Element* Header::find(std::string_view element_name) const { return find_named(elements, element_name); }

Header read_header(Lines& lines, std::string_view name) { return HeaderReader(lines, name).read(); }

}  // namespace chebnet::ply
