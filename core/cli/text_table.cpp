#include "text_table.h"

#include <algorithm>
#include <sstream>

namespace chebnet {
namespace {

std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    return widths;
}

}  // namespace

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
    const auto widths = column_widths(rows);
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            text += "  " + row[i];
            if (i + 1 < row.size()) text.append(widths[i] - row[i].size(), ' ');
        }
        text += '\n';
    }
    return text;
}

std::string to_text(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

}  // namespace chebnet
