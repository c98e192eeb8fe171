#pragma once

#include <span>
#include <string>
#include <vector>

namespace chebnet::bench {

/// The value below which `part` of the values lie, 0 … 1, interpolated. NaN if there are none.
double quantile(std::vector<double> values, double part);
double median(std::span<const double> values);
/// From the lower to the upper quartile.
double spread(std::span<const double> values);
/// NaN if there are none.
double geometric_mean(std::span<const double> values);

struct Point {
    double x, y;
};

/// A straight line through logarithms: y = factor · x^exponent.
struct PowerLaw {
    double factor, exponent;
    double operator()(double x) const;
};
/// By least squares; at least two points of different x, all coordinates positive.
PowerLaw fit_power_law(std::span<const Point> points);

/// As printf writes it.
std::string formatted(const char* pattern, double value);
/// The same for a table: "–" for what is not finite.
std::string cell(const char* pattern, double value);

}  // namespace chebnet::bench
