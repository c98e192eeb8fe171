#include "io/ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "io/bytes.h"
#include "io/file.h"
#include "io/indexed_rows.h"
#include "io/ply_header.h"

namespace chebnet {

namespace {

using ply::Element;
using ply::Encoding;
using ply::Header;
using ply::Property;
using ply::Scalar;

// ------------------------------------------------------------------------------------------------------------- values

/// The data behind a header, row by row and value by value. Every type of PLY fits a double exactly.
class Values {
public:
    virtual ~Values() = default;
    virtual void begin_row(const Element& element, std::int64_t row) = 0;
    virtual double next(Scalar type) = 0;
    virtual void end_row() {}
    virtual void end() {}
    /// Throws an error whose message says where in the file this is.
    [[noreturn]] virtual void fail(ErrorCode code, const std::string& what) const = 0;
};

std::string count_of_rows(const Element& element) {
    return std::to_string(element.count) + " rows of " + quoted(element.name);
}

/// One line a row.
class TextValues : public Values {
public:
    TextValues(const Lines& lines, std::string_view name) : m_lines(lines), m_name(name) {}

    void begin_row(const Element& element, std::int64_t row) override {
        if (!take_line())
            fail(ErrorCode::bad_syntax, "the file ends after " + std::to_string(row) + " of the " +
                                            count_of_rows(element) + " that its header declares");
    }

    double next(Scalar) override {
        const std::string_view word = take_word(m_line);
        if (word.empty()) fail(ErrorCode::bad_syntax, "this line has fewer values than the header declares");
        const std::optional<double> number = parse_number(word);
        if (!number) fail(ErrorCode::bad_syntax, quoted(word) + " is not a number");
        return *number;
    }

    void end_row() override {
        if (!take_word(m_line).empty())
            fail(ErrorCode::bad_syntax, "this line has more values than the header declares");
    }

    void end() override {
        if (take_line()) fail(ErrorCode::bad_syntax, "the file has more lines than its header declares");
    }

    [[noreturn]] void fail(ErrorCode code, const std::string& what) const override {
        fail_at_line(code, m_name, m_lines.number(), what);
    }

private:
    /// Goes to the next line that is not blank; false if there is none.
    bool take_line() {
        while (!m_lines.at_end()) {
            m_line = m_lines.take();
            if (!std::all_of(m_line.begin(), m_line.end(), is_blank)) return true;
        }
        return false;
    }

    Lines m_lines;
    std::string_view m_name, m_line;
};

class BinaryValues : public Values {
public:
    BinaryValues(std::string_view bytes, std::endian order, std::string_view name)
        : m_rest(bytes), m_order(order), m_name(name) {}

    void begin_row(const Element& element, std::int64_t row) override {
        m_element = &element;
        m_row = row;
    }

    double next(Scalar type) override {
        switch (type) {
            case Scalar::int8:
                return take<std::int8_t>();
            case Scalar::uint8:
                return take<std::uint8_t>();
            case Scalar::int16:
                return take<std::int16_t>();
            case Scalar::uint16:
                return take<std::uint16_t>();
            case Scalar::int32:
                return take<std::int32_t>();
            case Scalar::uint32:
                return take<std::uint32_t>();
            case Scalar::float32:
                return take<float>();
            case Scalar::float64:
                break;
        }
        return take<double>();
    }

    [[noreturn]] void fail(ErrorCode code, const std::string& what) const override {
        const bool is_ours = m_element->name == "vertex" || m_element->name == "face";
        const std::string row = (is_ours ? m_element->name : quoted(m_element->name)) + " " + std::to_string(m_row);
        throw Error(code, std::string(m_name) + ": " + row + ": " + what);
    }

private:
    template <class T>
    T take() {
        if (m_rest.size() < sizeof(T))
            fail(ErrorCode::bad_syntax, "the file ends here, but its header declares " + count_of_rows(*m_element));
        const T number = number_at<T>(m_rest.data(), m_order);
        m_rest.remove_prefix(sizeof(T));
        return number;
    }

    std::string_view m_rest;
    std::endian m_order;
    std::string_view m_name;
    const Element* m_element = nullptr;
    std::int64_t m_row = 0;
};

std::unique_ptr<Values> values_of(Encoding encoding, const Lines& lines, std::string_view name) {
    if (encoding == Encoding::text) return std::make_unique<TextValues>(lines, name);
    const std::endian order = encoding == Encoding::little_endian ? std::endian::little : std::endian::big;
    return std::make_unique<BinaryValues>(lines.rest(), order, name);
}

// ------------------------------------------------------------------------------------------------------------ reading

class PlyReader {
public:
    PlyReader(std::string_view bytes, std::string_view name) : m_lines(bytes), m_name(name) {}

    Mesh read() {
        m_header = ply::read_header(m_lines, m_name);
        find_coordinates();
        find_corners();
        m_values = values_of(m_header.encoding, m_lines, m_name);
        for (const Element& element : m_header.elements) read_element(element);
        m_values->end();
        return {Eigen::Map<const Positions>(m_coordinates.data(), 3, std::ssize(m_coordinates) / 3),
                std::move(m_faces)};
    }

private:
    void find_coordinates() {
        const Element* const vertex = m_header.find("vertex");
        if (!vertex) fail_header(ErrorCode::bad_syntax, "the header declares no element \"vertex\"");
        check_count(*vertex, "vertices");
        m_vertex_count = static_cast<int>(vertex->count);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string coordinate(1, "xyz"[axis]);
            const auto place = vertex->find(coordinate);
            if (!place || vertex->properties[*place].count_type)
                fail_header(ErrorCode::bad_syntax, "the element \"vertex\" has no coordinate \"" + coordinate + '"');
            m_coordinate_places[axis] = *place;
        }
    }

    void find_corners() {
        const Element* const face = m_header.find("face");
        if (!face) return;
        check_count(*face, "faces");
        auto place = face->find("vertex_indices");
        if (!place) place = face->find("vertex_index");
        if (!place || !face->properties[*place].count_type)
            fail_header(ErrorCode::bad_syntax, "the element \"face\" has no list \"vertex_indices\"");
        m_corners_place = *place;
    }

    void check_count(const Element& element, const std::string& what) const {
        if (element.count > k_max_file_elements)
            fail_header(ErrorCode::too_large, "more than " + std::to_string(k_max_file_elements) + " " + what);
    }

    // Memory grows with the data read, not with the counts that the header declares.
    void read_element(const Element& element) {
        for (std::int64_t row = 0; row < element.count; ++row) {
            m_values->begin_row(element, row);
            if (element.name == "vertex")
                read_vertex(element);
            else if (element.name == "face")
                read_face(element);
            else
                pass_over(element);
            m_values->end_row();
        }
    }

    void read_vertex(const Element& element) {
        std::array<double, 3> position{};
        for (std::size_t place = 0; place < element.properties.size(); ++place) {
            const Property& property = element.properties[place];
            const auto axis = std::find(m_coordinate_places.begin(), m_coordinate_places.end(), place);
            if (axis == m_coordinate_places.end())
                pass_over(property);
            else
                position[axis - m_coordinate_places.begin()] = read_coordinate(property);
        }
        m_coordinates.insert(m_coordinates.end(), position.begin(), position.end());
    }

    double read_coordinate(const Property& property) {
        const double coordinate = m_values->next(property.type);
        if (!std::isfinite(coordinate))
            m_values->fail(ErrorCode::non_finite, "the coordinate " + property.name + " is not finite");
        return coordinate;
    }

    void read_face(const Element& element) {
        for (std::size_t place = 0; place < element.properties.size(); ++place) {
            if (place == m_corners_place)
                read_corners(element.properties[place]);
            else
                pass_over(element.properties[place]);
        }
    }

    void read_corners(const Property& list) {
        m_face.clear();
        for (double left = read_list_size(list); left > 0; --left) m_face.push_back(read_corner(list));
        if (m_face.size() < 3)
            m_values->fail(ErrorCode::small_face,
                           "a face needs at least three vertices, this one has " + std::to_string(m_face.size()));
        m_faces.add(m_face);
    }

    int read_corner(const Property& list) {
        const double vertex = m_values->next(list.type);
        if (!is_integer(vertex)) m_values->fail(ErrorCode::bad_syntax, "a face names a vertex by a fraction");
        if (vertex < 0 || vertex >= m_vertex_count)
            m_values->fail(ErrorCode::index_out_of_range, "a face names vertex " + integer_text(vertex) + ", but the " +
                                                              std::to_string(m_vertex_count) +
                                                              " vertices are counted from 0");
        return static_cast<int>(vertex);
    }

    double read_list_size(const Property& list) {
        const double size = m_values->next(*list.count_type);
        if (!is_integer(size) || size < 0)
            m_values->fail(ErrorCode::bad_syntax, "the length of the list " + quoted(list.name) + " is not a count");
        return size;
    }

    void pass_over(const Element& element) {
        for (const Property& property : element.properties) pass_over(property);
    }

    void pass_over(const Property& property) {
        for (double left = property.count_type ? read_list_size(property) : 1; left > 0; --left)
            m_values->next(property.type);
    }

    static bool is_integer(double number) { return std::isfinite(number) && std::trunc(number) == number; }

    /// Numbers beyond those of a 32-bit integer can only stand in a text or a list of floats.
    static std::string integer_text(double integer) { return number_text(integer, 17); }

    [[noreturn]] void fail_header(ErrorCode code, const std::string& what) const {
        fail_at_line(code, m_name, m_lines.number(), what);
    }

    Lines m_lines;
    std::string_view m_name;
    Header m_header;
    std::unique_ptr<Values> m_values;
    std::array<std::size_t, 3> m_coordinate_places{};
    std::size_t m_corners_place = 0;
    int m_vertex_count = 0;
    std::vector<double> m_coordinates;
    Faces m_faces;
    std::vector<int> m_face;
};

// ------------------------------------------------------------------------------------------------------------ writing

std::size_t largest_arity(const Faces& faces) {
    std::size_t largest = 0;
    for (int f = 0; f < faces.size(); ++f) largest = std::max(largest, faces[f].size());
    return largest;
}

std::string header_text(const Positions& positions, const Faces& faces, PlyEncoding encoding, bool short_lists) {
    const std::string format = encoding == PlyEncoding::text ? "ascii" : "binary_little_endian";
    return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(positions.cols()) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(faces.size()) +
           "\nproperty list " + (short_lists ? "uchar" : "uint") + " int vertex_indices\nend_header\n";
}

std::string binary_rows(const Positions& positions, const Faces& faces, bool short_lists) {
    std::string bytes;
    for (const double coordinate : positions.reshaped()) append_little_endian(bytes, coordinate);
    for (int f = 0; f < faces.size(); ++f) {
        if (short_lists)
            append_little_endian(bytes, static_cast<std::uint8_t>(faces[f].size()));
        else
            append_little_endian(bytes, static_cast<std::uint32_t>(faces[f].size()));
        for (const int vertex : faces[f]) append_little_endian(bytes, static_cast<std::int32_t>(vertex));
    }
    return bytes;
}

}  // namespace

bool is_ply(std::string_view bytes) {
    std::string_view first_line = Lines(bytes).take();
    return take_word(first_line) == "ply" && take_word(first_line).empty();
}

Mesh read_ply(std::string_view bytes, std::string_view name) { return PlyReader(bytes, name).read(); }

std::string write_ply(const Positions& positions, const Faces& faces, PlyEncoding encoding) {
    // Most programs expect a count of one byte.
    const bool short_lists = largest_arity(faces) <= 255;
    return header_text(positions, faces, encoding, short_lists) + (encoding == PlyEncoding::text
                                                                       ? indexed_rows(positions, faces)
                                                                       : binary_rows(positions, faces, short_lists));
}

}  // namespace chebnet
