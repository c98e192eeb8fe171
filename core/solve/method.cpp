#include "solve/method.h"

#include <algorithm>
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

bool reads(const MethodInfo& method, std::string_view option) {
    // By the editor, whatever the method.
    static constexpr const char* k_of_every_solve[] = {"threshold", "max_iterations", "length_scale"};
    const auto is_among = [&](NameList names) { return std::find(names.begin(), names.end(), option) != names.end(); };
    return is_among(k_of_every_solve) || is_among(method.options);
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
