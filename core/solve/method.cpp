#include "solve/method.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "solve/methods/methods.h"

namespace chebnet {

std::span<const MethodInfo> method_table() {
    static const auto table = [] {
        std::vector<MethodInfo> infos;
        for (const MethodInfo* method : k_methods) infos.push_back(*method);
        return infos;
    }();
    return table;
}

std::unique_ptr<Method> make_method(std::string_view name) {
    std::string known;
    for (const MethodInfo* method : k_methods) {
        if (name == method->name && method->make == nullptr)
            throw Error(ErrorCode::left_out, "method " + quoted(name) + " is not in this module, but in chebnet_core");
        if (name == method->name) return method->make();
        known += known.empty() ? "" : ", ";
        known += method->name;
    }
    throw Error(ErrorCode::bad_option, "unknown method " + quoted(name) + "; known are " + known);
}

}  // namespace chebnet
