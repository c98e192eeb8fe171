#include "solve/options.h"

#include <vector>

#include "arbitrary.h"
#include "require.h"
#include "solve/initialisation.h"
#include "solve/method.h"

using namespace chebnet;
using fuzz::require;

namespace {

std::vector<double> values_of(const Options& options) {
    std::vector<double> values;
    for (const OptionInfo& info : option_table()) values.push_back(get_option(options, info.name));
    return values;
}

void require_in_range(const Options& options) {
    for (const OptionInfo& info : option_table()) {
        const double value = get_option(options, info.name);
        require(value >= info.smallest && value <= info.largest, std::string(info.name) + " is out of range");
    }
}

/// Runs an action that may refuse what it is given; true if it did.
template <class Action>
bool is_refused(Action action) {
    try {
        action();
        return false;
    } catch (const Error& error) {
        fuzz::require_readable(error);
        require(error.code() == ErrorCode::bad_option,
                std::string("a text is refused with ") + to_string(error.code()));
        return true;
    }
}

std::string any_key(FuzzedDataProvider& input) {
    const auto table = option_table();
    if (input.ConsumeProbability<double>() < 0.1) return input.ConsumeRandomLengthString(100);
    return table[input.ConsumeIntegralInRange<std::size_t>(0, table.size() - 1)].name;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider input(data, size);
    Options options;
    while (input.remaining_bytes() > 0) {
        const std::vector<double> before = values_of(options);
        const std::string key = any_key(input), value = input.ConsumeRandomLengthString(400);
        if (is_refused([&] { set_option(options, key, value); }))
            require(values_of(options) == before, "an option that was refused has changed something");
        require_in_range(options);
        is_refused([&] { make_method(value); });
        is_refused([&] { require(Initialisation(value).name() == value, "an initialisation of another name"); });
    }
    return 0;
}
