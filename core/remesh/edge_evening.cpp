#include "remesh/edge_evening.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "remesh/vector_length.h"
#include "surface/height.h"

namespace chebnet {

namespace {

// Lengths are reckoned in L. To even out the edges vertices are held on the surface, so that the lengths are found by
// shear, which costs nothing but the straightness of net lines.
constexpr double k_hold = 100, k_stiffness = 1;
constexpr double k_border = 0.05;  // of the distance of borders, where that from the surface counts 1
constexpr int k_least_steps = 4, k_trial_steps = 10;
// What lengths may err by so that lines need no kinks: about the corners of a cube, which are tips, they do not.
constexpr double k_even = 0.01;
// No vertex moves farther in one step.
constexpr double k_most_move = 0.4;
// Corners are kept open by more than the limit, in diagonals, so that they are in the end.
constexpr double k_diagonal_margin = 0.02;

}  // namespace

EdgeEvening::EdgeEvening(const Guide& guide, const Net& mesh, const Topology& topology, const FitOptions& options,
                         const Rails& rails, Rods rods)
    : m_guide(guide),
      m_mesh(mesh),
      m_topology(topology),
      m_options(options),
      m_rails(rails),
      m_evening(evening_for(rods)),
      m_length(options.length > 0 ? options.length : mesh.mean_length()),
      m_positions(mesh.rest_positions()),
      m_guess(static_cast<std::size_t>(mesh.vertex_count()), -1),
      m_pulls(options.pulls) {
    m_pulls.insert(m_pulls.end(), rails.corners.begin(), rails.corners.end());
    find_bars();
    find_bends();
    m_system = std::make_unique<SingleBlockSystem>(mesh.vertex_count(), links());
}

/// With rods as they are laid, what lengths still err by will be folded away, and corners have to be open at once.
EdgeEvening::Evening EdgeEvening::evening_for(Rods rods) {
    if (rods == Rods::straight) return {0.02, 70, -1, 1, 0.99, 0, 1, 5e-4};
    return {0.005, 40, 15, 5, 0.98, 8 * std::numbers::pi / 180, 2, 1e-4};
}

void EdgeEvening::find_bars() {
    for (int e = 0; e < m_mesh.edge_count(); ++e)
        m_edges.push_back(
            {m_mesh.edges()(0, e), m_mesh.edges()(1, e), link(m_mesh.edges()(0, e), m_mesh.edges()(1, e))});
    for (int f = 0; f < m_mesh.face_count(); ++f)
        for (int k = 0; k < 2; ++k) {
            const int a = m_mesh.faces()[f][k], b = m_mesh.faces()[f][k + 2];
            m_diagonals.push_back({a, b, link(a, b)});
        }
}

/// Three flat quads around a vertex have angles of 120 degrees there. On either side of a line from it the quads have
/// parallel edges all along, so that a line that crosses it is bent by 60 degrees: such kinks cannot be evened out.
void EdgeEvening::find_bends() {
    const std::vector<std::vector<int>> lines = m_topology.net_lines();
    const auto is_from_singular = [&](const std::vector<int>& line) { return m_topology.is_singular(line.front()); };
    std::vector<int> from_singular(static_cast<std::size_t>(m_mesh.vertex_count()), 0);  // so many lines
    for (const std::vector<int>& line : lines)
        if (is_from_singular(line))
            for (std::size_t k = 1; k + 1 < line.size(); ++k) ++from_singular[line[k]];
    for (const std::vector<int>& line : lines) {
        const int own = is_from_singular(line) ? 1 : 0;
        const auto is_kink = [&](int v) { return from_singular[v] > own; };
        for (std::size_t k = 0; k + 2 < line.size(); ++k)
            add_bend(line[k], line[k + 1], line[k + 2], is_kink(line[k + 1]));
        if (m_topology.is_closed(line) && line.size() > 3)
            add_bend(line[line.size() - 2], line.front(), line[1], is_kink(line.front()));
    }
}

void EdgeEvening::add_bend(int a, int b, int c, bool is_kink) {
    if (a != c) m_bends.push_back({a, b, c, link(a, b), link(b, c), link(a, c), is_kink});
}

int EdgeEvening::link(int a, int b) {
    return m_links.emplace(std::pair(std::min(a, b), std::max(a, b)), static_cast<int>(m_links.size())).first->second;
}

Eigen::Matrix2Xi EdgeEvening::links() const {
    Eigen::Matrix2Xi result(2, static_cast<Eigen::Index>(m_links.size()));
    for (const auto& [pair, number] : m_links) result.col(number) << pair.first, pair.second;
    return result;
}

void EdgeEvening::run(const std::function<void(double)>& go_on) { run(m_evening.most_steps, go_on); }

void EdgeEvening::try_out(const std::function<void(double)>& go_on) { run(k_trial_steps, go_on); }

void EdgeEvening::run(int most_steps, const std::function<void(double)>& go_on) {
    const int last = m_evening.last_steps;
    std::vector<double> errors;
    for (int k = 0; k < most_steps; ++k) {
        go_on(static_cast<double>(k) / most_steps);
        if (m_options.length == 0) m_length = fitting_length();
        errors.push_back(length_error());
        if (k == m_evening.straight_steps) m_has_kinks = errors[k] > k_even;
        const int least = std::max({k_least_steps, last, m_evening.straight_steps + (m_has_kinks ? last : 0)});
        if (k >= least && errors[k] > m_evening.least_gain * errors[k - last]) return;
        step();
    }
}

double EdgeEvening::length_error() const {
    double sum = 0;
    for (const Bar& edge : m_edges) {
        const double error = length_of(vector(edge)) - 1;
        sum += error * error;
    }
    return std::sqrt(sum / m_mesh.edge_count());
}

/// With edges of this length the quads, sheared as they are, have the area of the surface.
double EdgeEvening::fitting_length() const {
    double area = 0;
    for (int f = 0; f < m_mesh.face_count(); ++f) {
        const std::span<const int> face = m_mesh.faces()[f];
        for (std::size_t k = 0; k < 4; ++k) {
            const Eigen::Vector3d a = m_positions.col(face[(k + 1) % 4]) - m_positions.col(face[k]);
            const Eigen::Vector3d b = m_positions.col(face[(k + 3) % 4]) - m_positions.col(face[k]);
            area += length_of(a.cross(b)) / std::max(length_of(a) * length_of(b), 1e-300) / 4;
        }
    }
    return std::sqrt(m_guide.surface().area() / std::max(area, 1.0));
}

Eigen::Vector3d EdgeEvening::vector(const Bar& bar) const {
    return (m_positions.col(bar.a) - m_positions.col(bar.b)) / m_length;
}

/// A Gauss–Newton step of Σ hold · (distance to the surface)² + straightness + stiffness · (lengths, sharp
/// corners).
void EdgeEvening::step() {
    m_system->set_zero();
    m_force.setZero(3, m_positions.cols());
    draw_to_surface();
    for (const Rail* rail : {&m_rails.border, &m_rails.steps, &m_rails.creases}) draw_to(*rail);
    draw_to_points();
    for (const Bend& bend : m_bends)
        if (!(bend.is_kink && m_has_kinks)) straighten(bend);
    for (const Bar& edge : m_edges) pull(edge, 1, 1);
    const double open = m_options.smallest_angle + m_evening.open;
    const double shortest = 2 * std::sin(open / 2) + k_diagonal_margin;
    for (const Bar& diagonal : m_diagonals)
        if (length_of(vector(diagonal)) < shortest) pull(diagonal, shortest, m_evening.limit_stiffness);
    if (!m_system->factorize()) return;
    const Eigen::Matrix3Xd moves = m_system->solve(m_force);
    for (int v = 0; v < m_positions.cols(); ++v) {
        const double way = length_of(moves.col(v));
        m_positions.col(v) += m_length * std::min(1.0, k_most_move / std::max(way, 1e-300)) * moves.col(v);
    }
}

void EdgeEvening::draw_to_surface() {
    for (int v = 0; v < m_positions.cols(); ++v) {
        if (m_guess[v] < 0) m_guess[v] = m_guide.tree().nearest(m_positions.col(v)).at.face;
        const Height height = height_of(m_guide.surface(), m_guide.tree(), m_positions.col(v), m_guess[v]);
        m_guess[v] = height.at.face;
        const Eigen::Vector3d normal = height.normal;
        m_system->add_at_node(v,
                              k_hold * normal * normal.transpose() + m_evening.inertia * Eigen::Matrix3d::Identity());
        m_force.col(v) -= k_hold * height.height / m_length * normal;
    }
}

void EdgeEvening::draw_to(const Rail& rail) {
    for (const int v : rail.vertices) {
        const auto [away, along] = way_from(rail, m_positions.col(v));
        const double weight = k_border * k_hold;
        m_system->add_at_node(v, weight * (Eigen::Matrix3d::Identity() - along * along.transpose()));
        m_force.col(v) -= weight / m_length * (away - away.dot(along) * along);
    }
}

void EdgeEvening::draw_to_points() {
    for (const Pull& pull : m_pulls) {
        m_system->add_at_node(pull.vertex, pull.weight * Eigen::Matrix3d::Identity());
        m_force.col(pull.vertex) -= pull.weight / m_length * (m_positions.col(pull.vertex) - pull.target);
    }
}

void EdgeEvening::straighten(const Bend& bend) {
    const double straight = m_evening.straight;
    const Eigen::Matrix3d form = straight * Eigen::Matrix3d::Identity();
    m_system->add_at_link(bend.link_ab, 2 * form);
    m_system->add_at_link(bend.link_bc, 2 * form);
    m_system->add_at_link(bend.link_ac, -form);
    const Eigen::Vector3d difference =
        straight / m_length * (m_positions.col(bend.a) - 2 * m_positions.col(bend.b) + m_positions.col(bend.c));
    m_force.col(bend.a) -= difference;
    m_force.col(bend.b) += 2 * difference;
    m_force.col(bend.c) -= difference;
}

/// A spring between two vertices, as stiff across as it is stretched.
void EdgeEvening::pull(const Bar& bar, double rest, double weight) {
    const Eigen::Vector3d d = vector(bar);
    const double length = std::max(length_of(d), 1e-3);
    const Eigen::Vector3d along = d / length;
    const double across = std::max(0.0, 1 - rest / length);
    const Eigen::Matrix3d form = (1 - across) * (along * along.transpose()) + across * Eigen::Matrix3d::Identity();
    m_system->add_at_link(bar.link, weight * k_stiffness * form);
    const Eigen::Vector3d force = weight * k_stiffness * (length - rest) * along;
    m_force.col(bar.a) -= force;
    m_force.col(bar.b) += force;
}

}  // namespace chebnet
