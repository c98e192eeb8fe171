#include "solve/method.h"

#include <string>

#include "io/text.h"
#include "net/error.h"
#include "solve/arap.h"
#include "solve/composite_majorization.h"
#include "solve/dp.h"
#include "solve/gauss_newton.h"
#include "solve/gradient_descent.h"
#include "solve/lbfgs.h"
#include "solve/li2022.h"
#include "solve/local_global.h"
#include "solve/projected_newton.h"
#include "solve/projection.h"

namespace chebnet {

namespace {

constexpr const char* k_li2022 =
    "Li, Guo, Wang, Chai, Liu, Fu: Interactive Editing of Discrete Chebyshev Nets. Computer Graphics Forum 41(2), 2022";

constexpr MethodInfo k_methods[] = {
    {"li2022", "The paper's: the energy r^p + r^-p, Newton steps on its convex majorizer, in three stages.", k_li2022,
     make_li2022},
    {"projection",
     "A rigid start, springs, then projection onto the exact lengths: our own way to go fast and bend little.",
     "Sorkine, Alexa 2007; Liu, Bouaziz, Kavan 2017; Goldenthal, Harmon, Fattal, Bercovier, Grinspun: Efficient "
     "Simulation of Inextensible Cloth. ACM Transactions on Graphics 26(3), 2007",
     make_projection},
    {"composite_majorization", "The paper's energy and stages; compressed edges get no tangential stiffness.",
     "Shtengel, Poranne, Sorkine-Hornung, Kovalsky, Lipman: Geometric Optimization via Composite Majorization. ACM "
     "Transactions on Graphics 36(4), 2017",
     make_composite_majorization},
    {"projected_newton", "The paper's energy and stages; the true Hessian, made positive semi-definite edge by edge.",
     "Teran, Sifakis, Irving, Fedkiw: Robust Quasistatic Finite Elements and Flesh Simulation. Symposium on Computer "
     "Animation 2005",
     make_projected_newton},
    {"gauss_newton", "Edges as springs, with steps of Gauss and Newton in a slightly smooth metric: few and costly.",
     "Nocedal, Wright: Numerical Optimization, second edition. Springer 2006, section 10.3", make_gauss_newton},
    {"dp4", "The energy |r - 1|^p with the paper's stages and p = 4 at the end.", k_li2022, make_dp4},
    {"dp8", "The energy |r - 1|^p with the paper's stages and p = 8 at the end.", k_li2022, make_dp8},
    {"arap", "As rigid as possible: the edges at each vertex turn together from rest; keeps shapes, not lengths.",
     "Sorkine, Alexa: As-Rigid-As-Possible Surface Modeling. Symposium on Geometry Processing 2007", make_arap},
    {"local_global", "Each edge takes its length by itself, then one constant linear system fits them together.",
     "Bouaziz, Deuss, Schwartzburg, Weise, Pauly: Shape-Up: Shaping Discrete Geometry with Projections. Computer "
     "Graphics Forum 31(5), 2012; Liu, Bargteil, O'Brien, Kavan: Fast Simulation of Mass-Spring Systems. ACM "
     "Transactions on Graphics 32(6), 2013",
     make_local_global},
    {"gradient_descent", "Steepest descent on the paper's energy, with a line search: cheap and very many iterations.",
     "Armijo: Minimization of functions having Lipschitz continuous first partial derivatives. Pacific Journal of "
     "Mathematics 16(1), 1966",
     make_gradient_descent},
    {"lbfgs", "L-BFGS on the paper's energy: learns the curvature from the last ten gradients.",
     "Liu, Nocedal: On the limited memory BFGS method for large scale optimization. Mathematical Programming 45, 1989",
     make_lbfgs},
};

}  // namespace

std::span<const MethodInfo> method_table() { return k_methods; }

std::unique_ptr<Method> make_method(std::string_view name) {
    std::string known;
    for (const MethodInfo& method : k_methods) {
        if (name == method.name) return method.make();
        known += known.empty() ? "" : ", ";
        known += method.name;
    }
    throw Error(ErrorCode::bad_option, "unknown method " + quoted(name) + "; known are " + known);
}

}  // namespace chebnet
