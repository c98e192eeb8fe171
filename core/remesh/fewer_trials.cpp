#include "remesh/fewer_trials.h"

#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "drape/drape.h"
#include "drape/tilt.h"
#include "net/measures.h"
#include "remesh/fewer_singular.h"

namespace chebnet {

namespace {

// How far a net with fewer singular vertices may be away from the surface for it, in edges, on average; one without any
// that is not asked for.
constexpr double k_fewest_distance = 0.2, k_none_distance = 0.1;
// Nor may its cells be tilted more against the surface than this, in radians, or, where that surface is rough, by this
// factor more than those of such a net with the usual singular vertices: it would be crumpled.
constexpr double k_smooth_tilt = 10 * std::numbers::pi / 180, k_most_tilted = 1.1;

class FewerTrials {
public:
    using Pins = std::vector<PlacedWishes::Pin>;

    FewerTrials(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, QuadMesher& mesher,
                NetTrials& trials, PhaseClock& clock)
        : m_guide(guide),
          m_options(options),
          m_mesher(mesher),
          m_trials(trials),
          m_clock(clock),
          m_usual(mesher.wishes()) {}

    /// Over a border that is one of the net's lines none goes: it would have a corner there.
    std::optional<TriedNet> run() {
        if (!m_mesher.creases().sides.empty() || !(m_options.fewest || may_have_none())) return std::nullopt;
        m_clock.begin(RemeshPhase::singular);
        const DirectionField field = m_mesher.field_along(m_options.smoothing);
        if (singular_count(field) > k_most_singular_vertices) return std::nullopt;
        const Surface& triangles = m_mesher.triangles();
        const std::vector<Pins> wishes = fewer_and_fewer(triangles, field, m_mesher.held_border(triangles));
        if (wishes.size() == 1 || !(m_options.fewest || wishes.back().empty())) return std::nullopt;
        std::optional<TriedNet> found;
        for (int k = last_good(wishes); k > 0 && !found; k = m_options.fewest ? k / 2 : 0) {
            if (!m_mesher.wish_alone(wishes[k])) continue;
            found = m_trials.good();
            if (found && !is_smooth(found->net)) found.reset();
        }
        m_mesher.set_wishes(m_usual);
        return found;
    }

private:
    bool may_have_none() const {
        return (m_mesher.has_border() || m_guide->surface().euler_characteristic() == 0) &&
               m_options.singular.is_empty();
    }

    /// The last of the wishes for which a small net is good enough. With `fewest` it is found by halves, as if all
    /// before it were so, too; else it is the last of them or none.
    int last_good(const std::vector<Pins>& wishes) {
        int good = 0, bad = static_cast<int>(wishes.size());
        for (int k = bad - 1; good + 1 < bad; k = (good + bad) / 2) {
            m_clock.stand_at(1 - static_cast<double>(bad - good) / static_cast<double>(wishes.size() + 1));
            (is_good_enough(wishes[k]) ? good : bad) = k;
            if (!m_options.fewest) break;
        }
        m_clock.go_on();
        return good;
    }

    bool is_good_enough(const Pins& wishes) {
        if (!m_mesher.wish_alone(wishes)) return false;
        const std::optional<Net> net = m_trials.small();
        if (!net) return false;
        const DrapeReport report = measure_drape(m_guide->surface(), m_guide->tree(), *net);
        const double farthest = m_options.fewest ? k_fewest_distance : k_none_distance;
        if (report.smallest_angle < m_options.smallest_angle - k_limit_tolerance ||
            report.mean_distance > farthest * report.length)
            return false;
        return is_smooth(*net);
    }

    bool is_smooth(const Net& net) {
        const double tilt = mean_tilt(*m_guide, net);
        if (tilt <= k_smooth_tilt) return true;
        if (!m_usual_tilt) m_usual_tilt = usual_tilt();  // which takes as long as all before
        return tilt <= k_most_tilted * *m_usual_tilt;
    }

    /// Of a small net with the usual singular vertices; infinite if there is none.
    double usual_tilt() {
        const std::optional<PlacedWishes> present = m_mesher.wishes();
        m_mesher.set_wishes(m_usual);
        const std::optional<Net> net = m_trials.small();
        m_mesher.set_wishes(present);
        return net ? mean_tilt(*m_guide, *net) : std::numeric_limits<double>::infinity();
    }

    const std::shared_ptr<const Guide>& m_guide;
    const RemeshOptions& m_options;
    QuadMesher& m_mesher;
    NetTrials& m_trials;
    PhaseClock& m_clock;
    std::optional<PlacedWishes> m_usual;  // wishes
    std::optional<double> m_usual_tilt;
};

}  // namespace

std::optional<TriedNet> with_fewer_singular(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                                            QuadMesher& mesher, NetTrials& trials, PhaseClock& clock) {
    return FewerTrials(guide, options, mesher, trials, clock).run();
}

}  // namespace chebnet
