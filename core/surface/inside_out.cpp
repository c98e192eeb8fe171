#include "surface/inside_out.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace chebnet {

namespace {

// A volume that is less than this, beside the area's power of 3/2, is none, as of a sheet that is closed around itself.
constexpr double k_least_volume = 1e-9;

struct Body {
    std::vector<int> faces;
    Eigen::AlignedBox3d box;
    double volume = 0;
    bool is_closed = true, is_inside_out = false;

    bool encloses_some() const { return is_closed && volume != 0; }
};

Eigen::Matrix3d corners_of(const Surface& surface, int face) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = surface.positions().col(surface.triangles()(k, face));
    return corners;
}

std::vector<Body> bodies_of(const Surface& surface) {
    const std::vector<int> numbers = surface.components();
    std::vector<Body> pieces(static_cast<std::size_t>(*std::max_element(numbers.begin(), numbers.end())) + 1);
    for (int f = 0; f < surface.face_count(); ++f) {
        Body& piece = pieces[numbers[f]];
        piece.faces.push_back(f);
        for (int s = 3 * f; s < 3 * f + 3; ++s) {
            piece.box.extend(surface.positions().col(surface.from(s)));
            if (surface.opposite(s) < 0) piece.is_closed = false;
        }
    }
    return pieces;
}

/// Of the tetrahedra between the triangles and the middle of the box, together.
void measure_volume(const Surface& surface, Body& piece) {
    const Eigen::Vector3d middle = piece.box.center();
    double area = 0;
    for (const int f : piece.faces) {
        piece.volume += (corners_of(surface, f).colwise() - middle).determinant() / 6;
        area += surface.areas()[f];
    }
    if (!(std::abs(piece.volume) > k_least_volume * area * std::sqrt(area))) piece.volume = 0;
    piece.is_inside_out = piece.volume < 0;
}

/// By the solid angles of the triangles (Van Oosterom & Strackee, The Solid Angle of a Plane Triangle, 1983).
bool winds_around(const Surface& surface, const Body& piece, const Eigen::Vector3d& point) {
    double halves = 0;
    for (const int f : piece.faces) {
        const Eigen::Matrix3d to = corners_of(surface, f).colwise() - point;
        const Eigen::Vector3d far = to.colwise().norm();
        const double across = far.prod() + to.col(0).dot(to.col(1)) * far[2] + to.col(1).dot(to.col(2)) * far[0] +
                              to.col(2).dot(to.col(0)) * far[1];
        halves += std::atan2(to.determinant(), across);
    }
    return std::abs(halves) > std::numbers::pi;  // of 2 π, all around
}

/// Each that lies within another as the outermost around it.
void turn_with_outermost(const Surface& surface, std::vector<Body*> closed) {
    std::stable_sort(closed.begin(), closed.end(),
                     [](const Body* a, const Body* b) { return std::abs(a->volume) > std::abs(b->volume); });
    std::vector<const Body*> outermost;
    for (Body* const piece : closed) {
        const Eigen::Vector3d point = corners_of(surface, piece->faces.front()).col(0);
        const auto around = std::find_if(outermost.begin(), outermost.end(), [&](const Body* other) {
            return other->box.contains(piece->box) && winds_around(surface, *other, point);
        });
        if (around == outermost.end())
            outermost.push_back(piece);
        else
            piece->is_inside_out = (*around)->is_inside_out;
    }
}

}  // namespace

std::vector<bool> faces_inside_out(const Surface& surface) {
    std::vector<Body> pieces = bodies_of(surface);
    std::vector<Body*> closed;
    for (Body& piece : pieces) {
        if (piece.is_closed) measure_volume(surface, piece);
        if (piece.encloses_some()) closed.push_back(&piece);
    }
    if (std::none_of(closed.begin(), closed.end(), [](const Body* piece) { return piece->is_inside_out; })) return {};
    turn_with_outermost(surface, closed);
    std::vector<bool> are_inside_out(static_cast<std::size_t>(surface.face_count()), false);
    for (const Body& piece : pieces)
        for (const int f : piece.faces) are_inside_out[f] = piece.is_inside_out;
    return are_inside_out;
}

}  // namespace chebnet
