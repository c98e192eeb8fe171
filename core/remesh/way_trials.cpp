#include "remesh/way_trials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/stopwatch.h"
#include "drape/drape.h"
#include "drape/tilt.h"
#include "remesh/border_distance.h"
#include "remesh/border_sides.h"
#include "remesh/cones.h"
#include "remesh/creases.h"
#include "remesh/one_piece.h"
#include "remesh/prepared_surface.h"
#include "remesh/remesh_one_way.h"

namespace chebnet {

namespace {

// What cones leave, see Cones: more and more cells shear up to their limit, or cones come near the border.
constexpr double k_stretches[] = {0.12, 0.08};
// Ways are told apart by nets of so many cells, or of those asked for if they are no more.
constexpr int k_trial_cells = 1500;
// Only what is clearly better is worth another net, and survives rounding.
constexpr double k_clearly_less = 0.95;
// What counts against a net, where a mean distance of one edge from the surface counts 1: area that is not covered, of
// all; the mean distance of the borders, in edges; what the smallest corner lacks of an open one, in radians; how much
// cells are tilted against the surface, in radians, on average; the part of cells that are sheared much; borders of
// gaps and crumpled edges, by their length, where that of a net line across all of the net counts 1, and that there is
// a crumple at all. A net with less than k_good_cost in all needs no rival, one with less than k_fair_cost none with
// cones.
constexpr double k_gap_weight = 5, k_border_weight = 0.05, k_sharp_weight = 0.1, k_tilt_weight = 1;
constexpr double k_much_sheared_weight = 0.22, k_open_weight = 0.1, k_fold_weight = 1, k_crumpled_weight = 0.1;
constexpr double k_good_cost = 0.08, k_fair_cost = 0.12;
// A way is not tried to its end if edges err by more than this before a net is fitted (evened_error()), for that would
// be crumpled in hundreds of places; lines along the border, which leave no room for shear, if they err by less, and by
// still less where another way has come to a net with so little cost that any fold is worse.
constexpr double k_most_error = 0.2, k_most_error_along = 0.12, k_most_error_of_rivals = 0.04;
constexpr double k_cost_without_folds = 0.25;
constexpr double k_open_angle = 40 * std::numbers::pi / 180;

class WayTrials {
public:
    WayTrials(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, bool tries_creases,
              const RemeshProgress& progress)
        : m_guide(guide), m_options(options), m_progress(progress) {
        m_cells = cells_asked_for(guide->surface(), options);
        find_ways(tries_creases);
    }

    Remesh run() {
        for (std::size_t k = 0; k < m_ways.size(); ++k) {
            if (is_needless(m_ways[k])) continue;
            try_way(k);
            if (m_ways[k].stretch > 0) m_cone_count = cones(m_ways[k].stretch).size();
            if (k + 1 < m_rivals || !best()->is_good()) continue;
            finish(best());
            if (m_finished.is_good()) return std::move(*m_finished.made);
        }
        for (auto next = next_to_finish(); next != m_trials.end(); next = next_to_finish()) finish(next);
        if (!m_finished.made) std::rethrow_exception(m_failure);
        return std::move(*m_finished.made);
    }

private:
    using Border = RemeshOptions::Border;
    struct Way {
        std::optional<Border> border;  // none: in one piece
        double crease = 0;             // beside those that are asked for
        double stretch = 0;            // singular vertices are cones that leave as much; 0: as the field has them
    };
    // Each takes its time: more are made only where all so far are crumpled.
    static constexpr int k_most_finals = 2, k_most_finals_if_crumpled = 4;
    // With so many folds it is worth it to try what led to no net of few cells, or was given up.
    static constexpr int k_many_folds = 10;

    struct Trial {
        Way way{};
        std::optional<Remesh> made;
        int missed = std::numeric_limits<int>::max();
        double cost = std::numeric_limits<double>::infinity();
        int folds = std::numeric_limits<int>::max();  // edges at which it is crumpled
        bool is_uneven = false;                       // it was given up
        std::exception_ptr failure{};                 // why none was made

        bool is_good() const { return missed == 0 && cost <= k_good_cost; }
        auto rank() const { return std::tuple(missed, cost, !is_uneven); }
    };

    bool are_few() const { return m_cells <= k_trial_cells; }

    /// Some are tried in any case: each may be perfect where another is only good.
    void find_ways(bool tries_creases) {
        const Surface& surface = m_guide->surface();
        const bool fits_border = m_options.border == Border::fitting && has_border(surface);
        const Border usual = fits_border ? Border::always : m_options.border;
        if (fits_border) m_ways.push_back({std::nullopt});
        if (tries_creases) m_ways.push_back({usual, k_sharp_edge});
        m_ways.push_back({usual});
        if (fits_border && outer_border_sides(surface) != border_sides(surface)) m_ways.push_back({Border::outer});
        m_rivals = m_ways.size();
        if (!fits_border) return;
        m_ways.push_back({Border::across});
        if (is_free())
            for (const double stretch : k_stretches) m_ways.push_back({Border::never, 0, stretch});
        m_ways.push_back({Border::never});
    }

    /// Cones take the place of steps with the singular vertices of a field where they lead to a smooth net, and are not
    /// tried where another way leads to a fair one, or those before had as many.
    bool is_needless(const Way& way) {
        if (way.stretch > 0)
            return has_trial([](const Trial& trial) { return trial.folds == 0 && trial.cost < k_fair_cost; }) ||
                   cones(way.stretch).size() == m_cone_count;
        return way.border == Border::never &&
               has_trial([](const Trial& trial) { return trial.way.stretch > 0 && trial.folds == 0; });
    }

    template <typename Condition>
    bool has_trial(Condition condition) const {
        return std::any_of(m_trials.begin(), m_trials.end(), condition);
    }

    /// Of wishes that ask for singular vertices or lines.
    bool is_free() const {
        return m_options.singular.is_empty() && m_options.crease == 0 && m_options.marked_creases.empty();
    }

    void try_way(std::size_t k) {
        RemeshOptions options = m_options;
        options.fewest = false;
        if (!are_few()) {
            options.length = 0;
            options.cells = k_trial_cells;
        }
        double part = 0;  // phases may begin again
        const RemeshProgress progress = [&](RemeshPhase phase, double done) {
            const int first = static_cast<int>(RemeshPhase::triangles);
            part = std::max(part, (static_cast<int>(phase) - first + done) / (k_remesh_phases - first));
            if (m_progress) m_progress(RemeshPhase::border, (static_cast<double>(k) + part) / m_ways.size());
        };
        m_trials.push_back(made(m_ways[k], options, most_error(m_ways[k]), progress));
    }

    double most_error(const Way& way) const {
        if (way.border != Border::always && way.border != Border::outer) return k_most_error;
        const bool has_smooth =
            has_trial([](const Trial& trial) { return trial.missed == 0 && trial.cost < k_cost_without_folds; });
        return has_smooth ? k_most_error_of_rivals : k_most_error_along;
    }

    std::vector<Trial>::iterator best() {
        return std::min_element(m_trials.begin(), m_trials.end(),
                                [](const Trial& a, const Trial& b) { return a.rank() < b.rank(); });
    }

    /// More than came of another, whose trial had promised that: a larger net may crumple where a small one does not.
    bool promises_more(const Trial& trial) const {
        return trial.missed < m_finished.missed ||
               (trial.missed == m_finished.missed && trial.cost < k_clearly_less * m_finished.cost);
    }

    /// The best, or where what came of that is crumpled, the best of those that promise not to be. None if it is
    /// enough.
    std::vector<Trial>::iterator next_to_finish() {
        if (m_trials.empty()) return m_trials.end();
        if (!m_finished.made || (m_finals < k_most_finals && promises_more(*best()))) return best();
        auto smooth = m_trials.end(), failed = m_trials.end();
        if (m_finished.folds == 0 || m_tries >= k_most_finals_if_crumpled) return smooth;
        for (auto trial = m_trials.begin(); trial != m_trials.end(); ++trial) {
            const bool is_smooth = trial->folds == 0 && promises_more(*trial);
            if (is_smooth && (smooth == m_trials.end() || trial->rank() < smooth->rank())) smooth = trial;
            if (trial->is_uneven || (trial->failure && trial->way.border && !are_few())) failed = trial;
        }
        return smooth == m_trials.end() && m_finished.folds > k_many_folds ? failed : smooth;
    }

    /// As it is asked for, unless one is finished that is better.
    void finish(std::vector<Trial>::iterator place) {
        ++m_tries;
        Trial trial = std::move(*place);
        m_trials.erase(place);
        if (m_progress) m_progress(RemeshPhase::border, 1);
        const double milliseconds = m_watch.milliseconds();
        const bool is_done = trial.made && are_few() && !m_options.fewest;
        if (!is_done)
            trial = made(trial.way, m_options, std::numeric_limits<double>::infinity(), m_progress);
        else if (m_progress)
            m_progress(RemeshPhase::fit, 1);
        if (!trial.made) {
            if (!m_failure) m_failure = trial.failure;
            return;
        }
        ++m_finals;
        std::array<double, k_remesh_phases>& own = trial.made->milliseconds;
        own[static_cast<int>(RemeshPhase::border)] =
            is_done ? milliseconds - std::accumulate(own.begin(), own.end(), 0.0) : milliseconds;
        if (!m_finished.made || trial.rank() < m_finished.rank()) m_finished = std::move(trial);
    }

    /// Without a net where no such is found.
    Trial made(const Way& way, RemeshOptions options, double most_error, const RemeshProgress& progress) {
        Trial trial;
        trial.way = way;
        if (way.border) {
            options.border = *way.border;
            options.crease = std::max(options.crease, way.crease);
            try {
                if (way.stretch > 0) options.singular = {cones(way.stretch), {}, true};
                trial.made = remesh_if_even(m_guide, options, most_error, progress);
                trial.is_uneven = !trial.made;
                if (trial.made && way.stretch > 0) trial.made->kept = {};  // nobody has wished for them
            } catch (const Error&) {
                trial.failure = std::current_exception();
            }
        } else {
            trial.made = made_in_one_piece(options, progress);
        }
        if (trial.made) {
            trial.missed = trial.made->kept.missed();
            trial.folds = crumpled_edges(*m_guide, trial.made->net);
            trial.cost = cost(trial.made->net, trial.folds);
        }
        return trial;
    }

    /// Nothing where wishes ask for more than that.
    std::optional<Remesh> made_in_one_piece(const RemeshOptions& options, const RemeshProgress& progress) const {
        if (!is_free()) return std::nullopt;
        if (progress) progress(RemeshPhase::fit, 0);
        Stopwatch watch;
        std::optional<Net> net =
            one_piece(m_guide->surface(), m_guide->tree(), cells_asked_for(m_guide->surface(), options), options.length,
                      options.smallest_angle);
        if (!net) return std::nullopt;
        Remesh result{std::move(*net), {}, {}, 0, {}};
        result.milliseconds[static_cast<int>(RemeshPhase::fit)] = watch.milliseconds();
        return result;
    }

    std::vector<WishedSingular> cones(double stretch) {
        try {
            if (!m_cones) m_cones.emplace(m_guide->surface(), m_guide->tree());
            return m_cones->placed(stretch);
        } catch (const Error&) {  // what is too thin for even triangles
            return {};
        }
    }

    double cost(const Net& net, int folds) const {
        const DrapeReport report = measure_drape(m_guide->surface(), m_guide->tree(), net);
        const double distances = report.mean_distance + k_border_weight * border_distance(m_guide->surface(), net);
        const double lines = k_open_weight * report.open_border / report.length + k_fold_weight * folds;
        return k_gap_weight * (1 - report.coverage) + distances / report.length +
               k_sharp_weight * std::max(0.0, k_open_angle - report.smallest_angle) +
               k_tilt_weight * mean_tilt(*m_guide, net) + k_much_sheared_weight * report.much_sheared +
               lines / std::sqrt(net.face_count()) + (folds > 0 ? k_crumpled_weight : 0);
    }

    std::shared_ptr<const Guide> m_guide;
    RemeshOptions m_options;
    const RemeshProgress& m_progress;
    double m_cells;
    std::vector<Way> m_ways;
    std::optional<Cones> m_cones;  // once they are needed
    std::size_t m_cone_count = 0;  // of those tried last
    std::size_t m_rivals;          // so many of the first are tried at least
    Stopwatch m_watch;
    std::vector<Trial> m_trials;
    int m_tries = 0;               // to make nets as asked for
    int m_finals = 0;              // those made
    Trial m_finished;              // the best of those made as asked for
    std::exception_ptr m_failure;  // of the first that did not come about as asked for
};

}  // namespace

Remesh remesh_best_way(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, bool tries_creases,
                       const RemeshProgress& progress) {
    return WayTrials(guide, options, tries_creases, progress).run();
}

}  // namespace chebnet
