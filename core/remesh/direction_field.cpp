#include "remesh/direction_field.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <random>
#include <utility>

#include "remesh/border_sides.h"
#include "remesh/connection.h"
#include "surface/surface_tree.h"

namespace chebnet {

namespace {

using Complex = std::complex<double>;

// Of the boundary's direction, where an edge inside counts 1.
constexpr double k_boundary_weight = 1;
// The same where the singular vertices wished for do not allow a field along the boundary.
constexpr double k_unaligned_weight = 0.01;
// Of the way between two pinned vertices, at so many points; others than the nearest, but as near, are next to one,
// too.
constexpr double k_between_weight = 0.01, k_as_near = 1.15;
constexpr int k_held_points = 16;
// Added to the diagonal, relative to an edge: inverse iteration takes it off as many times as it is smaller than the
// eigenvalues.
constexpr double k_field_shift = 1e-5;
constexpr int k_iterations = 12;
// Rounds in which all directions are made of length 1 and diffused over about so many edges, squared.
constexpr int k_diffusions = 6;
constexpr double k_diffusion = 30;

/// Without the standard's care for infinities, which is a call into a library.
Complex times(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
Complex fourth_power(Complex z) { return times(times(z, z), times(z, z)); }
Complex unit(Complex z) {
    const double length = std::sqrt(z.real() * z.real() + z.imag() * z.imag());
    return length > 0 ? z / length : Complex(1);
}
/// Of a unit number, in the right half plane.
Complex square_root(Complex z) {
    const double real = std::sqrt(std::max(0.0, (1 + z.real()) / 2)),
                 imag = std::sqrt(std::max(0.0, (1 - z.real()) / 2));
    return {real, z.imag() < 0 ? -imag : imag};
}
Complex fourth_root(Complex z) { return square_root(square_root(z)); }

/// A plane with an x axis.
struct Frame {
    Eigen::Vector3d normal, x;

    Complex of(const Eigen::Vector3d& v) const { return {v.dot(x), v.dot(normal.cross(x))}; }
    Eigen::Vector3d direction(Complex z) const { return z.real() * x + z.imag() * normal.cross(x); }
};

Frame frame_of(const Eigen::Vector3d& normal) {
    int axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    const Eigen::Vector3d across = Eigen::Vector3d::Unit(axis);
    return {normal, (across - across.dot(normal) * normal).normalized()};
}

/// The number by which four directions in the one plane go over into the other, as that turns about the line that they
/// have in common.
Complex transport(const Frame& from, const Frame& to) {
    const double cosine = from.normal.dot(to.normal);
    const double part = cosine > -0.99 ? to.normal.dot(from.x) / (1 + cosine) : 0;
    return fourth_power(unit(to.of(from.x - part * (from.normal + to.normal))));
}

std::vector<Frame> vertex_frames(const Surface& surface, int smoothing, const std::function<void()>& go_on) {
    Positions normals = surface.vertex_normals();
    for (int round = 0; round < smoothing; ++round) {
        if (go_on) go_on();
        Positions next = normals;
        for (int s = 0; s < 3 * surface.face_count(); ++s) {
            next.col(surface.from(s)) += normals.col(surface.to(s));
            if (surface.opposite(s) < 0) next.col(surface.to(s)) += normals.col(surface.from(s));
        }
        for (int v = 0; v < next.cols(); ++v)
            if (next.col(v).norm() > 0.1) normals.col(v) = next.col(v).normalized();
    }
    std::vector<Frame> frames;
    frames.reserve(static_cast<std::size_t>(normals.cols()));
    for (int v = 0; v < normals.cols(); ++v)
        frames.push_back(
            frame_of(normals.col(v).norm() > 0.5 ? Eigen::Vector3d(normals.col(v)) : Eigen::Vector3d::UnitZ()));
    return frames;
}

/// How directions go from vertex to vertex, and along what they are held.
struct Connection {
    std::vector<Complex> transports;  // of each side, from its beginning to its end
    std::vector<Complex> targets;     // of each vertex the sum over its sides on the boundary and on creases
    std::vector<int> held_sides;      // of each vertex, how many there are
    std::vector<double> weights;      // of each vertex, of such a side
    std::vector<bool> is_pinned;      // of each vertex: directions turn around it, so its own is not one of theirs
};

/// Of each side, whether it is on the boundary and followed.
std::vector<bool> followed_border(const Surface& surface, const FieldOptions& options) {
    std::vector<bool> sides = border_sides(surface);
    for (std::size_t s = 0; s < options.border.size(); ++s) sides[s] = sides[s] && options.border[s];
    return sides;
}

Connection natural_connection(const Surface& surface, const std::vector<Frame>& frames,
                              const std::vector<bool>& followed, const FieldOptions& options) {
    Connection connection;
    connection.held_sides.assign(frames.size(), 0);
    connection.targets.assign(frames.size(), 0);
    connection.weights.assign(frames.size(), k_boundary_weight);
    connection.is_pinned.assign(frames.size(), false);
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        const int a = surface.from(s), b = surface.to(s);
        connection.transports.push_back(transport(frames[a], frames[b]));
        const bool is_border = followed[s];
        const bool is_crease = !options.creases.empty() && options.creases[s] && surface.opposite(s) < s;
        if (!is_border && !is_crease) continue;
        const double sign = is_border && options.crosses_border ? -1 : 1;  // i⁴ = 1, and of 45° (√i)⁴ = −1
        const Eigen::Vector3d along = surface.positions().col(b) - surface.positions().col(a);
        for (const int v : {a, b}) {
            connection.targets[v] += sign * fourth_power(unit(frames[v].of(along)));
            ++connection.held_sides[v];
        }
    }
    return connection;
}

double angle_of(Complex z) { return std::atan2(z.imag(), z.real()); }

/// Four times the area of the triangle of three unit vectors on the sphere (van Oosterom & Strackee 1983).
double curvature_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return 8 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// If there are to be no others, pinned vertices leave the field free to turn as a whole. It is to go straight from
/// each to those next to it, and so net lines join them.
void hold_between_pins(Connection& connection, const Surface& surface, const std::vector<Frame>& frames,
                       const PlacedWishes& wishes) {
    const SurfaceTree tree(surface);
    const auto at = [&](const PlacedWishes::Pin& pin) { return surface.positions().col(pin.vertex); };
    for (const PlacedWishes::Pin& from : wishes.pins) {
        double least = std::numeric_limits<double>::infinity();
        for (const PlacedWishes::Pin& to : wishes.pins)
            if (to.vertex != from.vertex) least = std::min(least, (at(to) - at(from)).norm());
        for (const PlacedWishes::Pin& to : wishes.pins) {
            const Eigen::Vector3d way = at(to) - at(from);
            if (to.vertex == from.vertex || way.norm() > k_as_near * least) continue;
            for (int k = 1; k < k_held_points; ++k) {
                const int face = tree.nearest(at(from) + k * way / k_held_points).at.face;
                for (const int v : surface.triangles().col(face))
                    connection.targets[v] += k_between_weight * fourth_power(unit(frames[v].of(way)));
            }
        }
    }
}

/// Turned so that singular vertices are where they are wished for. Returns the potential of what turns it.
Eigen::VectorXd turn(Connection& connection, const Surface& surface, const std::vector<Frame>& frames,
                     const std::vector<bool>& followed, const PlacedWishes& wishes) {
    std::vector<double> curvature, border(connection.transports.size(), 0.0);
    for (int f = 0; f < surface.face_count(); ++f) {
        const auto& corners = surface.triangles().col(f);
        curvature.push_back(
            curvature_of(frames[corners[0]].normal, frames[corners[1]].normal, frames[corners[2]].normal));
    }
    for (int s = 0; s < 3 * surface.face_count(); ++s)
        if (followed[s])
            border[s] =
                angle_of(times(connection.targets[surface.to(s)],
                               std::conj(times(connection.transports[s], connection.targets[surface.from(s)]))));
    TurnedConnection turned = turned_connection(surface, curvature, border, followed, wishes);
    for (int s = 0; s < 3 * surface.face_count(); ++s)
        connection.transports[s] =
            times(connection.transports[s], {std::cos(turned.angles[s]), std::sin(turned.angles[s])});
    for (int v = 0; v < surface.vertex_count(); ++v)
        if (turned.is_unaligned[v]) connection.weights[v] = k_unaligned_weight;
    for (const PlacedWishes::Pin& pin : wishes.pins) connection.is_pinned[pin.vertex] = true;
    if (wishes.only) hold_between_pins(connection, surface, frames, wishes);
    return std::move(turned.potential);
}

/// Σ over edges |z_to − r z_from|² + Σ over the boundary and creases |z − b|² as a real system, two rows for each
/// vertex.
class Smoother {
public:
    Smoother(const Surface& surface, const Connection& connection, bool has_targets)
        : m_size(2 * surface.vertex_count()) {
        std::vector<Eigen::Triplet<double>> entries;
        m_target.setZero(m_size);
        for (int v = 0; has_targets && v < surface.vertex_count(); ++v) {
            m_target[2 * v] = connection.weights[v] * connection.targets[v].real();
            m_target[2 * v + 1] = connection.weights[v] * connection.targets[v].imag();
            for (int k = 0; k < 2; ++k)
                entries.emplace_back(2 * v + k, 2 * v + k, connection.held_sides[v] * connection.weights[v]);
        }
        for (int s = 0; s < 3 * surface.face_count(); ++s) {
            const int a = surface.from(s), b = surface.to(s);
            if (surface.opposite(s) >= 0 && surface.opposite(s) < s) continue;
            for (const int v : {a, b})
                for (int k = 0; k < 2; ++k) entries.emplace_back(2 * v + k, 2 * v + k, 1);
            const Complex r = connection.transports[s];
            const double block[2][2] = {{-r.real(), r.imag()}, {-r.imag(), -r.real()}};
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    entries.emplace_back(2 * b + i, 2 * a + j, block[i][j]);
                    entries.emplace_back(2 * a + j, 2 * b + i, block[i][j]);
                }
        }
        m_matrix.resize(m_size, m_size);
        m_matrix.setFromTriplets(entries.begin(), entries.end());
    }

    std::vector<Complex> run() {
        m_has_boundary = m_target.squaredNorm() > 0;
        Eigen::VectorXd z(m_size);
        std::mt19937 random;  // any beginning that is the same everywhere
        for (double& number : z)
            number = static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5;
        factorize(k_field_shift);
        for (int k = 0; k < k_iterations; ++k) {
            z = m_factor.solve(m_has_boundary ? Eigen::VectorXd(m_target + k_field_shift * z) : z);
            z /= z.lpNorm<Eigen::Infinity>();
        }
        factorize(1 / k_diffusion);
        for (int k = 0; k < k_diffusions; ++k) {
            for (int v = 0; v < m_size / 2; ++v) {
                const Complex u = unit({z[2 * v], z[2 * v + 1]});
                z[2 * v] = u.real(), z[2 * v + 1] = u.imag();
            }
            z = m_factor.solve(Eigen::VectorXd(z / k_diffusion + m_target));  // not of z while it is overwritten
        }
        std::vector<Complex> result;
        result.reserve(static_cast<std::size_t>(m_size / 2));
        for (int v = 0; v < m_size / 2; ++v) result.push_back(unit({z[2 * v], z[2 * v + 1]}));
        return result;
    }

private:
    void factorize(double shift) {
        Eigen::SparseMatrix<double> shifted = m_matrix;
        for (int k = 0; k < m_size; ++k) shifted.coeffRef(k, k) += shift;
        m_factor.compute(shifted);
    }

    int m_size;
    bool m_has_boundary = false;
    Eigen::SparseMatrix<double> m_matrix;
    Eigen::VectorXd m_target;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;
};

Frame face_frame(const Surface& surface, int face) {
    const Eigen::Vector3d normal = surface.face_normals().col(face);
    if (normal.squaredNorm() < 0.5) return frame_of(Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d side =
        surface.positions().col(surface.to(3 * face)) - surface.positions().col(surface.from(3 * face));
    return {normal, side.normalized()};
}

/// The field in a triangle whose frame is given, of any length: what its corners have of it, but for pinned ones.
Complex field_in(const Surface& surface, int face, const Frame& frame, const std::vector<Frame>& frames,
                 const std::vector<bool>& is_pinned, const std::vector<Complex>& at_vertices) {
    Complex sum = 0;
    for (const int v : surface.triangles().col(face))
        if (!is_pinned[v]) sum += times(transport(frames[v], frame), at_vertices[v]);
    return sum;
}

/// Of each triangle of a function that has one value on each, by its means at the vertices.
Positions gradients(const Surface& surface, const Eigen::VectorXd& of_face) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(surface.vertex_count()), count = sum;
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        sum[surface.from(s)] += of_face[Surface::face_of(s)];
        count[surface.from(s)] += 1;
    }
    Positions result = Positions::Zero(3, surface.face_count());
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        const int f = Surface::face_of(s), opposite = surface.triangles()((s + 2) % 3, f);
        const Eigen::Vector3d along = surface.positions().col(surface.to(s)) - surface.positions().col(surface.from(s));
        result.col(f) += sum[opposite] / count[opposite] * surface.face_normals().col(f).cross(along);
    }
    return result;  // times twice the area of the triangle
}

/// The field of a flat connection may turn as a whole, piece by piece: to where it comes nearest to its targets. In the
/// solve itself targets that contradict each other would put singular vertices where none are wished for.
void turn_to_targets(std::vector<Complex>& at_vertices, const Surface& surface, const Connection& connection) {
    const std::vector<int> of_face = surface.components();
    std::vector<Complex> sums(1 + static_cast<std::size_t>(*std::max_element(of_face.begin(), of_face.end())));
    const auto piece_of = [&](std::size_t v) {
        return of_face[Surface::face_of(surface.first_side(static_cast<int>(v)))];
    };
    for (std::size_t v = 0; v < at_vertices.size(); ++v)
        sums[piece_of(v)] += connection.weights[v] * times(connection.targets[v], std::conj(at_vertices[v]));
    for (std::size_t v = 0; v < at_vertices.size(); ++v)
        at_vertices[v] = times(at_vertices[v], unit(sums[piece_of(v)]));
}

/// A field without singular vertices may turn as a whole. Its scale changes along the gradient of the potential, by
/// which nothing can make up in lines that run along or across it: their edges would have other lengths. At 45° to it
/// cells shear, and edges stay as they are: so a torus has a Chebyshev net.
void turn_as_a_whole(std::vector<Complex>& at_vertices, const Surface& surface, const std::vector<Frame>& frames,
                     const std::vector<bool>& is_pinned, const Eigen::VectorXd& potential) {
    const Positions gradient = gradients(surface, potential);
    Complex sum = 0;
    for (int f = 0; f < surface.face_count(); ++f) {
        const Frame frame = face_frame(surface, f);
        const Complex direction = field_in(surface, f, frame, frames, is_pinned, at_vertices);
        const Complex along = frame.of(gradient.col(f));
        sum -= std::norm(along) * times(fourth_power(unit(along)), std::conj(unit(direction)));
    }
    for (Complex& z : at_vertices) z = times(z, unit(sum));
}

/// The quarter turn of direction 0 beyond a side that comes nearest to direction 0 here, when both triangles are
/// unfolded.
int nearest_turn(const Surface& surface, const Positions& directions, int side) {
    const int f = Surface::face_of(side), g = Surface::face_of(surface.opposite(side));
    const Eigen::Vector3d along =
        (surface.positions().col(surface.to(side)) - surface.positions().col(surface.from(side))).normalized();
    const Complex here = Frame{surface.face_normals().col(f), along}.of(directions.col(f));
    const Complex there = Frame{surface.face_normals().col(g), along}.of(directions.col(g));
    const Complex turn = times(here, std::conj(there));
    if (std::abs(turn.real()) >= std::abs(turn.imag())) return turn.real() >= 0 ? 0 : 2;
    return turn.imag() >= 0 ? 1 : 3;
}

}  // namespace

DirectionField smoothest_field(const Surface& surface, const FieldOptions& options) {
    const std::vector<Frame> frames = vertex_frames(surface, options.smoothing, options.go_on);
    const std::vector<bool> followed = followed_border(surface, options);
    Connection connection = natural_connection(surface, frames, followed, options);
    Eigen::VectorXd potential;
    if (options.wishes) potential = turn(connection, surface, frames, followed, *options.wishes);
    const bool is_free = std::all_of(connection.targets.begin(), connection.targets.end(),
                                     [](Complex target) { return target == Complex(0); });
    const bool has_creases = std::find(options.creases.begin(), options.creases.end(), true) != options.creases.end();
    const bool is_flat = options.wishes && options.wishes->only && !has_creases;
    std::vector<Complex> at_vertices = Smoother(surface, connection, !is_flat).run();
    if (is_flat && is_free)
        turn_as_a_whole(at_vertices, surface, frames, connection.is_pinned, potential);
    else if (is_flat)
        turn_to_targets(at_vertices, surface, connection);
    DirectionField field;
    field.directions.resize(3, surface.face_count());
    for (int f = 0; f < surface.face_count(); ++f) {
        const Frame frame = face_frame(surface, f);
        const Complex direction = field_in(surface, f, frame, frames, connection.is_pinned, at_vertices);
        field.directions.col(f) = frame.direction(fourth_root(unit(direction)));
    }
    field.turns.assign(3 * static_cast<std::size_t>(surface.face_count()), 0);
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        const int other = surface.opposite(s);
        if (other < s) continue;
        field.turns[s] = nearest_turn(surface, field.directions, s);
        field.turns[other] = (4 - field.turns[s]) % 4;
    }
    field.holonomy.assign(static_cast<std::size_t>(surface.vertex_count()), 0);
    for (int s = 0; s < 3 * surface.face_count(); ++s)
        if (!surface.is_boundary(surface.from(s)) && surface.opposite(s) >= 0)
            field.holonomy[surface.from(s)] = (field.holonomy[surface.from(s)] + field.turns[surface.opposite(s)]) % 4;
    return field;
}

DirectionField turned(const Surface& surface, DirectionField field, double angle) {
    for (int f = 0; f < surface.face_count(); ++f) {
        const Eigen::Vector3d direction = field.directions.col(f), normal = surface.face_normals().col(f);
        field.directions.col(f) = std::cos(angle) * direction + std::sin(angle) * normal.cross(direction);
    }
    return field;
}

int singular_count(const DirectionField& field) {
    return static_cast<int>(
        std::count_if(field.holonomy.begin(), field.holonomy.end(), [](int turns) { return turns != 0; }));
}

}  // namespace chebnet
