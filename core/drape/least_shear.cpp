#include "drape/least_shear.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"

namespace chebnet {

namespace {

constexpr double k_arm_trial_cells = 1000;
constexpr int k_most_rounds = 12, k_step_halvings = 4;
// A round that makes less than this part of the shear go is the last.
constexpr double k_least_gain = 0.003;
// Arms turn as evenly as over this part of the net's width.
constexpr double k_smooth = 0.05;
// Radians: smaller shear than this hardly counts in a fourth power.
constexpr double k_little = 0.1;
// Radians, on the average: a net is better from here on.
constexpr double k_better = 1e-3;
// How much worse a better net may be: radians at the worst cell, a part of the surface that is covered.
constexpr double k_shear_slack = std::numbers::pi / 360, k_cover_slack = 0.005;

struct Cell {
    int i, j;      // of its corner counted from, as in Drape::places
    double shear;  // the angle between the families less a right angle
    double area;
};

/// Of a net of quads, which begin at the corner with the least places.
std::vector<Cell> cells_of(const Drape& laid) {
    std::vector<Cell> cells;
    const Positions& x = laid.net.rest_positions();
    for (int f = 0; f < laid.net.face_count(); ++f) {
        const std::span<const int> face = laid.net.faces()[f];
        const Eigen::Vector3d along = x.col(face[2]) - x.col(face[0]), across = x.col(face[3]) - x.col(face[1]);
        // The diagonals of a rhombus halve its angles.
        const double shear = 2 * std::atan2(across.norm(), along.norm()) - std::numbers::pi / 2;
        cells.push_back({laid.places(0, face[0]), laid.places(1, face[0]), shear, along.cross(across).norm() / 2});
    }
    return cells;
}

/// Strips of cells side by side along an arm, numbered for all arms together. Turning left, an arm turns one family of
/// edges in a strip with it.
class Strips {
public:
    struct Place {
        int arm, step;
    };
    static Place of_first_family(const Cell& cell) { return cell.i < 0 ? Place{2, -1 - cell.i} : Place{0, cell.i}; }
    static Place of_second_family(const Cell& cell) { return cell.j < 0 ? Place{3, -1 - cell.j} : Place{1, cell.j}; }

    explicit Strips(const std::vector<Cell>& cells) {
        for (const Cell& cell : cells)
            for (const auto& [arm, step] : {of_first_family(cell), of_second_family(cell)})
                m_counts[arm] = std::max(m_counts[arm], step + 1);
        for (int arm = 1; arm < k_arms; ++arm) m_first[arm] = m_first[arm - 1] + m_counts[arm - 1];
    }

    int count(int arm) const { return m_counts[arm]; }
    int total() const { return m_first.back() + m_counts.back(); }
    int number(const Place& place) const { return m_first[place.arm] + place.step; }

private:
    std::array<int, k_arms> m_counts{}, m_first{};
};

BentArms mixed(const BentArms& from, const BentArms& to, double part) {
    BentArms mix = to;
    for (int arm = 0; arm < k_arms; ++arm)
        for (Eigen::Index k = 0; k < mix.turned[arm].size(); ++k) {
            double& turned = mix.turned[arm][k];
            turned = (1 - part) * from.at(arm, (static_cast<double>(k) + 0.5) * to.spacing) + part * turned;
        }
    return mix;
}

class Search {
public:
    /// `power` of shear whose sum is to be small.
    Search(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options, double power)
        : m_surface(surface), m_tree(tree), m_options(options), m_power(power) {
        m_options.length = std::max(options.length, std::sqrt(surface.area() / k_arm_trial_cells));
        m_options.border = DrapeOptions::Border::beyond;
        m_options.reach = static_cast<int>(std::min<double>(
            std::numeric_limits<int>::max(), std::ceil(options.reach * (options.length / m_options.length))));
    }

    BentArms run() const {
        std::optional<Trial> best = tried({});
        for (int round = 0; best && round < k_most_rounds; ++round) {
            std::optional<Trial> next = better_than(*best);
            if (!next) break;
            const double gain = best->sum - next->sum, enough = k_least_gain * best->shear_sum;
            best = std::move(next);
            if (gain < enough) break;
        }
        return best ? best->bent : BentArms{};
    }

private:
    struct Trial {
        BentArms bent;
        std::vector<Cell> cells;
        double shear_sum, sum;  // of the cells, and with what they do not cover
    };

    /// Nothing where no cell fits.
    std::optional<Trial> tried(BentArms bent) const {
        try {
            std::vector<Cell> cells = cells_of(drape_with(m_surface, m_tree, m_options, bent));
            double uncovered = m_surface.area(), sum = 0;
            for (const Cell& cell : cells) {
                uncovered -= cell.area;
                sum += weight(cell.shear) * (cell.shear * cell.shear + k_little * k_little);
            }
            const double most = std::numbers::pi / 2 - m_options.smallest_angle;
            const double missing = uncovered / (m_options.length * m_options.length) * std::pow(most, m_power);
            return Trial{std::move(bent), std::move(cells), sum, sum + missing};
        } catch (const Error&) {
            return std::nullopt;
        }
    }

    double weight(double shear) const { return std::pow(shear * shear + k_little * k_little, m_power / 2 - 1); }

    /// As far towards what fits as the sum gets smaller.
    std::optional<Trial> better_than(const Trial& best) const {
        const BentArms fit = fitted(best);
        for (double part = 1; part > std::pow(0.5, k_step_halvings); part /= 2) {
            std::optional<Trial> next = tried(mixed(best.bent, fit, part));
            if (next && next->sum < best.sum) return next;
        }
        return std::nullopt;
    }

    /// How far arms should have turned for the least Σ weight · shear², which each strip's turn changes by as much.
    BentArms fitted(const Trial& laid) const {
        const Strips strips(laid.cells);
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(strips.total(), strips.total());
        Eigen::VectorXd right = Eigen::VectorXd::Zero(strips.total());
        const auto add_square = [&](int a, int b, double difference, double weight) {
            matrix(a, a) += weight;
            matrix(b, b) += weight;
            matrix(a, b) -= weight;
            matrix(b, a) -= weight;
            right[a] += weight * difference;
            right[b] -= weight * difference;
        };
        const auto turned = [&](const Strips::Place& place) {
            return laid.bent.at(place.arm, (place.step + 0.5) * m_options.length);
        };
        double weights = 0;
        for (const Cell& cell : laid.cells) {
            const Strips::Place u = Strips::of_first_family(cell), v = Strips::of_second_family(cell);
            add_square(strips.number(u), strips.number(v), cell.shear + turned(u) - turned(v), weight(cell.shear));
            weights += weight(cell.shear);
        }
        const double width = std::sqrt(static_cast<double>(laid.cells.size()));
        const double stiffness = std::pow(k_smooth * width, 2) * weights / width;
        for (int arm = 0; arm < k_arms; ++arm)
            for (int step = 1; step < strips.count(arm); ++step)
                add_square(strips.number({arm, step - 1}), strips.number({arm, step}), 0, stiffness);
        // At the seed no direction may turn.
        for (int arm = 0; arm < k_arms; ++arm) {
            if (strips.count(arm) == 0) continue;
            const int first = strips.number({arm, 0});
            matrix.row(first).setZero();
            matrix.col(first).setZero();
            matrix(first, first) = 1;
            right[first] = 0;
        }
        const Eigen::VectorXd solution = matrix.ldlt().solve(right);
        BentArms fit{m_options.length};
        for (int arm = 0; arm < k_arms; ++arm)
            fit.turned[arm] = solution.segment(strips.number({arm, 0}), strips.count(arm));
        return fit;
    }

    const Surface& m_surface;
    const SurfaceTree& m_tree;
    DrapeOptions m_options;
    double m_power;
};

struct Quality {
    double mean = 0, largest = 0, coverage;

    Quality(const Surface& surface, const Drape& laid) : coverage(sampled_coverage(surface, laid.net)) {
        const std::vector<Cell> cells = cells_of(laid);
        for (const Cell& cell : cells) {
            mean += std::abs(cell.shear) / static_cast<double>(cells.size());
            largest = std::max(largest, std::abs(cell.shear));
        }
    }
    bool is_better_than(const Quality& other) const {
        return mean < other.mean - k_better && largest < other.largest + k_shear_slack &&
               coverage > other.coverage - k_cover_slack;
    }
};

}  // namespace

Drape least_shear_drape(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options) {
    const bool is_cut = options.border == DrapeOptions::Border::cut;
    DrapeOptions whole = options;
    if (is_cut) whole.border = DrapeOptions::Border::beyond;
    const auto finished = [&](Drape laid, const BentArms& bent, DrapeOptions::Arms arms) {
        if (is_cut) laid = drape_with(surface, tree, options, bent);
        laid.arms = arms;
        return laid;
    };
    Drape straight = drape_with(surface, tree, whole, {});
    const Quality enough(surface, straight);
    for (const double power : {4.0, 2.0}) {
        const BentArms bent = Search(surface, tree, options, power).run();
        try {
            Drape laid = drape_with(surface, tree, whole, bent);
            if (Quality(surface, laid).is_better_than(enough))
                return finished(std::move(laid), bent, DrapeOptions::Arms::least_shear);
        } catch (const Error&) {
            continue;  // no cell fits between arms that are bent so
        }
    }
    return finished(std::move(straight), {}, DrapeOptions::Arms::geodesic);
}

}  // namespace chebnet
