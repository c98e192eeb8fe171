#include "net/repair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/error.h"

namespace chebnet {

namespace {

using Side = std::pair<int, int>;

/// The edge from corner k of a face to the next, as the face walks along it.
Side side_of(std::span<const int> face, std::size_t k) { return {face[k], face[(k + 1) % face.size()]}; }

Side undirected(const Side& side) { return std::minmax(side.first, side.second); }

void check(const Mesh& mesh, double merge_tolerance) {
    if (!(merge_tolerance > 0) || !std::isfinite(merge_tolerance))
        throw Error(ErrorCode::bad_option, "the tolerance for merging vertices must be a number above 0");
    for (int v = 0; v < mesh.positions.cols(); ++v)
        if (!mesh.positions.col(v).allFinite())
            throw Error(ErrorCode::non_finite, "vertex " + std::to_string(v) + " has a coordinate that is not finite");
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (const int v : mesh.faces[f])
            if (v < 0 || v >= mesh.positions.cols())
                throw Error(ErrorCode::index_out_of_range, "face " + std::to_string(f) + " names vertex " +
                                                               std::to_string(v) + ", but there are only " +
                                                               std::to_string(mesh.positions.cols()));
}

/// `tolerance` times the mean edge length, bounded below so that coinciding vertices are always merged. 0 if no edge
/// has a length.
double merge_radius(const Mesh& mesh, double tolerance) {
    double sum = 0, count = 0;
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t k = 0; k < mesh.faces[f].size(); ++k) {
            const auto [a, b] = side_of(mesh.faces[f], k);
            sum += (mesh.positions.col(a) - mesh.positions.col(b)).stableNorm();
            ++count;
        }
    if (!std::isfinite(sum)) throw Error(ErrorCode::non_finite, "the edges are too long to be measured");
    using Limits = std::numeric_limits<double>;
    return sum > 0 ? std::clamp(tolerance * (sum / count), Limits::denorm_min(), Limits::max() / 8) : 0;
}

// ------------------------------------------------------------------------------------------------ duplicate vertices

/// A spatial hash of points, to find those near a place.
class PointGrid {
public:
    PointGrid(const Positions& positions, double radius) : m_positions(positions), m_radius(radius) {}

    void add(int vertex) {
        const auto slice = [&](int axis) { return slice_of(m_positions(axis, vertex)); };
        m_vertices.emplace(key_of(slice(0), slice(1), slice(2)), vertex);
    }

    /// The least of the vertices added so far that lie within the radius of `point`; nothing if there is none.
    std::optional<int> first_near(const Eigen::Vector3d& point) const {
        std::optional<int> first;
        const auto xs = slices_near(point.x()), ys = slices_near(point.y()), zs = slices_near(point.z());
        for (const double x : xs)
            for (const double y : ys)
                for (const double z : zs) {
                    const auto [begin, end] = m_vertices.equal_range(key_of(x, y, z));
                    for (auto entry = begin; entry != end; ++entry)
                        if ((m_positions.col(entry->second) - point).stableNorm() <= m_radius)
                            first = std::min(first.value_or(entry->second), entry->second);
                }
        return first;
    }

private:
    /// The slice of space in which a coordinate lies, by its number along the axis. Where doubles are farther apart
    /// than the radius each is a slice of its own: numbers of slices would overflow there, and all that is far fall
    /// into one.
    double slice_of(double coordinate) const {
        const double slice = std::floor(coordinate / (4 * m_radius));
        return std::abs(slice) < 0x1p53 ? slice : coordinate;
    }

    /// Slices are wider than twice the radius: a ball reaches into two at most.
    std::vector<double> slices_near(double coordinate) const {
        const double low = slice_of(coordinate - m_radius), high = slice_of(coordinate + m_radius);
        return low == high ? std::vector{low} : std::vector{low, high};
    }

    /// Cubes with the same key do no harm: distances are measured anyway.
    static std::uint64_t key_of(double x, double y, double z) {
        std::uint64_t key = 0;
        for (const double slice : {x, y, z}) {
            key = (key ^ std::hash<double>()(slice)) * 0x9E3779B97F4A7C15u;
            key ^= key >> 32;
        }
        return key;
    }

    const Positions& m_positions;
    double m_radius;
    std::unordered_multimap<std::uint64_t, int> m_vertices;
};

/// For each vertex the one it is merged into: itself, or an earlier one that is its own.
std::vector<int> merge_targets(const Positions& positions, double radius) {
    std::vector<int> targets(static_cast<std::size_t>(positions.cols()));
    std::iota(targets.begin(), targets.end(), 0);
    if (radius == 0) return targets;
    PointGrid kept(positions, radius);
    for (int& vertex : targets) {
        if (const auto earlier = kept.first_near(positions.col(vertex)))
            vertex = *earlier;
        else
            kept.add(vertex);
    }
    return targets;
}

std::vector<int> merged_vertices(const std::vector<int>& targets) {
    std::vector<int> merged;
    for (std::size_t v = 0; v < targets.size(); ++v)
        if (targets[v] != static_cast<int>(v)) merged.push_back(static_cast<int>(v));
    return merged;
}

// -------------------------------------------------------------------------------------------------------------- faces

/// The face with each run of one vertex shortened to one corner.
std::vector<int> without_repetitions(std::span<const int> face) {
    std::vector<int> corners;
    std::unique_copy(face.begin(), face.end(), std::back_inserter(corners));
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners;
}

bool is_sound(std::vector<int> face) {
    std::sort(face.begin(), face.end());
    return face.size() >= 3 && std::adjacent_find(face.begin(), face.end()) == face.end();
}

void turn_round(std::span<int> face) { std::reverse(face.begin() + 1, face.end()); }

/// The same for all faces with the same edges, wherever and in whichever direction they begin.
std::vector<int> canonical(std::span<const int> face) {
    std::vector<int> corners(face.begin(), face.end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (corners.size() > 2 && corners.back() < corners[1]) turn_round(corners);
    return corners;
}

std::vector<bool> duplicate_faces(const Faces& faces) {
    std::vector<bool> found;
    found.reserve(static_cast<std::size_t>(faces.size()));
    std::set<std::vector<int>> seen;
    for (int f = 0; f < faces.size(); ++f) found.push_back(!seen.insert(canonical(faces[f])).second);
    return found;
}

/// Faces at an edge that two earlier faces, not found themselves, have taken already.
std::vector<bool> extra_faces_at_edges(const Faces& faces) {
    std::vector<bool> found;
    std::map<Side, int> face_counts;
    for (int f = 0; f < faces.size(); ++f) {
        std::set<Side> sides;
        for (std::size_t k = 0; k < faces[f].size(); ++k) sides.insert(undirected(side_of(faces[f], k)));
        found.push_back(std::any_of(sides.begin(), sides.end(), [&](const Side& s) { return face_counts[s] == 2; }));
        if (!found.back())
            for (const Side& side : sides) ++face_counts[side];
    }
    return found;
}

// ------------------------------------------------------------------------------------------------------------ winding

/// A face across an edge, and whether both walk along that edge in the same direction.
struct Neighbour {
    int face;
    bool against;
};

/// For each face its neighbours across edges of two faces.
std::vector<std::vector<Neighbour>> neighbours_of_faces(const Faces& faces) {
    struct Use {
        Side edge;
        int face;
        bool ascending;
    };
    std::vector<Use> uses;
    for (int f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < faces[f].size(); ++k) {
            const Side side = side_of(faces[f], k);
            uses.push_back({undirected(side), f, side.first < side.second});
        }
    std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.edge < b.edge; });

    std::vector<std::vector<Neighbour>> neighbours(static_cast<std::size_t>(faces.size()));
    for (auto first = uses.begin(), next = first; first != uses.end(); first = next) {
        next = std::find_if(first, uses.end(), [&](const Use& use) { return use.edge != first->edge; });
        if (next - first != 2) continue;
        const bool against = first[0].ascending == first[1].ascending;
        neighbours[first[0].face].push_back({first[1].face, against});
        neighbours[first[1].face].push_back({first[0].face, against});
    }
    return neighbours;
}

/// Which faces to turn so that all of a piece agree, as few as possible; none of a piece with one side only.
class Winding {
public:
    explicit Winding(const Faces& faces)
        : m_neighbours(neighbours_of_faces(faces)), m_reached(m_neighbours.size()), m_turned(m_neighbours.size()) {
        for (int f = 0; f < faces.size(); ++f)
            if (!m_reached[f]) settle_piece(f);
    }
    const std::vector<bool>& turned() const { return m_turned; }
    bool has_one_side() const { return m_has_one_side; }

private:
    void settle_piece(int first) {
        const std::vector<int> piece = reach_piece(first);
        const auto is_turned = [this](int f) { return m_turned[f]; };
        const auto turned_count = std::count_if(piece.begin(), piece.end(), is_turned);
        const bool is_one_sided = !agrees(piece);
        m_has_one_side |= is_one_sided;
        if (is_one_sided)
            for (const int f : piece) m_turned[f] = false;
        else if (2 * turned_count > std::ssize(piece))
            for (const int f : piece) m_turned[f] = !m_turned[f];
    }

    /// The faces of the piece, each turned to agree with the one from which it was reached.
    std::vector<int> reach_piece(int first) {
        std::vector<int> piece{first};
        m_reached[first] = true;
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (const auto& [face, against] : m_neighbours[piece[i]]) {
                if (m_reached[face]) continue;
                m_reached[face] = true;
                m_turned[face] = m_turned[piece[i]] != against;
                piece.push_back(face);
            }
        return piece;
    }

    bool agrees(const std::vector<int>& piece) const {
        return std::all_of(piece.begin(), piece.end(), [this](int f) {
            return std::all_of(m_neighbours[f].begin(), m_neighbours[f].end(), [&](const Neighbour& neighbour) {
                return (m_turned[f] != m_turned[neighbour.face]) == neighbour.against;
            });
        });
    }

    std::vector<std::vector<Neighbour>> m_neighbours;
    std::vector<bool> m_reached, m_turned;
    bool m_has_one_side = false;
};

// ------------------------------------------------------------------------------------------------------------- repair

/// Of these vertices or faces, at least one.
Finding finding_of(Defect defect, bool repaired, std::vector<int> where) {
    constexpr std::size_t most_examples = 5;
    const int count = static_cast<int>(where.size());
    where.resize(std::min(where.size(), most_examples));
    return {defect, repaired, count, std::move(where)};
}

/// The mesh during repair. Vertices keep their numbers until the end, faces carry theirs along.
class Repairer {
public:
    Repairer(Mesh mesh, const std::vector<Defect>& chosen)
        : m_mesh(std::move(mesh)),
          m_chosen(chosen),
          m_face_numbers(static_cast<std::size_t>(m_mesh.faces.size())),
          m_is_dropped(static_cast<std::size_t>(m_mesh.positions.cols())) {
        std::iota(m_face_numbers.begin(), m_face_numbers.end(), 0);
    }

    RepairedMesh run(double merge_radius) {
        merge_duplicate_vertices(merge_radius);
        simplify_degenerate_faces();
        remove_faces(Defect::duplicate_faces, duplicate_faces(m_mesh.faces));
        remove_faces(Defect::non_manifold_edges, extra_faces_at_edges(m_mesh.faces));
        make_winding_consistent();
        drop_unused_vertices();
        return compacted();
    }

private:
    void merge_duplicate_vertices(double radius) {
        std::vector<int> targets = merge_targets(m_mesh.positions, radius);
        const bool repairing = report(Defect::duplicate_vertices, merged_vertices(targets));
        m_targets = std::move(targets);
        if (!repairing) std::iota(m_targets.begin(), m_targets.end(), 0);
        for (int& vertex : m_mesh.faces.vertices) vertex = m_targets[vertex];
    }

    void simplify_degenerate_faces() {
        std::vector<int> degenerate, numbers;
        Faces simplified;
        for (int f = 0; f < m_mesh.faces.size(); ++f) {
            const std::span<const int> face = m_mesh.faces[f];
            const std::vector<int> corners = without_repetitions(face);
            const bool sound = is_sound(corners);
            if (!sound || corners.size() < face.size()) degenerate.push_back(m_face_numbers[f]);
            if (!sound) continue;
            simplified.add(corners);
            numbers.push_back(m_face_numbers[f]);
        }
        if (report(Defect::degenerate_faces, degenerate)) replace_faces(std::move(simplified), std::move(numbers));
    }

    void remove_faces(Defect defect, const std::vector<bool>& found) {
        if (!report(defect, numbers_of(found))) return;
        std::vector<int> numbers;
        Faces kept;
        for (int f = 0; f < m_mesh.faces.size(); ++f) {
            if (found[f]) continue;
            kept.add(m_mesh.faces[f]);
            numbers.push_back(m_face_numbers[f]);
        }
        replace_faces(std::move(kept), std::move(numbers));
    }

    void make_winding_consistent() {
        const Winding winding(m_mesh.faces);
        if (!report(Defect::inconsistent_winding, numbers_of(winding.turned()))) return;
        for (int f = 0; f < m_mesh.faces.size(); ++f)
            if (winding.turned()[f])
                turn_round(std::span(m_mesh.faces.vertices).subspan(m_mesh.faces.start[f], m_mesh.faces[f].size()));
    }

    void drop_unused_vertices() {
        std::vector<bool> is_used(m_is_dropped.size());
        for (const int vertex : m_mesh.faces.vertices) is_used[vertex] = true;
        std::vector<int> unused;
        for (int v = 0; v < m_mesh.positions.cols(); ++v)
            if (!is_used[v] && m_targets[v] == v) unused.push_back(v);
        if (!report(Defect::unused_vertices, unused)) return;
        for (const int vertex : unused) m_is_dropped[vertex] = true;
    }

    RepairedMesh compacted() {
        std::vector<int> new_vertex;
        int count = 0;
        for (int v = 0; v < m_mesh.positions.cols(); ++v) {
            const bool stays = m_targets[v] == v && !m_is_dropped[v];
            if (stays) m_mesh.positions.col(count) = m_mesh.positions.col(v);
            new_vertex.push_back(stays ? count++ : m_targets[v] == v ? -1 : new_vertex[m_targets[v]]);
        }
        m_mesh.positions.conservativeResize(3, count);
        for (int& vertex : m_mesh.faces.vertices) vertex = new_vertex[vertex];
        return {std::move(m_mesh), std::move(new_vertex), std::move(m_findings)};
    }

    void replace_faces(Faces faces, std::vector<int> numbers) {
        m_mesh.faces = std::move(faces);
        m_face_numbers = std::move(numbers);
    }

    std::vector<int> numbers_of(const std::vector<bool>& found) const {
        std::vector<int> numbers;
        for (std::size_t f = 0; f < found.size(); ++f)
            if (found[f]) numbers.push_back(m_face_numbers[f]);
        return numbers;
    }

    /// Records a finding; true if there is something, and it is to be repaired.
    bool report(Defect defect, std::vector<int> where) {
        if (where.empty()) return false;
        const bool repairing = std::find(m_chosen.begin(), m_chosen.end(), defect) != m_chosen.end();
        m_findings.push_back(finding_of(defect, repairing, std::move(where)));
        return repairing;
    }

    Mesh m_mesh;
    const std::vector<Defect>& m_chosen;
    std::vector<int> m_targets;       // for each vertex the one it was merged into, itself if it was not
    std::vector<int> m_face_numbers;  // as given, of the faces that remain
    std::vector<bool> m_is_dropped;   // vertices
    std::vector<Finding> m_findings;
};

struct Words {
    const char *name, *one, *many, *what, *repair;
};

Words words_for(Defect defect) {
    switch (defect) {
        case Defect::duplicate_vertices:
            return {"duplicate_vertices", "vertex", "vertices", "at the place of an earlier one", "merged"};
        case Defect::degenerate_faces:
            return {"degenerate_faces", "face", "faces", "with coinciding corners", "simplified or removed"};
        case Defect::duplicate_faces:
            return {"duplicate_faces", "face", "faces", "with the edges of an earlier one", "removed"};
        case Defect::non_manifold_edges:
            return {"non_manifold_edges", "face", "faces", "third or later at an edge", "removed"};
        case Defect::inconsistent_winding:
            return {"inconsistent_winding", "face", "faces", "wound against the others", "turned round"};
        case Defect::unused_vertices:
            break;
    }
    return {"unused_vertices", "vertex", "vertices", "of no face", "dropped"};
}

}  // namespace

const char* to_string(Defect defect) { return words_for(defect).name; }

std::string to_sentence(const Finding& finding) {
    const Words words = words_for(finding.defect);
    std::string text =
        std::to_string(finding.count) + ' ' + (finding.count == 1 ? words.one : words.many) + ' ' + words.what;
    if (finding.repaired) text.append(", ").append(words.repair);
    for (std::size_t i = 0; i < finding.examples.size(); ++i)
        text += (i == 0 ? ": " : ", ") + std::to_string(finding.examples[i]);
    if (finding.count > std::ssize(finding.examples)) text += ", ...";
    return text;
}

RepairedMesh repair(Mesh mesh, const std::vector<Defect>& chosen, double merge_tolerance) {
    check(mesh, merge_tolerance);
    const double radius = merge_radius(mesh, merge_tolerance);
    return Repairer(std::move(mesh), chosen).run(radius);
}

std::optional<Finding> find_duplicate_vertices(const Mesh& mesh, double merge_tolerance) {
    check(mesh, merge_tolerance);
    std::vector<int> merged = merged_vertices(merge_targets(mesh.positions, merge_radius(mesh, merge_tolerance)));
    if (merged.empty()) return std::nullopt;
    return finding_of(Defect::duplicate_vertices, false, std::move(merged));
}

bool has_one_side(const Faces& faces) { return Winding(faces).has_one_side(); }

}  // namespace chebnet
