#include "energy/spring_energy.h"
#include "solve/methods/methods.h"
#include "solve/parts/newton_direction.h"
#include "solve/parts/option_names.h"
#include "solve/parts/staged_descent.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_gauss_newton() {
    const auto make_springs = [](double, const Options&) -> std::unique_ptr<EdgeEnergy> {
        return std::make_unique<SpringEnergy>();
    };
    return std::make_unique<StagedDescent>(make_springs, std::make_unique<NewtonDirection>(), [](Options& options) {
        keep_all_vertices(options);
        options.adaptive_p = false;
        options.p_end = 0;
    });
}

/// Of the two with all vertices the second alone: there is no exponent to begin with.
constexpr std::array k_gauss_newton_stages{"", "Newton steps"};

}  // namespace

/// Gauss–Newton on the edges as springs, Σ (r − 1)², with a small Laplacian in the metric (see SpringEnergy) and Armijo
/// backtracking. Each iteration factors a system as large as the paper's; few are needed. See StagedDescent; there
/// are no exponents here.
constinit const MethodInfo k_gauss_newton = {
    "gauss_newton",
    "Edges as springs, with steps of Gauss and Newton in a slightly smooth metric: few and costly.",
    "Nocedal, Wright: Numerical Optimization, second edition. Springer 2006, section 10.3",
    k_gauss_newton_stages,
    k_tolerances,
    in_this_build(make_gauss_newton)};

}  // namespace chebnet
