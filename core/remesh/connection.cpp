#include "remesh/connection.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace chebnet {

namespace {

constexpr double k_turn = 2 * std::numbers::pi;
// Relative to a side: makes the matrix of a closed piece regular, whose right side adds up to 0.
constexpr double k_shift = 1e-9;
// Less of a turn than this is no reason to leave the boundary.
constexpr double k_least_remainder = std::numbers::pi / 2;
// A pinned vertex takes curvature from no more than such a part of the surface; what makes up for one that does not
// find enough is spread over such a part, as large as what belongs to each of eight on a sphere.
constexpr int k_taken_parts = 4, k_parts = 8;

/// Transport between a pinned vertex and its neighbours is turned so that no triangle at it has curvature, but for
/// whole turns: then it has a direction like any other vertex, and no other singular vertex comes there more easily
/// than elsewhere.
void smooth_at(const Surface& surface, int vertex, const std::vector<double>& density, std::vector<double>& angles) {
    double sum = 0;
    for (const int s : surface.sides_around(vertex)) {
        angles[s] += sum;
        angles[surface.opposite(s)] -= sum;
        sum += density[Surface::face_of(s)];
    }
}

/// What is changed of the curvature, triangle by triangle.
class Density {
public:
    Density(const Surface& surface, std::vector<double> curvature, const PlacedWishes& wishes)
        : m_surface(surface), m_wishes(wishes), m_density(std::move(curvature)) {
        m_is_free.reserve(m_density.size());
        for (const bool is_forbidden : wishes.is_forbidden) m_is_free.push_back(!is_forbidden && !wishes.only);
    }

    std::vector<double> run() {
        if (m_wishes.only) m_density.assign(m_density.size(), 0.0);
        std::vector<PlacedWishes::Pin> lacking;
        for (const PlacedWishes::Pin& pin : m_wishes.pins)
            if (!m_wishes.only && !take_near(pin)) lacking.push_back(pin);
        clear_forbidden();
        for (const PlacedWishes::Pin& pin : lacking) give_near(pin);
        for (const PlacedWishes::Pin& pin : m_wishes.pins) {
            const std::vector<int> star = m_surface.faces_around(pin.vertex);
            for (const int f : star) m_density[f] += k_turn * pin.index / static_cast<double>(star.size());
        }
        return m_density;
    }
    /// Whether what is left over may go there.
    const std::vector<bool>& is_free() const { return m_is_free; }

private:
    /// Triangles from `seeds` on across sides, these first, as long as `visit` says so.
    template <typename Visit>
    void walk(std::vector<int> queue, Visit visit) const {
        std::vector<bool> is_seen(m_density.size(), false);
        for (const int f : queue) is_seen[f] = true;
        for (std::size_t k = 0; k < queue.size(); ++k) {
            if (!visit(queue[k])) return;
            for (int s = 3 * queue[k]; s < 3 * queue[k] + 3; ++s) {
                const int other = m_surface.opposite(s);
                if (other < 0 || is_seen[Surface::face_of(other)]) continue;
                is_seen[Surface::face_of(other)] = true;
                queue.push_back(Surface::face_of(other));
            }
        }
    }

    /// Each region gives what it has to as many triangles around it.
    void clear_forbidden() {
        std::vector<bool> is_done(m_density.size(), false);
        for (int seed = 0; seed < m_surface.face_count(); ++seed) {
            if (is_done[seed] || !m_wishes.is_forbidden[seed]) continue;
            std::vector<int> region;
            walk_region(seed, is_done, region);
            double sum = 0;
            for (const int f : region) sum += std::exchange(m_density[f], 0.0);
            std::vector<int> around;
            walk(region, [&](int f) {
                if (m_is_free[f]) around.push_back(f);
                return around.size() < region.size();
            });
            for (const int f : around) m_density[f] += sum / static_cast<double>(around.size());
        }
    }

    void walk_region(int seed, std::vector<bool>& is_done, std::vector<int>& region) const {
        region.push_back(seed);
        is_done[seed] = true;
        for (std::size_t k = 0; k < region.size(); ++k)
            for (int s = 3 * region[k]; s < 3 * region[k] + 3; ++s) {
                const int other = m_surface.opposite(s);
                if (other < 0) continue;
                const int f = Surface::face_of(other);
                if (is_done[f] || !m_wishes.is_forbidden[f]) continue;
                is_done[f] = true;
                region.push_back(f);
            }
    }

    /// Triangles for a pinned vertex, of so many equal parts.
    std::size_t share(const PlacedWishes::Pin& pin, int parts) const {
        return m_density.size() * static_cast<std::size_t>(std::abs(pin.index)) / static_cast<std::size_t>(parts);
    }

    /// As much as it will have, from the nearest triangles; false if those that are near never have as much together.
    bool take_near(const PlacedWishes::Pin& pin) {
        const double wanted = k_turn * std::abs(pin.index), sign = pin.index > 0 ? 1 : -1;
        double sum = 0;
        std::vector<int> near;
        walk(m_surface.faces_around(pin.vertex), [&](int f) {
            sum += sign * m_density[f];
            near.push_back(f);
            return sum < wanted && near.size() < share(pin, k_taken_parts);
        });
        if (sum < wanted) return false;
        for (const int f : near) m_density[f] = 0;
        m_density[near.back()] = sign * (sum - wanted);
        return true;
    }

    /// What it will have, with the other sign: singular vertices that make up for it stand around it.
    void give_near(const PlacedWishes::Pin& pin) {
        const std::size_t enough = share(pin, k_parts);
        std::vector<int> near;
        walk(m_surface.faces_around(pin.vertex), [&](int f) {
            if (m_is_free[f]) near.push_back(f);
            return near.size() < enough;
        });
        for (const int f : near) m_density[f] -= k_turn * pin.index / static_cast<double>(near.size());
    }

    const Surface& m_surface;
    const PlacedWishes& m_wishes;
    std::vector<double> m_density;
    std::vector<bool> m_is_free;
};

/// What is added to the curvature of each triangle, piece by piece.
class Balance {
public:
    Balance(const Surface& surface, const std::vector<double>& curvature, const std::vector<double>& density,
            const std::vector<bool>& is_free, const std::vector<bool>& is_followed)
        : m_surface(surface), m_is_followed(is_followed), m_of_face(surface.components()) {
        const std::size_t pieces = 1 + static_cast<std::size_t>(*std::max_element(m_of_face.begin(), m_of_face.end()));
        m_is_open.assign(pieces, false);
        std::vector<bool> has_way_out(pieces, false);
        std::vector<double> remainder(pieces, 0), faces(pieces, 0), free(pieces, 0);
        change.resize(surface.face_count());
        for (int f = 0; f < surface.face_count(); ++f) {
            change[f] = density[f] - curvature[f];
            remainder[m_of_face[f]] += change[f];
            faces[m_of_face[f]] += 1;
            free[m_of_face[f]] += is_free[f] ? 1 : 0;
        }
        for (int s = 0; s < 3 * surface.face_count(); ++s) {
            const int piece = m_of_face[Surface::face_of(s)];
            if (surface.opposite(s) >= 0) continue;
            if (!is_followed[s]) has_way_out[piece] = true;
            if (free[piece] == 0 && std::abs(remainder[piece]) > k_least_remainder) m_is_open[piece] = true;
        }
        for (std::size_t piece = 0; piece < pieces; ++piece)  // then all the rest of its boundary can be followed
            if (has_way_out[piece]) m_is_open[piece] = false;
        for (int f = 0; f < surface.face_count(); ++f) {
            const int piece = m_of_face[f];
            if (m_is_open[piece] || has_way_out[piece]) continue;
            if (free[piece] == 0)
                change[f] -= remainder[piece] / faces[piece];
            else if (is_free[f])
                change[f] -= remainder[piece] / free[piece];
        }
    }

    Eigen::VectorXd change;
    /// Whether what is left over goes through this side, on the boundary.
    bool is_open(int side) const {
        return m_surface.opposite(side) < 0 && (!m_is_followed[side] || m_is_open[m_of_face[Surface::face_of(side)]]);
    }

private:
    const Surface& m_surface;
    const std::vector<bool>& m_is_followed;
    std::vector<int> m_of_face;
    std::vector<bool> m_is_open;  // of each piece
};

/// Δφ = change on the triangles.
Eigen::VectorXd potential(const Surface& surface, const Balance& balance) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        const int f = Surface::face_of(s), other = surface.opposite(s);
        if (other >= 0) entries.emplace_back(f, Surface::face_of(other), -1);
        if (other >= 0 || balance.is_open(s)) entries.emplace_back(f, f, 1);
    }
    for (int f = 0; f < surface.face_count(); ++f) entries.emplace_back(f, f, k_shift);
    Eigen::SparseMatrix<double> laplacian(surface.face_count(), surface.face_count());
    laplacian.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(balance.change);
}

}  // namespace

TurnedConnection turned_connection(const Surface& surface, std::vector<double> curvature,
                                   const std::vector<double>& border, const std::vector<bool>& is_followed,
                                   const PlacedWishes& wishes) {
    for (int s = 0; s < 3 * surface.face_count(); ++s) curvature[Surface::face_of(s)] += border[s];
    Density density(surface, curvature, wishes);
    const std::vector<double> wanted = density.run();
    const Balance balance(surface, curvature, wanted, density.is_free(), is_followed);
    TurnedConnection result;
    result.potential = potential(surface, balance);
    const Eigen::VectorXd& phi = result.potential;
    result.angles = border;
    result.is_unaligned.assign(static_cast<std::size_t>(surface.vertex_count()), false);
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        const int f = Surface::face_of(s), other = surface.opposite(s);
        if (other >= 0)
            result.angles[s] += phi[f] - phi[Surface::face_of(other)];
        else if (balance.is_open(s)) {
            result.angles[s] += phi[f];
            result.is_unaligned[surface.from(s)] = true;
        }
    }
    for (const PlacedWishes::Pin& pin : wishes.pins) smooth_at(surface, pin.vertex, wanted, result.angles);
    return result;
}

}  // namespace chebnet
