// What the parts of a solver do where vertices slide. Nets for which none does need nothing of it.

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "linear/ordered_dot.h"
#include "solve/parts/coordinate_metric.h"
#include "solve/parts/length_system.h"
#include "solve/parts/neighbour_system.h"
#include "solve/slide.h"

namespace chebnet {

namespace {

// An edge that lies so much across where its ends slide, by the square of its sine, cannot change.
constexpr double k_least_part = 1e-8;

bool moves_in(const Slide& slide, Axes coordinates) { return (slide.along & coordinates) != k_no_axes; }

/// Null where everything that is free is so in these coordinates.
std::unique_ptr<const FreePart> part_without_what_is_kept(const Net& net, const FreePart& part,
                                                          std::span<const Slide> slides, Axes coordinates) {
    const auto moves = [&](const Slide& slide) { return moves_in(slide, coordinates); };
    if (std::all_of(slides.begin(), slides.end(), moves)) return nullptr;
    std::vector<bool> is_free(static_cast<std::size_t>(net.vertex_count()), false);
    for (int v : part.vertices()) is_free[v] = true;
    for (const Slide& slide : slides) is_free[slide.vertex] = moves_in(slide, coordinates);
    return std::make_unique<const FreePart>(net, is_free);
}

}  // namespace

void check_slide(int vertex, Axes along, bool is_exact) {
    const std::string handle = "handle " + std::to_string(vertex);
    if (along <= k_no_axes || along >= k_all_axes)
        throw Error(ErrorCode::bad_option, handle + " may slide along one or two of x, y and z");
    if (!is_exact) throw Error(ErrorCode::bad_option, handle + " is soft: only exact handles slide");
}

void LengthSystem::set_slides(std::span<const Slide> slides) {
    m_rows_that_slide.clear();
    m_couplings_that_slide.clear();
    m_kept.assign(m_weight.size(), k_no_axes);
    for (const Slide& slide : slides) m_kept[slide.vertex] = k_all_axes - slide.along;
    for (int row = 0; row < row_count(); ++row)
        if (m_kept[m_rows[row].vertex_a] != k_no_axes || m_kept[m_rows[row].vertex_b] != k_no_axes)
            m_rows_that_slide.push_back(row);
    for (std::size_t k = 0; k < m_couplings.size(); ++k)
        if (m_kept[m_couplings[k].vertex] != k_no_axes) m_couplings_that_slide.push_back(static_cast<int>(k));
}

/// The system has been assembled as if what slides were free.
void LengthSystem::take_off_what_is_kept() {
    const auto kept = [this](int vertex, int row_a, int row_b) {
        const Axes moving = k_all_axes - m_kept[vertex];
        return m_weight[vertex] *
               ordered_dot(across(moving, m_jacobian.col(row_a)), across(moving, m_jacobian.col(row_b)));
    };
    for (int row : m_rows_that_slide) {
        const auto& [a, b, distance, unit] = m_rows[row];
        if (!m_is_on[row] || !(m_weight[a] + m_weight[b] > 0)) continue;
        const double largest = m_diagonal[row][0];
        m_diagonal[row][0] -= kept(a, row, row) + kept(b, row, row);
        if (m_diagonal[row][0] > k_least_part * largest) continue;
        // It lies across where its ends slide, and cannot change.
        m_diagonal[row][0] = largest;
        m_errors[row] = 0;
    }
    for (int k : m_couplings_that_slide) {
        const auto& [a, b, vertex, sign] = m_couplings[k];
        m_off_diagonal[k][0] -= sign * kept(vertex, a, b);
    }
}

void LengthSystem::add_pull_beside_what_is_kept(const Eigen::VectorXd& y, Eigen::Matrix3Xd& moves) const {
    for (int row = 0; row < row_count(); ++row) {
        const int a = m_rows[row].vertex_a, b = m_rows[row].vertex_b;
        const Eigen::Vector3d pull = y[row] * m_jacobian.col(row);
        moves.col(a) += m_weight[a] * across(m_kept[a], pull);
        moves.col(b) -= m_weight[b] * across(m_kept[b], pull);
    }
}

void NeighbourSystem::hold(std::span<const Slide> slides) {
    std::vector<Axes> moving(m_node_blocks.size(), k_all_axes);
    for (const Slide& slide : slides) {
        const int node = m_part.node_of(slide.vertex);
        moving[node] = slide.along;
        for (int k = 0; k < 3; ++k) {
            if (has_axis(slide.along, k)) continue;
            m_node_blocks[node].row(k).setZero();
            m_node_blocks[node].col(k).setZero();
            m_node_blocks[node](k, k) = 1;
        }
    }
    for (std::size_t pair = 0; pair < m_pairs.size(); ++pair) {
        if (m_link_of_pair[pair] < 0) continue;
        int row = m_part.node_of(m_pairs[pair][0]), column = m_part.node_of(m_pairs[pair][1]);
        if (m_factor.rank()[row] < m_factor.rank()[column]) std::swap(row, column);
        Eigen::Matrix3d& block = m_link_blocks[m_link_of_pair[pair]];
        for (int k = 0; k < 3; ++k) {
            if (!has_axis(moving[row], k)) block.row(k).setZero();
            if (!has_axis(moving[column], k)) block.col(k).setZero();
        }
    }
}

std::vector<std::unique_ptr<CoordinateMetric>> metrics_by_coordinate(const Net& net, const NeighbourPairs& pairs,
                                                                     const FreePart& part,
                                                                     std::span<const Slide> slides) {
    std::vector<std::unique_ptr<CoordinateMetric>> metrics;
    Axes left = k_all_axes;
    for (int k = 0; k < 3; ++k) {
        if (!has_axis(left, k)) continue;
        const auto alike = [&](int other) {
            return std::all_of(slides.begin(), slides.end(),
                               [&](const Slide& s) { return has_axis(s.along, k) == has_axis(s.along, other); });
        };
        Axes coordinates = k_no_axes;
        for (int other = k; other < 3; ++other)
            if (alike(other)) coordinates += 1 << other;
        left &= ~coordinates;
        const auto kept =
            std::count_if(slides.begin(), slides.end(), [&](const Slide& s) { return !has_axis(s.along, k); });
        if (kept < part.size())
            metrics.push_back(std::make_unique<CoordinateMetric>(
                pairs, part, coordinates, part_without_what_is_kept(net, part, slides, coordinates)));
    }
    return metrics;
}

}  // namespace chebnet
