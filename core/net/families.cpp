#include "net/families.h"

#include <algorithm>
#include <array>

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

}  // namespace

std::optional<std::vector<int>> edge_families(const Net& net) {
    const std::optional<std::vector<Quad>> quads = edges_of_quads(net);
    if (!quads) return std::nullopt;
    std::vector<std::vector<int>> quads_at(static_cast<std::size_t>(net.edge_count()));
    for (std::size_t q = 0; q < quads->size(); ++q)
        for (const int edge : (*quads)[q]) quads_at[edge].push_back(static_cast<int>(q));

    std::vector<int> families(quads_at.size(), -1);
    std::vector<int> known;  // edges whose quads are still to be looked at
    for (int first = 0; first < net.edge_count(); ++first) {
        if (families[first] >= 0) continue;
        families[first] = 0;
        known.push_back(first);
        while (!known.empty()) {
            const int edge = known.back();
            known.pop_back();
            for (const int q : quads_at[edge]) {
                const Quad& quad = (*quads)[q];
                const auto place = std::find(quad.begin(), quad.end(), edge) - quad.begin();
                for (int k = 1; k < 4; ++k) {
                    int& family = families[quad[(place + k) % 4]];
                    const int expected = (families[edge] + k) % 2;
                    if (family >= 0 && family != expected) return std::nullopt;
                    if (family < 0) known.push_back(quad[(place + k) % 4]);
                    family = expected;
                }
            }
        }
    }
    return families;
}

}  // namespace chebnet
