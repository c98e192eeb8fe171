#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace chebnet::samples {

/// The cells of each line of a table but its header.
inline std::vector<std::vector<std::string>> cells_of(const std::string& table) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(table);
    std::string line, cell;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        rows.emplace_back();
        std::istringstream cells(line);
        while (std::getline(cells, cell, ',')) rows.back().push_back(cell);
    }
    return rows;
}

}  // namespace chebnet::samples
