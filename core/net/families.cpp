#include "net/families.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "net/corner_edges.h"
#include "net/topology.h"

namespace chebnet {

namespace {

using Quad = std::array<int, 4>;  // its edges, one after another

/// None if a face is no quad.
std::optional<std::vector<Quad>> edges_of_quads(const Net& net) {
    for (int f = 0; f < net.face_count(); ++f)
        if (net.faces()[f].size() != 4) return std::nullopt;
    const std::vector<int> edges = corner_edges(net, Topology(net));
    std::vector<Quad> quads;
    for (std::size_t k = 0; k < edges.size(); k += 4)
        quads.push_back({edges[k], edges[k + 1], edges[k + 2], edges[k + 3]});
    return quads;
}

/// Edges of one piece each, the family of the piece's first edge being 0.
struct Pieces {
    std::vector<int> families, piece_of;  // of each edge
    int count = 0;
};

/// None if a piece has no two families.
std::optional<Pieces> pieces_with_families(const Net& net, const std::vector<Quad>& quads) {
    std::vector<std::vector<int>> quads_at(static_cast<std::size_t>(net.edge_count()));
    for (std::size_t q = 0; q < quads.size(); ++q)
        for (const int edge : quads[q]) quads_at[edge].push_back(static_cast<int>(q));

    Pieces pieces{std::vector<int>(quads_at.size(), -1), std::vector<int>(quads_at.size(), -1)};
    std::vector<int> known;  // edges whose quads are still to be looked at
    const auto set = [&](int edge, int family) {
        pieces.families[edge] = family;
        pieces.piece_of[edge] = pieces.count;
        known.push_back(edge);
    };
    for (int first = 0; first < net.edge_count(); ++first) {
        if (pieces.families[first] >= 0) continue;
        set(first, 0);
        while (!known.empty()) {
            const int edge = known.back();
            known.pop_back();
            for (const int q : quads_at[edge]) {
                const Quad& quad = quads[q];
                const auto place = std::find(quad.begin(), quad.end(), edge) - quad.begin();
                for (int k = 1; k < 4; ++k) {
                    const int other = quad[(place + k) % 4], expected = (pieces.families[edge] + k) % 2;
                    if (pieces.families[other] < 0) set(other, expected);
                    if (pieces.families[other] != expected) return std::nullopt;
                }
            }
        }
        ++pieces.count;
    }
    return pieces;
}

/// Of each piece the family that has the first and third sides of most of its quads; where neither has, of its first.
std::vector<int> families_of_first_sides(const Pieces& pieces, const std::vector<Quad>& quads) {
    std::vector<int> votes(static_cast<std::size_t>(pieces.count)), first(votes.size(), -1);
    for (const Quad& quad : quads) {
        const int piece = pieces.piece_of[quad[0]], family = pieces.families[quad[0]];
        votes[piece] += family == 0 ? -1 : 1;
        if (first[piece] < 0) first[piece] = family;
    }
    for (std::size_t piece = 0; piece < votes.size(); ++piece)
        if (votes[piece] != 0) first[piece] = votes[piece] > 0 ? 1 : 0;
    return first;
}

}  // namespace

std::optional<std::vector<int>> edge_families(const Net& net) {
    const std::optional<std::vector<Quad>> quads = edges_of_quads(net);
    if (!quads) return std::nullopt;
    std::optional<Pieces> pieces = pieces_with_families(net, *quads);
    if (!pieces) return std::nullopt;
    const std::vector<int> of_first_sides = families_of_first_sides(*pieces, *quads);
    for (std::size_t e = 0; e < pieces->families.size(); ++e)
        if (of_first_sides[pieces->piece_of[e]] != of_first_sides.front())
            pieces->families[e] = 1 - pieces->families[e];
    return std::move(pieces->families);
}

}  // namespace chebnet
