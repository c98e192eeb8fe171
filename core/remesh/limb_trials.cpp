#include "remesh/limb_trials.h"

#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "drape/tilt.h"
#include "remesh/creases.h"
#include "remesh/prepared_surface.h"

namespace chebnet {

namespace {

// Around limbs that are left off go fewer cells than this, and than the second where there is no net even so.
constexpr double k_thin_girth = 4, k_wide_girth = 5;
// A net with so many folds is worth a trial without limbs, which has to halve them.
constexpr int k_many_limb_folds = 10;
constexpr double k_clearly_fewer = 0.5;

/// A net with all limbs if that can be, and is not much crumpled; for what is thin alone need not spoil it.
class LimbTrials {
public:
    LimbTrials(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, const WholeRemesh& make)
        : m_guide(guide), m_options(options), m_make(make) {}

    Remesh run() {
        attempt({m_guide});
        const bool is_free = m_options.singular.is_empty() && m_options.marked_creases.empty();
        if (is_free && m_folds > k_many_limb_folds && !attempt_without(k_thin_girth)) attempt_without(k_wide_girth);
        if (!m_made) std::rethrow_exception(m_failure);
        return *std::move(m_made);
    }

private:
    /// Whether a net was made.
    bool attempt_without(double girth) {
        const Surface& surface = m_guide->surface();
        const double cell = std::sqrt(surface.area() / cells_asked_for(surface, m_options));
        const double crease = m_options.crease > 0 ? m_options.crease : k_sharp_edge;
        const WithoutLimbs trimmed = without_thin_limbs(m_guide, cell, girth, crease);
        return !trimmed.limbs.empty() && attempt(trimmed);
    }

    bool attempt(const WithoutLimbs& trimmed) {
        try {
            Remesh made = m_make(trimmed.guide);
            const int folds = crumpled_edges(*m_guide, made.net);
            if (m_made && folds > k_clearly_fewer * m_folds) return true;
            made.left_off = trimmed.limbs;
            m_made = std::move(made);
            m_folds = folds;
            return true;
        } catch (const Error& error) {
            if (error.code() != ErrorCode::bad_option && error.code() != ErrorCode::too_large) throw;
            if (!m_failure) m_failure = std::current_exception();
            return false;
        }
    }

    const std::shared_ptr<const Guide>& m_guide;
    const RemeshOptions& m_options;
    const WholeRemesh& m_make;
    std::optional<Remesh> m_made;
    int m_folds = std::numeric_limits<int>::max();
    std::exception_ptr m_failure;  // of the first
};

}  // namespace

Remesh with_fitting_limbs(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                          const WholeRemesh& make) {
    return LimbTrials(guide, options, make).run();
}

}  // namespace chebnet
