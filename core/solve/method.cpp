#include "solve/method.h"

#include <string>

#include "net/error.h"
#include "solve/li2022.h"

namespace chebnet {

namespace {

constexpr MethodInfo k_methods[] = {
    {"li2022", "The paper's: the energy r^p + r^-p, Newton steps on its convex majorizer, in three stages.",
     "Li, Guo, Wang, Chai, Liu, Fu: Interactive Editing of Discrete Chebyshev Nets. Computer Graphics Forum 41(2), "
     "2022",
     make_li2022},
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
