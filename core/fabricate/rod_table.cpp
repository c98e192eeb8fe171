#include "fabricate/rod_table.h"

#include <cstddef>
#include <vector>

#include "base/number.h"
#include "net/rods.h"

namespace chebnet {

namespace {

/// How far along it each vertex of a line is.
std::vector<double> marks_of(const std::vector<int>& line, const Positions& positions) {
    std::vector<double> marks{0};
    for (std::size_t k = 1; k < line.size(); ++k)
        marks.push_back(marks.back() + (positions.col(line[k]) - positions.col(line[k - 1])).stableNorm());
    return marks;
}

template <class Number, class Text>
void append(std::string& table, const std::vector<Number>& numbers, Text text_of) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        table += k == 0 ? ',' : ' ';
        table += text_of(numbers[k]);
    }
}

}  // namespace

std::string rod_table(const Net& net, const Topology& topology, const Positions& positions) {
    std::string table = "rod,edges,length,closed,vertices,marks\n";
    const std::vector<std::vector<int>> lines = rods(net, topology);
    const std::vector<bool> is_closed = closed_rods(topology, lines);
    std::size_t number = 0;
    for (const std::vector<int>& line : lines) {
        const std::vector<double> marks = marks_of(line, positions);
        table += std::to_string(number);
        table += ',';
        table += std::to_string(line.size() - 1);
        table += ',';
        table += exact_text(marks.back());
        table += is_closed[number++] ? ",1" : ",0";
        append(table, line, [](int vertex) { return std::to_string(vertex); });
        append(table, marks, exact_text);
        table += '\n';
    }
    return table;
}

}  // namespace chebnet
