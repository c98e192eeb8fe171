#include "solve/parts/free_motions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "linear/ordered_dot.h"
#include "solve/parts/handle_walk.h"
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
    m_count = 0;
    for (const Piece& piece : m_pieces) find_motions(piece, x);
}

/// A motion is a shift a and a turn b about the piece's middle: vertex v moves by a + b × y, where y is its place from
/// there in parts of the piece's size, and so by (e; y × e)·(a; b) along an axis e.
void FreeMotions::find_motions(const Piece& piece, const Positions& x) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int v : piece.vertices) middle += x.col(v) / static_cast<double>(piece.vertices.size());
    double size = 0;
    for (int v : piece.vertices) size = std::max(size, (x.col(v) - middle).norm());
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
    const std::size_t first = m_count;
    for (int k = 0; k < 6 && modes.eigenvalues()[k] < k_unresisted; ++k) {
        const Eigen::Vector3d shift = modes.eigenvectors().col(k).head<3>(),
                              turn = modes.eigenvectors().col(k).tail<3>();
        if (m_count == m_motions.size()) m_motions.emplace_back();
        Motion& motion = m_motions[m_count++];
        motion.piece = &piece;
        motion.moves.resize(3, static_cast<Eigen::Index>(piece.vertices.size()));
        for (int i = 0; i < motion.moves.cols(); ++i)
            motion.moves.col(i) = shift + turn.cross(x.col(piece.vertices[i]) - middle) / size;
        for (std::size_t before = first; before + 1 < m_count; ++before)
            motion.moves -= ordered_dot(m_motions[before].moves, motion.moves) * m_motions[before].moves;
        motion.moves /= std::sqrt(ordered_dot(motion.moves, motion.moves));
    }
}

void FreeMotions::take_out(Eigen::Matrix3Xd& vectors) const {
    for (std::size_t k = 0; k < m_count; ++k) {
        const auto& [piece, moves] = m_motions[k];
        double part = 0;
        for (int i = 0; i < moves.cols(); ++i)
            part += ordered_dot(Eigen::Vector3d(moves.col(i)), Eigen::Vector3d(vectors.col(piece->vertices[i])));
        for (int i = 0; i < moves.cols(); ++i) vectors.col(piece->vertices[i]) -= part * moves.col(i);
    }
}

void HandleWalk::carry_along(const std::vector<int>& piece, const Eigen::VectorXd& is_held, const Positions& from,
                             Positions& to) {
    Eigen::Vector3d moves = Eigen::Vector3d::Zero();
    double held = 0;
    for (int v : piece) {
        held += is_held[v];
        moves += to.col(v) - from.col(v);  // of what is held, so far
    }
    for (int v : piece)
        if (held > 0 && is_held[v] == 0) to.col(v) += moves / held;
}

void TangentNewton::find_free_motions(bool is_guided, std::span<const Pull> pulls, const Options& options) {
    m_is_free = !is_guided;
    if (is_guided) return;
    if (!m_free_motions) m_free_motions = std::make_shared<FreeMotions>(m_net, m_topology, m_fixed, m_slides);
    m_free_motions->set_forces(pulls, options);
}

}  // namespace chebnet
