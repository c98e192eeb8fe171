#include "remesh/scraps.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "net/repair.h"

namespace chebnet {

namespace {

constexpr int k_most_scraps = 50;
// In cells: less than that is no net, and is none worth having where it was to be joined.
constexpr double k_scrap = 4, k_touching_scrap = 25;
// So many vertices in common would make an edge of both.
constexpr int k_touching_vertices = 2;

struct Fragment {
    double area = 0;
    int touching = 0;  // vertices that coincide with one of another piece
};

/// Of each vertex.
std::vector<int> piece_numbers(const Surface& surface, const std::vector<int>& of_faces) {
    std::vector<int> numbers(static_cast<std::size_t>(surface.vertex_count()));
    for (int v = 0; v < surface.vertex_count(); ++v) numbers[v] = of_faces[Surface::face_of(surface.first_side(v))];
    return numbers;
}

/// As repair finds them.
void count_touching(const Surface& surface, const std::vector<int>& numbers, std::vector<Fragment>& pieces) {
    Mesh mesh{surface.positions(), {}};
    for (const auto& t : surface.triangles().colwise()) mesh.faces.add({t[0], t[1], t[2]});
    const std::vector<int> place = repair(std::move(mesh), {Defect::duplicate_vertices}).new_vertex;
    std::vector<int> first(place.size(), -1);  // of the pieces at each place
    std::vector<bool> is_shared(place.size(), false);
    for (std::size_t v = 0; v < place.size(); ++v) {
        int& piece = first[place[v]];
        if (piece < 0) piece = numbers[v];
        if (piece != numbers[v]) is_shared[place[v]] = true;
    }
    for (std::size_t v = 0; v < place.size(); ++v) pieces[numbers[v]].touching += is_shared[place[v]] ? 1 : 0;
}

/// How many there are, if they are many and most of the surface.
template <class Which>
int many(const std::vector<Fragment>& pieces, double area, Which which) {
    int count = 0;
    double sum = 0;
    for (const Fragment& piece : pieces)
        if (which(piece)) ++count, sum += piece.area;
    return count > k_most_scraps && sum > area / 2 ? count : 0;
}

}  // namespace

void check_scraps(const Surface& surface, double cell) {
    const std::vector<int> of_faces = surface.components();
    std::vector<Fragment> pieces(static_cast<std::size_t>(*std::max_element(of_faces.begin(), of_faces.end())) + 1);
    for (int f = 0; f < surface.face_count(); ++f) pieces[of_faces[f]].area += surface.areas()[f];
    const auto is_small = [&](const Fragment& piece) { return piece.area < k_touching_scrap * cell; };
    if (many(pieces, surface.area(), is_small) == 0) return;
    count_touching(surface, piece_numbers(surface, of_faces), pieces);
    const int touching = many(pieces, surface.area(), [&](const Fragment& piece) {
        return is_small(piece) && piece.touching >= k_touching_vertices;
    });
    const std::string all = "the surface is in " + std::to_string(pieces.size()) + " pieces, ";
    if (touching > 0)
        throw Error(ErrorCode::too_large, all + std::to_string(touching) +
                                              " of which are small and touch others without being joined to them: "
                                              "repaired (--repair), vertices that coincide are merged");
    const int scraps = many(pieces, surface.area(), [&](const Fragment& piece) { return piece.area < k_scrap * cell; });
    if (scraps > 0)
        throw Error(ErrorCode::too_large, all + std::to_string(scraps) +
                                              " of which are smaller than four cells: smaller cells, or a surface "
                                              "without these, may do");
}

}  // namespace chebnet
