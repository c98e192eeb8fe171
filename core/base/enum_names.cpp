#include "base/enum_names.h"

#include "base/error.h"
#include "base/text.h"

namespace chebnet {

void fail_with_unknown_name(std::string_view name, const char* what, const std::string& known) {
    throw Error(ErrorCode::bad_option,
                std::string("no ") + what + " is called " + quoted(name) + "; known are " + known);
}

}  // namespace chebnet
