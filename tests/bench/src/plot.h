#pragma once

#include <string>
#include <vector>

#include "numbers.h"

namespace chebnet::bench {

/// One line of a panel. Series with the same `key` have the same colour and one entry in the legend.
struct Series {
    std::string key;
    std::vector<Point> points;
    std::vector<Point> circles = {};  ///< drawn around points of it
};

/// One pair of axes. On a logarithmic axis only positive values are drawn.
struct Panel {
    std::string title, x_label, y_label;
    bool log_x, log_y;
    std::vector<Series> series;
    std::vector<double> lines = {};  ///< x of dotted lines
};

/// The panels as an SVG picture, row by row, that can be read on a light and on a dark page.
std::string to_svg(const std::vector<Panel>& panels, int columns);

}  // namespace chebnet::bench
