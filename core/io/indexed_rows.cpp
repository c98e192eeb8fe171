#include "io/indexed_rows.h"

#include "base/text.h"

namespace chebnet {

std::string indexed_rows(const Positions& positions, const Faces& faces) {
    std::string out;
    for (const auto& p : positions.colwise()) out += row_text({p.data(), 3}, 17) + '\n';
    for (int f = 0; f < faces.size(); ++f) {
        out += std::to_string(faces[f].size());
        for (const int vertex : faces[f]) out += ' ' + std::to_string(vertex);
        out += '\n';
    }
    return out;
}

}  // namespace chebnet
