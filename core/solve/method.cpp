#include "solve/method.h"

#include <string>

#include "net/error.h"
#include "solve/arap.h"
#include "solve/li2022.h"
#include "solve/local_global.h"

namespace chebnet {

namespace {

constexpr MethodInfo k_methods[] = {
    {"li2022", "The paper's: the energy r^p + r^-p, Newton steps on its convex majorizer, in three stages.",
     "Li, Guo, Wang, Chai, Liu, Fu: Interactive Editing of Discrete Chebyshev Nets. Computer Graphics Forum 41(2), "
     "2022",
     make_li2022},
    {"arap",
     "As rigid as possible: each vertex's edges turn together from their rest shape; keeps shapes, not lengths.",
     "Sorkine, Alexa: As-Rigid-As-Possible Surface Modeling. Symposium on Geometry Processing 2007", make_arap},
    {"local_global", "Each edge takes its length in turn, then one constant linear system fits them all together.",
     "Bouaziz, Deuss, Schwartzburg, Weise, Pauly: Shape-Up: Shaping Discrete Geometry with Projections. Computer "
     "Graphics Forum 31(5), 2012; Liu, Bargteil, O'Brien, Kavan: Fast Simulation of Mass-Spring Systems. ACM "
     "Transactions on Graphics 32(6), 2013",
     make_local_global},
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
    throw Error(ErrorCode::bad_option,
                "unknown method \"" + std::string(name.substr(0, 40)) + "\"; known are " + known);
}

}  // namespace chebnet
