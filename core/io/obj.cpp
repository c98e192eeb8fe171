#include "io/obj.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "base/error.h"
#include "base/sets.h"
#include "base/text.h"
#include "io/file.h"

namespace chebnet {

namespace {

/// Takes what stands before the next slash off the front of `word`, and the slash.
std::string_view take_part(std::string_view& word) {
    const std::string_view part = word.substr(0, word.find('/'));
    word.remove_prefix(std::min(part.size() + 1, word.size()));
    return part;
}

/// The statements of an OBJ text: comments taken off, lines that a backslash continues joined.
class Statements {
public:
    explicit Statements(std::string_view text) : m_lines(text) {}

    /// Goes to the next statement; false at the end of the text.
    bool next() {
        if (m_lines.at_end()) return false;
        m_statement = take_line();
        m_line = m_lines.number();
        if (drop_backslash(m_statement)) join_continued_lines();
        return true;
    }
    std::string_view statement() const { return m_statement; }
    /// The line on which it begins, from 1.
    int line() const { return m_line; }

private:
    // Comments go before anything looks for a backslash: they may well end in one ("# C:\nets\").
    std::string_view take_line() { return without_comment(m_lines.take()); }

    static bool drop_backslash(std::string_view& line) {
        std::string_view trimmed = line;
        while (!trimmed.empty() && is_blank(trimmed.back())) trimmed.remove_suffix(1);
        if (trimmed.empty() || trimmed.back() != '\\') return false;
        trimmed.remove_suffix(1);
        line = trimmed;
        return true;
    }

    void join_continued_lines() {
        m_joined = m_statement;
        for (bool continued = true; continued && !m_lines.at_end();) {
            std::string_view line = take_line();
            continued = drop_backslash(line);
            m_joined.append(" ").append(line);
        }
        m_statement = m_joined;
    }

    Lines m_lines;
    std::string_view m_statement;
    std::string m_joined;
    int m_line = 0;
};

class ObjReader {
public:
    ObjReader(std::string_view text, std::string_view name) : m_statements(text), m_name(name) {}

    Mesh read() {
        while (m_statements.next()) {
            std::string_view words = m_statements.statement();
            const std::string_view keyword = take_word(words);
            if (keyword == "v") read_vertex(words);
            if (keyword == "f") read_face(words);
        }
        check_forward_indices();
        return {Eigen::Map<const Positions>(m_coordinates.data(), 3, vertex_count()), std::move(m_faces)};
    }

private:
    void read_vertex(std::string_view words) {
        if (vertex_count() == k_max_file_elements) fail_too_large("vertices");
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = take_word(words);
            if (word.empty())
                fail(ErrorCode::bad_syntax, "a vertex needs three coordinates, this one has " + std::to_string(axis));
            m_coordinates.push_back(read_coordinate(word, m_name, m_statements.line()));
        }
    }

    void read_face(std::string_view words) {
        if (m_faces.size() == k_max_file_elements) fail_too_large("faces");
        m_face.clear();
        for (auto word = take_word(words); !word.empty(); word = take_word(words)) m_face.push_back(read_corner(word));
        if (m_face.size() < 3)
            fail(ErrorCode::small_face,
                 "a face needs at least three vertices, this one has " + std::to_string(m_face.size()));
        m_faces.add(m_face);
        m_face_lines.push_back(m_statements.line());
    }

    /// The vertex, from 0, of a corner v, v/vt, v//vn or v/vt/vn. A positive number may refer forward.
    int read_corner(std::string_view corner) const {
        std::string_view rest = corner;
        const int number = read_index(take_part(rest), corner);
        for (int other = 0; other < 2 && !rest.empty(); ++other)
            if (const std::string_view part = take_part(rest); !part.empty()) read_index(part, corner);
        if (!rest.empty()) fail_corner(corner);

        if (number == 0) fail(ErrorCode::index_out_of_range, "a face names vertex 0, but vertices are counted from 1");
        if (number > 0) return number - 1;
        if (number < -vertex_count()) fail_no_such_vertex(number, m_statements.line(), "stand before it");
        return vertex_count() + number;
    }

    int read_index(std::string_view text, std::string_view corner) const {
        int index = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, index);
        if (error == std::errc::invalid_argument || stop != end) fail_corner(corner);
        if (error == std::errc::result_out_of_range)
            fail(ErrorCode::index_out_of_range, "the number in " + quoted(corner) + " is too large");
        return index;
    }

    void check_forward_indices() const {
        for (int f = 0; f < m_faces.size(); ++f)
            for (const int vertex : m_faces[f])
                if (vertex >= vertex_count()) fail_no_such_vertex(vertex + 1, m_face_lines[f], "are in the file");
    }

    int vertex_count() const { return static_cast<int>(m_coordinates.size() / 3); }

    [[noreturn]] void fail_corner(std::string_view corner) const {
        fail(ErrorCode::bad_syntax,
             quoted(corner) + " is not a corner of a face, which is written v, v/vt, v//vn or v/vt/vn");
    }
    [[noreturn]] void fail_no_such_vertex(int number, int line, const std::string& where) const {
        fail(ErrorCode::index_out_of_range, line,
             "a face names vertex " + std::to_string(number) + ", but " + std::to_string(vertex_count()) +
                 " vertices " + where);
    }
    [[noreturn]] void fail_too_large(const std::string& what) const {
        fail(ErrorCode::too_large, "more than " + std::to_string(k_max_file_elements) + " " + what);
    }
    [[noreturn]] void fail(ErrorCode code, const std::string& what) const { fail(code, m_statements.line(), what); }
    [[noreturn]] void fail(ErrorCode code, int line, const std::string& what) const {
        fail_at_line(code, m_name, line, what);
    }

    Statements m_statements;
    std::string_view m_name;
    std::vector<double> m_coordinates;
    Faces m_faces;
    std::vector<int> m_face;
    std::vector<int> m_face_lines;
};

/// Of each face the number of the piece that it is in, which shares no vertex with another; by their first faces.
std::vector<int> pieces_of_faces(const Faces& faces, int vertex_count) {
    Sets joined(vertex_count);
    for (int f = 0; f < faces.size(); ++f)
        for (const int vertex : faces[f]) joined.join(faces[f].front(), vertex);
    std::vector<int> number(static_cast<std::size_t>(vertex_count), -1), piece;
    int count = 0;
    for (int f = 0; f < faces.size(); ++f) {
        int& known = number[joined.of(faces[f].front())];
        if (known < 0) known = count++;
        piece.push_back(known);
    }
    return piece;
}

}  // namespace

Mesh read_obj(std::string_view text, std::string_view name) {
    if (text.size() > k_max_file_bytes)
        throw Error(ErrorCode::too_large, std::string(name) + ":1: the text is larger than 1 GiB");
    return ObjReader(text, name).read();
}

std::string write_obj(const Positions& positions, const Faces& faces, int digits) {
    if (digits < 1 || digits > 17)
        throw Error(ErrorCode::bad_option, "OBJ is written with 1 to 17 digits, not " + std::to_string(digits));
    std::string out;
    for (const auto& p : positions.colwise()) out += "v " + row_text({p.data(), 3}, digits) + '\n';
    const std::vector<int> piece = pieces_of_faces(faces, static_cast<int>(positions.cols()));
    const bool has_pieces = std::any_of(piece.begin(), piece.end(), [](int p) { return p > 0; });
    for (int f = 0; f < faces.size(); ++f) {
        if (has_pieces && (f == 0 || piece[f] != piece[f - 1])) out += "g piece_" + std::to_string(piece[f] + 1) + '\n';
        out += 'f';
        for (const int vertex : faces[f]) out += ' ' + std::to_string(vertex + 1);
        out += '\n';
    }
    return out;
}

}  // namespace chebnet
