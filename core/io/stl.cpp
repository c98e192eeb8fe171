#include "io/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "io/bytes.h"
#include "io/file.h"
#include "net/triangulation.h"

namespace chebnet {

namespace {

// Of binary STL: 80 bytes of any kind and the number of triangles; then of each its normal and corners as floats, and
// two bytes of attributes.
constexpr std::size_t k_header_size = 84, k_triangle_size = 50, k_normal_size = 12, k_corner_size = 12;

std::size_t declared_triangles(std::string_view bytes) {
    return number_at<std::uint32_t>(bytes.data() + 80, std::endian::little);
}

bool is_binary(std::string_view bytes) {
    return bytes.size() >= k_header_size && bytes.size() == k_header_size + declared_triangles(bytes) * k_triangle_size;
}

/// Triangles whose corners are one vertex where they have one place.
class Welded {
public:
    int vertex_at(const Eigen::Vector3d& corner) {
        const auto [found, is_new] =
            m_vertices.try_emplace({corner.x(), corner.y(), corner.z()}, static_cast<int>(m_vertices.size()));
        if (is_new) m_coordinates.insert(m_coordinates.end(), corner.begin(), corner.end());
        return found->second;
    }
    void add(const std::array<int, 3>& triangle) { m_faces.add(triangle); }
    int triangle_count() const { return m_faces.size(); }

    Mesh mesh() {
        const auto count = static_cast<Eigen::Index>(m_vertices.size());
        return {Eigen::Map<const Positions>(m_coordinates.data(), 3, count), std::move(m_faces)};
    }

private:
    using Place = std::array<double, 3>;
    struct Hash {
        std::size_t operator()(const Place& place) const {
            std::size_t hash = 0;
            for (const double coordinate : place) hash = 31 * hash + std::hash<double>()(coordinate);
            return hash;
        }
    };

    std::unordered_map<Place, int, Hash> m_vertices;
    std::vector<double> m_coordinates;
    Faces m_faces;
};

Mesh read_binary(std::string_view bytes, std::string_view name) {
    const std::size_t count = declared_triangles(bytes);
    if (count > static_cast<std::size_t>(k_max_file_elements))
        throw Error(ErrorCode::too_large,
                    std::string(name) + ": more than " + std::to_string(k_max_file_elements) + " triangles");
    Welded welded;
    for (std::size_t t = 0; t < count; ++t) {
        std::array<int, 3> triangle{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const char* const at =
                bytes.data() + k_header_size + t * k_triangle_size + k_normal_size + corner * k_corner_size;
            Eigen::Vector3d place;
            for (int k = 0; k < 3; ++k) place[k] = number_at<float>(at + 4 * k, std::endian::little);
            if (!place.allFinite())
                throw Error(ErrorCode::non_finite, std::string(name) + ": triangle " + std::to_string(t) +
                                                       " has a coordinate that is not finite");
            triangle[corner] = welded.vertex_at(place);
        }
        welded.add(triangle);
    }
    return welded.mesh();
}

/// Programs write the words of text STL in upper case, too.
std::string in_lower_case(std::string_view word) {
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

/// solid, then for each triangle: facet normal, outer loop, three times vertex, endloop, endfacet; at last endsolid.
class TextReader {
public:
    TextReader(std::string_view text, std::string_view name) : m_lines(text), m_name(name) {}

    Mesh read() {
        while (!m_lines.at_end()) {
            m_words = m_lines.take();
            const std::string_view given = take_word(m_words);
            const std::string word = in_lower_case(given.substr(0, k_longest_word + 1));
            if (word == "vertex") {
                read_corner();
            } else if (word == "endloop") {
                end_triangle();
            } else if (!word.empty() &&
                       std::find(k_passed_over.begin(), k_passed_over.end(), word) == k_passed_over.end()) {
                fail(ErrorCode::bad_syntax, quoted(given) + " is not a word of text STL");
            }
        }
        if (!m_corners.empty()) fail(ErrorCode::bad_syntax, "the file ends within a triangle");
        return m_welded.mesh();
    }

private:
    static constexpr std::array<std::string_view, 5> k_passed_over{"solid", "facet", "outer", "endfacet", "endsolid"};
    static constexpr std::size_t k_longest_word = 8;

    void read_corner() {
        Eigen::Vector3d place;
        for (double& coordinate : place) {
            const std::string_view word = take_word(m_words);
            if (word.empty()) fail(ErrorCode::bad_syntax, "a vertex needs three coordinates");
            coordinate = read_coordinate(word, m_name, m_lines.number());
        }
        m_corners.push_back(m_welded.vertex_at(place));
    }

    void end_triangle() {
        if (m_corners.size() != 3)
            fail(ErrorCode::bad_syntax,
                 "a triangle has three corners, this one has " + std::to_string(m_corners.size()));
        if (m_welded.triangle_count() == k_max_file_elements)
            fail(ErrorCode::too_large, "more than " + std::to_string(k_max_file_elements) + " triangles");
        m_welded.add({m_corners[0], m_corners[1], m_corners[2]});
        m_corners.clear();
    }

    [[noreturn]] void fail(ErrorCode code, const std::string& what) const {
        fail_at_line(code, m_name, m_lines.number(), what);
    }

    Lines m_lines;
    std::string_view m_name, m_words;
    std::vector<int> m_corners;
    Welded m_welded;
};

bool is_text(std::string_view bytes) {
    for (Lines lines(bytes); !lines.at_end();) {
        std::string_view line = lines.take();
        const std::string_view word = take_word(line);
        if (!word.empty()) return word.size() == 5 && in_lower_case(word) == "solid";
    }
    return false;
}

void check_range(const Positions& positions) {
    for (int v = 0; v < positions.cols(); ++v)
        if (!(positions.col(v).cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()))
            throw Error(ErrorCode::too_large,
                        "vertex " + std::to_string(v) + " has a coordinate that is too large for STL");
}

template <class Coordinates>
bool is_point(const Coordinates& coordinates, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    return coordinates.col(a) == coordinates.col(b) && coordinates.col(b) == coordinates.col(c);
}

/// Of a net that is very small, or very far from the origin beside its size, floats leave nothing: no triangle has more
/// than one place, though some had.
void check_precision(const Positions& positions, const std::vector<Triangle>& triangles) {
    const Eigen::Matrix3Xf written = positions.cast<float>();
    const auto is_left = [&](const Triangle& triangle) { return !is_point(written, triangle); };
    const auto was_more = [&](const Triangle& triangle) { return !is_point(positions, triangle); };
    if (std::any_of(triangles.begin(), triangles.end(), is_left)) return;
    const auto lost = std::find_if(triangles.begin(), triangles.end(), was_more);
    if (lost != triangles.end()) {
        const auto& [a, b, c] = *lost;
        throw Error(ErrorCode::bad_scale, "vertices " + std::to_string(a) + ", " + std::to_string(b) + " and " +
                                              std::to_string(c) +
                                              " become one in STL, as do those of all triangles: coordinates have 7 "
                                              "digits there, and none below 1e-45");
    }
}

/// `vector` with the length 1, however small it is; 0 remains 0.
Eigen::Vector3d direction_of(const Eigen::Vector3d& vector) {
    const double largest = vector.cwiseAbs().maxCoeff();
    return largest > 0 ? (vector / largest).normalized() : vector;
}

void append(std::string& bytes, const Eigen::Vector3d& vector) {
    for (const double coordinate : vector) append_little_endian(bytes, static_cast<float>(coordinate));
}

}  // namespace

bool is_stl(std::string_view bytes) { return is_binary(bytes) || is_text(bytes); }

Mesh read_stl(std::string_view bytes, std::string_view name) {
    if (is_binary(bytes)) return read_binary(bytes, name);
    if (is_text(bytes)) return TextReader(bytes, name).read();
    throw Error(ErrorCode::bad_syntax, std::string(name) + ": neither text STL, which begins with \"solid\", nor as " +
                                           "large as binary STL with its number of triangles");
}

std::string write_stl(const Positions& positions, const Faces& faces) {
    check_range(positions);
    const std::vector<Triangle> triangles = triangulated(positions, faces);
    check_precision(positions, triangles);
    // The first 80 bytes are free, but must not begin with "solid", as STL as text does.
    std::string bytes = "binary STL";
    bytes.resize(80, ' ');
    append_little_endian(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& triangle : triangles) {
        append(bytes, direction_of(area_vector(positions, triangle)));
        for (const int vertex : triangle) append(bytes, positions.col(vertex));
        append_little_endian(bytes, std::uint16_t{0});  // attributes: none
    }
    return bytes;
}

}  // namespace chebnet
