#include "solve/parts/free_motions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "linear/ordered_dot.h"
#include "solve/parts/tangent_newton.h"

namespace chebnet {

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Motions that move what is held by less than the square root of this part of the net's size are free.
constexpr double k_unresisted = 1e-12;

}  // namespace

FreeMotions::FreeMotions(const Net& net, const Topology& topology, std::span<const int> fixed,
                         std::span<const Slide> slides)
    : m_piece_of_vertex(net.vertex_count()) {
    for (std::vector<int>& vertices : topology.components()) {
        for (int v : vertices) m_piece_of_vertex[v] = static_cast<int>(m_pieces.size());
        m_pieces.push_back({std::move(vertices), {}, {}});
    }
    for (int v : fixed) m_pieces[m_piece_of_vertex[v]].fixed.push_back(v);
    for (const Slide& slide : slides) m_pieces[m_piece_of_vertex[slide.vertex]].kept |= k_all_axes - slide.along;
}

void FreeMotions::set_forces(std::span<const Pull> pulls, const Options& options) {
    for (Piece& piece : m_pieces) piece.pulled.clear();
    for (const Pull& pull : pulls) m_pieces[m_piece_of_vertex[pull.vertex]].pulled.push_back(pull.vertex);
    m_kept_by_weight = options.gravity > 0 ? 1 << up_axis(options) : k_no_axes;
}

void FreeMotions::begin(const Positions& x) {
    m_motions.clear();
    for (const Piece& piece : m_pieces) find_motions(piece, x);
}

/// A motion is a shift a and a turn b about the piece's middle: vertex v moves by a + b × y, where y is its place from
/// there in parts of the piece's size, and so by (e; y × e)·(a; b) along an axis e.
void FreeMotions::find_motions(const Piece& piece, const Positions& x) {
    const Positions places = x(Eigen::all, piece.vertices);
    const Eigen::Vector3d middle = places.rowwise().mean();
    const double size = (places.colwise() - middle).colwise().norm().maxCoeff();
    if (!(size > 0)) return;
    const Axes kept = piece.kept | m_kept_by_weight;
    Matrix6d resistance = Matrix6d::Zero();
    const auto resist = [&](const Eigen::Vector3d& shift, const Eigen::Vector3d& turn) {
        Vector6d row;
        row << shift, turn;
        resistance += row * row.transpose();
    };
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i), none = Eigen::Vector3d::Zero();
        for (const std::vector<int>* held : {&piece.fixed, &piece.pulled})
            for (int v : *held) resist(axis, (x.col(v) - middle).cross(axis) / size);
        if (has_axis(kept, i)) resist(axis, none);
        // Only a turn about what is kept itself goes on keeping it.
        if ((kept & ~(1 << i)) != k_no_axes) resist(none, axis);
    }
    const Eigen::SelfAdjointEigenSolver<Matrix6d> modes(resistance);
    const std::size_t first = m_motions.size();
    for (int k = 0; k < 6 && modes.eigenvalues()[k] < k_unresisted; ++k) {
        const Eigen::Vector3d shift = modes.eigenvectors().col(k).head<3>(),
                              turn = modes.eigenvectors().col(k).tail<3>();
        Eigen::Matrix3Xd moves(3, places.cols());
        for (int i = 0; i < places.cols(); ++i) moves.col(i) = shift + turn.cross(places.col(i) - middle) / size;
        for (std::size_t before = first; before < m_motions.size(); ++before)
            moves -= ordered_dot(m_motions[before].moves, moves) * m_motions[before].moves;
        m_motions.push_back({&piece, moves / std::sqrt(ordered_dot(moves, moves))});
    }
}

void FreeMotions::take_out(Eigen::Matrix3Xd& vectors) const {
    for (const auto& [piece, moves] : m_motions) {
        const Eigen::Matrix3Xd before = vectors(Eigen::all, piece->vertices);
        vectors(Eigen::all, piece->vertices) -= ordered_dot(moves, before) * moves;
    }
}

void TangentNewton::find_free_motions(bool is_guided, std::span<const Pull> pulls, const Options& options) {
    m_is_free = !is_guided;
    if (is_guided) return;
    if (!m_free_motions) m_free_motions = std::make_shared<FreeMotions>(m_net, m_topology, m_fixed, m_slides);
    m_free_motions->set_forces(pulls, options);
}

}  // namespace chebnet
