#include "change/folded.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.h"

namespace chebnet {

void check_not_folded(const Faces& faces) {
    std::vector<std::pair<int, int>> sides;
    std::vector<std::vector<int>> corners;
    for (int f = 0; f < faces.size(); ++f) {
        std::vector<int> face(faces[f].begin(), faces[f].end());
        for (std::size_t k = 0; k < face.size(); ++k)
            sides.push_back(std::minmax(face[k], face[(k + 1) % face.size()]));
        std::sort(face.begin(), face.end());
        corners.push_back(std::move(face));
    }
    std::sort(sides.begin(), sides.end());
    std::sort(corners.begin(), corners.end());
    bool is_folded = std::adjacent_find(corners.begin(), corners.end()) != corners.end();
    for (std::size_t k = 0; k + 2 < sides.size(); ++k) is_folded |= sides[k] == sides[k + 2];
    if (is_folded)
        throw Error(ErrorCode::impossible_change,
                    "rows of the net close after so few faces that what is left would lie on itself");
}

}  // namespace chebnet
