#include "io/indexed_rows.h"

#include "io/text.h"

namespace chebnet {

std::string indexed_rows(const Positions& positions, const Faces& faces) {
    std::ostringstream out = number_stream(17);
    for (const auto& p : positions.colwise()) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (int f = 0; f < faces.size(); ++f) {
        out << faces[f].size();
        for (const int vertex : faces[f]) out << ' ' << vertex;
        out << '\n';
    }
    return out.str();
}

}  // namespace chebnet
