#include "io/off.h"

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "io/file.h"
#include "io/indexed_rows.h"

namespace chebnet {

namespace {

/// Goes to the next line that holds more than a comment; false at the end of the text.
bool take_statement(Lines& lines, std::string_view& statement) {
    while (!lines.at_end()) {
        statement = without_comment(lines.take());
        if (!std::all_of(statement.begin(), statement.end(), is_blank)) return true;
    }
    return false;
}

struct Keyword {
    bool found, three_dimensional;
};

/// Takes [ST][C][N][4][n]OFF off the front of a line. Some programs write the counts right behind it ("OFF8 6 12").
Keyword take_keyword(std::string_view& line) {
    std::string_view rest = line.substr(std::find_if_not(line.begin(), line.end(), is_blank) - line.begin());
    const auto take = [&rest](std::string_view prefix) {
        if (!rest.starts_with(prefix)) return false;
        rest.remove_prefix(prefix.size());
        return true;
    };
    for (const char* passed_over : {"ST", "C", "N"}) take(passed_over);
    const bool homogeneous = take("4"), any_dimension = take("n");
    if (!take("OFF")) return {false, true};
    line = rest;
    return {true, !homogeneous && !any_dimension};
}

class OffReader {
public:
    OffReader(std::string_view text, std::string_view name) : m_lines(text), m_name(name) {}

    Mesh read() {
        read_counts();
        for (int v = 0; v < m_vertex_count; ++v) {
            take_row(v, m_vertex_count, "vertices");
            read_vertex();
        }
        for (int f = 0; f < m_face_count; ++f) {
            take_row(f, m_face_count, "faces");
            read_face();
        }
        if (take_statement(m_lines, m_words))
            fail(ErrorCode::bad_syntax, "the file has more lines than its numbers of vertices and faces, " +
                                            std::to_string(m_vertex_count) + " and " + std::to_string(m_face_count) +
                                            ", declare");
        return {Eigen::Map<const Positions>(m_coordinates.data(), 3, m_vertex_count), std::move(m_faces)};
    }

private:
    void read_counts() {
        const std::string missing = "the file ends before its numbers of vertices and faces";
        if (!take_statement(m_lines, m_words)) fail(ErrorCode::bad_syntax, missing);
        const Keyword keyword = take_keyword(m_words);
        if (!keyword.three_dimensional)
            fail(ErrorCode::bad_syntax, "only OFF files with three coordinates a vertex are read");
        const bool only_keyword = std::all_of(m_words.begin(), m_words.end(), is_blank);
        if (only_keyword && !take_statement(m_lines, m_words)) fail(ErrorCode::bad_syntax, missing);
        m_vertex_count = read_count("vertices");
        m_face_count = read_count("faces");
    }

    int read_count(const std::string& what) {
        const std::string_view word = take_word(m_words);
        if (word == "BINARY") fail(ErrorCode::bad_syntax, "OFF is read as text only, this one is binary");
        const std::optional<std::int64_t> count = parse_count(word);
        if (!count) fail(ErrorCode::bad_syntax, quoted(word) + " is not a number of " + what);
        if (*count > k_max_file_elements)
            fail(ErrorCode::too_large, "more than " + std::to_string(k_max_file_elements) + " " + what);
        return static_cast<int>(*count);
    }

    void take_row(int row, int count, const std::string& what) {
        if (!take_statement(m_lines, m_words))
            fail(ErrorCode::bad_syntax, "the file ends after " + std::to_string(row) + " of the " +
                                            std::to_string(count) + " " + what + " it declares");
    }

    void read_vertex() {
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = take_word(m_words);
            if (word.empty())
                fail(ErrorCode::bad_syntax, "a vertex needs three coordinates, this one has " + std::to_string(axis));
            m_coordinates.push_back(read_coordinate(word, m_name, m_lines.number()));
        }
    }

    void read_face() {
        const std::string_view word = take_word(m_words);
        const std::optional<std::int64_t> size = parse_count(word);
        if (!size) fail(ErrorCode::bad_syntax, quoted(word) + " is not the number of vertices of a face");
        if (*size < 3)
            fail(ErrorCode::small_face, "a face needs at least three vertices, this one has " + std::to_string(*size));
        m_face.clear();
        for (std::int64_t corner = 0; corner < *size; ++corner) m_face.push_back(read_corner(*size));
        m_faces.add(m_face);
    }

    int read_corner(std::int64_t size) {
        const std::string_view word = take_word(m_words);
        if (word.empty())
            fail(ErrorCode::bad_syntax,
                 "a face of " + std::to_string(size) + " vertices names only " + std::to_string(m_face.size()));
        const std::optional<std::int64_t> vertex = parse_count(word);
        if (!vertex) fail(ErrorCode::bad_syntax, quoted(word) + " is not the number of a vertex, counted from 0");
        if (*vertex >= m_vertex_count)
            fail(ErrorCode::index_out_of_range, "a face names vertex " + std::to_string(*vertex) + ", but the " +
                                                    std::to_string(m_vertex_count) + " vertices are counted from 0");
        return static_cast<int>(*vertex);
    }

    [[noreturn]] void fail(ErrorCode code, const std::string& what) const {
        fail_at_line(code, m_name, std::max(1, m_lines.number()), what);
    }

    Lines m_lines;
    std::string_view m_name, m_words;
    int m_vertex_count = 0, m_face_count = 0;
    std::vector<double> m_coordinates;
    Faces m_faces;
    std::vector<int> m_face;
};

}  // namespace

bool is_off(std::string_view bytes) {
    Lines lines(bytes);
    std::string_view first;
    return take_statement(lines, first) && take_keyword(first).found;
}

Mesh read_off(std::string_view text, std::string_view name) { return OffReader(text, name).read(); }

std::string write_off(const Positions& positions, const Faces& faces) {
    return "OFF\n" + std::to_string(positions.cols()) + ' ' + std::to_string(faces.size()) + " 0\n" +
           indexed_rows(positions, faces);
}

}  // namespace chebnet
