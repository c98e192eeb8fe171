#include "remesh/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "net/measures.h"
#include "net/topology.h"
#include "remesh/cell_mesh.h"
#include "remesh/cells.h"
#include "remesh/direction_field.h"
#include "remesh/even_triangles.h"
#include "remesh/fit.h"
#include "remesh/grid_map.h"

namespace chebnet {

namespace {

// Of the triangles' edges, in edge lengths of the net.
constexpr double k_triangle_length = 0.9;
// Edges of the net are longer than the cells of the grid by about this, for they are sheared.
constexpr double k_stretch = 1.05;
// One round of smoothing for so many vertices: so it reaches as far on the surface, however small the cells are.
constexpr double k_vertices_a_round = 600;
constexpr double k_most_smoothing = 100;
// Where a field leads to no net, others are tried, smoother and less smooth ones, then cells of other sizes.
constexpr double k_smoothings[] = {1, 0.3, 3};
constexpr double k_sizes[] = {1, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5};
constexpr double k_least_size_for_length = 0.9;
// So many nets with corners beyond the limit are enough.
constexpr int k_most_sharp_nets = 2;
// With more the grid takes too long, and would not be worth much.
constexpr int k_most_singular_vertices = 600;
constexpr double k_angle_tolerance = 1e-3;
constexpr int k_digits = 4;  // of coordinates in messages

int euler_characteristic(const Surface& surface) {
    int edges = 0;
    for (int s = 0; s < 3 * surface.face_count(); ++s) edges += surface.opposite(s) < s ? 1 : 0;
    return surface.vertex_count() - edges + surface.face_count();
}

int piece_count(const Surface& surface) {
    const std::vector<int> pieces = surface.components();
    return 1 + *std::max_element(pieces.begin(), pieces.end());
}

class Remesher {
public:
    Remesher(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, const RemeshProgress& progress)
        : m_guide(guide), m_surface(guide->surface()), m_options(options), m_progress(progress) {
        m_cell = options.length > 0 ? options.length / k_stretch : std::sqrt(m_surface.area() / options.cells);
    }

    Remesh run() {
        begin(RemeshPhase::triangles);
        m_triangles.emplace(even_triangles(m_surface, m_guide->tree(), k_triangle_length * m_cell));
        for (const double size : k_sizes)
            for (const double smoothing : k_smoothings)
                if (const auto net = try_once(size, smoothing * m_options.smoothing)) return result(*net);
        if (!m_sharp_nets.empty()) return result(m_sharp_nets.front());
        throw Error(ErrorCode::bad_option,
                    "cells of this size do not cover the surface; smaller ones may: " + m_first_failure);
    }

private:
    void begin(RemeshPhase phase) {
        end_phase();
        m_phase = phase;
        tell(0);
    }
    void end_phase() {
        m_milliseconds[static_cast<int>(m_phase)] += m_watch.milliseconds();
        m_watch.restart();
    }
    void tell(double done) const {
        if (m_progress) m_progress(m_phase, done);
    }

    /// Nothing where no net comes of it, or corners are beyond the limit.
    std::optional<Net> try_once(double size, double smoothing) {
        if (std::ssize(m_sharp_nets) == k_most_sharp_nets) return std::nullopt;
        if (m_options.length > 0 && size < k_least_size_for_length) return std::nullopt;
        try {
            Net net = attempt(size, smoothing);
            if (corner_angle_range(net, net.rest_positions()).smallest >= m_options.smallest_angle - k_angle_tolerance)
                return net;
            m_sharp_nets.push_back(std::move(net));
        } catch (const Error& error) {
            if (error.code() == ErrorCode::too_large) throw;
            if (m_first_failure.empty()) m_first_failure = error.what();
        }
        return std::nullopt;
    }

    Net attempt(double size, double smoothing) {
        begin(RemeshPhase::field);
        const int rounds = static_cast<int>(smoothing * m_triangles->vertex_count() / k_vertices_a_round);
        const DirectionField field = smoothest_field(*m_triangles, rounds);
        if (singular_count(field) > k_most_singular_vertices)
            throw Error(ErrorCode::bad_option, "the surface is so rough that directions on it have " +
                                                   std::to_string(singular_count(field)) + " singular vertices");
        begin(RemeshPhase::grid);
        const Mesh mesh = mesh_of(cells_of(*m_triangles, fit_grid(*m_triangles, field, size * m_cell)));
        check(mesh);
        begin(RemeshPhase::fit);
        return fit_net(m_guide, mesh, {m_options.length, m_options.smallest_angle},
                       [this](double done) { tell(done); });
    }

    /// It has to be of one piece where the surface is, and have no other holes and handles.
    void check(const Mesh& mesh) const {
        if (mesh.faces.size() == 0) throw Error(ErrorCode::bad_option, "no cell fits on the surface");
        for (int f = 0; f < mesh.faces.size(); ++f) {
            const std::span<const int> face = mesh.faces[f];
            if (face[0] == face[2] || face[1] == face[3] || face[0] == face[1] || face[2] == face[3])
                throw Error(
                    ErrorCode::bad_option,
                    "the surface is thinner than a cell near " +
                        row_text(std::span(mesh.positions.col(face[0] == face[2] ? face[0] : face[1]).data(), 3),
                                 k_digits));
        }
        const Net net(mesh.positions, mesh.faces, RestLengths::own);
        const int pieces = Topology(net).component_count();
        if (pieces != piece_count(m_surface))
            throw Error(ErrorCode::bad_option, "the net would have " + std::to_string(pieces) +
                                                   " pieces, the surface has " +
                                                   std::to_string(piece_count(m_surface)));
        const int characteristic = net.vertex_count() - net.edge_count() + net.face_count();
        if (characteristic != euler_characteristic(m_surface))
            throw Error(ErrorCode::bad_option,
                        "the surface is somewhere thinner or narrower than a cell, and the net would be "
                        "closed or torn there (its Euler characteristic would be " +
                            std::to_string(characteristic) + ", not " +
                            std::to_string(euler_characteristic(m_surface)) + ")");
    }

    Remesh result(Net net) {
        end_phase();
        return {std::move(net), m_milliseconds};
    }

    std::shared_ptr<const Guide> m_guide;
    const Surface& m_surface;
    RemeshOptions m_options;
    const RemeshProgress& m_progress;
    double m_cell;  // the length of the grid's cells
    std::optional<Surface> m_triangles;
    std::vector<Net> m_sharp_nets;
    std::string m_first_failure;
    RemeshPhase m_phase = RemeshPhase::triangles;
    Stopwatch m_watch;
    std::array<double, k_remesh_phases> m_milliseconds{};
};

}  // namespace

const char* to_string(RemeshPhase phase) {
    constexpr const char* k_names[] = {"triangles", "field", "grid", "fit"};
    return k_names[static_cast<int>(phase)];
}

void check_remesh(const Surface& surface, const RemeshOptions& options) {
    for (const double number : {options.length, options.smallest_angle, options.smoothing})
        if (!std::isfinite(number)) throw Error(ErrorCode::non_finite, "a number for the net is not finite");
    if (!(options.length >= 0)) throw Error(ErrorCode::bad_option, "the length of the edges must be positive");
    if (!(options.smoothing >= 0 && options.smoothing <= k_most_smoothing))
        throw Error(ErrorCode::bad_option, "the smoothing must be from 0 to 100");
    if (!(options.smallest_angle >= 0 && options.smallest_angle <= std::numbers::pi / 3))
        throw Error(ErrorCode::bad_option, "the shear limit must be from 0 to 60 degrees");
    if (!(surface.area() > 0)) throw Error(ErrorCode::bad_option, "the surface has no area");
    const double cells = options.length > 0 ? surface.area() / options.length / options.length : options.cells;
    if (!(cells >= k_least_remeshed_cells))
        throw Error(ErrorCode::bad_option, "a net of a whole surface has at least " +
                                               std::to_string(k_least_remeshed_cells) + " cells" +
                                               (options.length > 0 ? "; the edges are too long for this surface" : ""));
    if (!(cells <= k_most_remeshed_cells))
        throw Error(ErrorCode::too_large, "the net would have about " + number_text(cells, 3) + " cells; more than " +
                                              std::to_string(k_most_remeshed_cells) +
                                              " are not made of a whole surface");
}

Remesh remesh(const std::shared_ptr<const Guide>& surface, const RemeshOptions& options,
              const RemeshProgress& progress) {
    check_remesh(surface->surface(), options);
    return Remesher(surface, options, progress).run();
}

}  // namespace chebnet
