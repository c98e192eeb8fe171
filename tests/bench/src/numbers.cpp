#include "numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace chebnet::bench {

double quantile(std::vector<double> values, double part) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    const double place = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

double median(std::span<const double> values) { return quantile({values.begin(), values.end()}, 0.5); }

double spread(std::span<const double> values) {
    const std::vector<double> copy(values.begin(), values.end());
    return quantile(copy, 0.75) - quantile(copy, 0.25);
}

double geometric_mean(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

double PowerLaw::operator()(double x) const { return factor * std::pow(x, exponent); }

PowerLaw fit_power_law(std::span<const Point> points) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Point& point : points) {
        const double x = std::log(point.x), y = std::log(point.y);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    return {std::exp((sy - exponent * sx) / n), exponent};
}

std::string formatted(const char* pattern, double value) {
    char text[64];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

std::string cell(const char* pattern, double value) { return std::isfinite(value) ? formatted(pattern, value) : "–"; }

}  // namespace chebnet::bench
