#include "points_argument.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "base/error.h"
#include "base/number.h"

namespace chebnet {

Positions points_in(const std::string& text, const std::string& option) {
    const auto refuse = [&](const std::string& word, const char* reason) {
        std::string message = option;
        message.append(": \"").append(word).append("\" ").append(reason);
        throw Error(ErrorCode::bad_option, message);
    };
    std::istringstream words(text);
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        std::istringstream parts(word);
        int count = 0;
        for (std::string part; std::getline(parts, part, ','); ++count) {
            const std::optional<double> number = parse_number(part);
            if (!number) refuse(part, "is not a number");
            if (!std::isfinite(*number)) refuse(part, "is not finite");
            numbers.push_back(*number);
        }
        if (count != 3) refuse(word, "should be three numbers, as in 1,0,2.5");
    }
    return Positions::Map(numbers.data(), 3, std::ssize(numbers) / 3);
}

}  // namespace chebnet
