#include "surface/surface_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace chebnet {

namespace {

constexpr int k_leaf_size = 4;
// A cut through the middle of the box that leaves less than this part on one side gives way to one through the median,
// so that the tree is never deep.
constexpr int k_least_part = 8;
constexpr double k_farthest = std::numeric_limits<double>::infinity();
// Of a point farther away than so many sizes of the surface only the direction counts: by its distance, all of the
// surface is equally near, or infinitely far when it is squared.
constexpr double k_afar = 1e7;

/// The same place, found for the point as drawn near.
SurfaceTree::Nearest from_afar(const Eigen::Vector3d& point, SurfaceTree::Nearest nearest) {
    nearest.distance = (point - nearest.position).stableNorm();
    return nearest;
}

/// The barycentric coordinates of the point of triangle abc nearest to p (Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.5).
Eigen::Vector3d nearest_weights(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c) {
    const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const double v = d1 / (d1 - d3);
        return {1 - v, v, 0};
    }
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const double w = d2 / (d2 - d6);
        return {1 - w, 0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - w, w};
    }
    const double v = vb / (va + vb + vc), w = vc / (va + vb + vc);
    return {std::max(0.0, 1 - v - w), v, w};  // beside an edge rounding leads below 0
}

}  // namespace

// --------------------------------------------------------------------------------------------------------------- build

SurfaceTree::SurfaceTree(const Surface& surface)
    : m_surface(surface), m_faces(static_cast<std::size_t>(surface.face_count())) {
    std::iota(m_faces.begin(), m_faces.end(), 0);
    Positions centres(3, surface.face_count());
    for (int f = 0; f < surface.face_count(); ++f) centres.col(f) = surface.position_at({f, {1. / 3, 1. / 3, 1. / 3}});
    m_nodes.reserve(m_faces.size());
    build(0, surface.face_count(), centres);
    m_nodes.shrink_to_fit();
    const BoxNode& whole = m_nodes.front();
    m_centre = (whole.low + whole.high) / 2;
    m_afar = k_afar * (whole.high - whole.low).maxCoeff();
}

/// The node around the triangles at these places, and all below it; returns its number.
int SurfaceTree::build(int first, int last, const Positions& centres) {
    const int number = static_cast<int>(m_nodes.size());
    m_nodes.push_back({Eigen::Vector3d::Constant(k_farthest), Eigen::Vector3d::Constant(-k_farthest), first, 0});
    if (last - first <= k_leaf_size) {
        BoxNode& leaf = m_nodes.back();
        leaf.count = last - first;
        std::sort(m_faces.begin() + first, m_faces.begin() + last);  // an order that does not depend on the cuts
        for (int i = first; i < last; ++i)
            for (const int vertex : m_surface.triangles().col(m_faces[i])) {
                leaf.low = leaf.low.cwiseMin(m_surface.positions().col(vertex));
                leaf.high = leaf.high.cwiseMax(m_surface.positions().col(vertex));
            }
        return number;
    }
    const int middle = split(first, last, centres);
    const int left = build(first, middle, centres), right = build(middle, last, centres);
    BoxNode& node = m_nodes[number];
    node.first = right;
    node.low = m_nodes[left].low.cwiseMin(m_nodes[right].low);
    node.high = m_nodes[left].high.cwiseMax(m_nodes[right].high);
    return number;
}

/// Parts the triangles across the longest side of the box around their centres; returns where the second part begins.
int SurfaceTree::split(int first, int last, const Positions& centres) {
    Eigen::Vector3d low = centres.col(m_faces[first]), high = low;
    for (int i = first + 1; i < last; ++i) {
        low = low.cwiseMin(centres.col(m_faces[i]));
        high = high.cwiseMax(centres.col(m_faces[i]));
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const double cut = low[axis] + (high[axis] - low[axis]) / 2;
    const auto begin = m_faces.begin() + first, end = m_faces.begin() + last;
    const auto middle = std::partition(begin, end, [&](int f) { return centres(axis, f) < cut; });
    if (std::min(middle - begin, end - middle) * k_least_part >= end - begin)
        return static_cast<int>(middle - m_faces.begin());
    const auto median = begin + (end - begin) / 2;
    std::nth_element(begin, median, end,
                     [&](int f, int g) { return std::pair(centres(axis, f), f) < std::pair(centres(axis, g), g); });
    return static_cast<int>(median - m_faces.begin());
}

// ------------------------------------------------------------------------------------------------------------- nearest

bool SurfaceTree::is_far(const Eigen::Vector3d& point) const {
    return (point - m_centre).lpNorm<Eigen::Infinity>() > m_afar;
}

Eigen::Vector3d SurfaceTree::drawn_near(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d way = point - m_centre;
    return m_centre + m_afar / 2 * (way / way.lpNorm<Eigen::Infinity>());  // half: it must not be far any more
}

SurfaceTree::Nearest SurfaceTree::nearest(const Eigen::Vector3d& point) const { return nearest(point, m_faces[0]); }

SurfaceTree::Nearest SurfaceTree::nearest(const Eigen::Vector3d& point, int guess) const {
    if (is_far(point)) return from_afar(point, nearest(drawn_near(point), guess));
    Nearest best{};
    double least = k_farthest;
    consider(guess, point, least, best);
    visit_nearest(0, point, least, best);
    best.distance = std::sqrt(least);
    return best;
}

void SurfaceTree::visit_nearest(int number, const Eigen::Vector3d& point, double& least, Nearest& best) const {
    const BoxNode& node = m_nodes[number];
    for (int i = 0; i < node.count; ++i) consider(m_faces[node.first + i], point, least, best);
    if (node.count > 0) return;
    const auto distance = [&](int child) { return squared_distance(m_nodes[child], point); };
    std::pair<double, int> near{distance(number + 1), number + 1}, far{distance(node.first), node.first};
    if (far < near) std::swap(near, far);
    if (near.first < least) visit_nearest(near.second, point, least, best);
    if (far.first < least) visit_nearest(far.second, point, least, best);
}

SurfaceTree::Nearest SurfaceTree::nearest_in(int face, const Eigen::Vector3d& point) const {
    if (is_far(point)) return from_afar(point, nearest_in(face, drawn_near(point)));
    Nearest nearest{};
    double square = k_farthest;
    consider(face, point, square, nearest);
    nearest.distance = std::sqrt(square);
    return nearest;
}

void SurfaceTree::consider(int face, const Eigen::Vector3d& point, double& least, Nearest& best) const {
    const Eigen::Vector3i t = m_surface.triangles().col(face);
    const Positions& x = m_surface.positions();
    const SurfacePoint at{face, nearest_weights(point, x.col(t[0]), x.col(t[1]), x.col(t[2]))};
    const Eigen::Vector3d position = m_surface.position_at(at);
    const double square = (position - point).squaredNorm();
    if (!(square < least)) return;
    least = square;
    best.at = at;
    best.position = position;
}

// ----------------------------------------------------------------------------------------------------------------- ray

struct SurfaceTree::Ray {
    Eigen::Vector3d origin, direction, inverse;

    /// Where the ray enters a box; infinity if it misses it.
    double entry(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const {
        double enter = 0, leave = k_farthest;
        for (int axis = 0; axis < 3; ++axis) {
            double a = (low[axis] - origin[axis]) * inverse[axis], b = (high[axis] - origin[axis]) * inverse[axis];
            if (a > b) std::swap(a, b);
            // A ray within a side of the box has 0 · ∞ there, which compares as false and bounds nothing.
            if (a > enter) enter = a;
            if (b < leave) leave = b;
        }
        // What rounding may take off the far side must not lose a triangle that fills the box.
        return enter <= leave * (1 + 1e-14) ? enter : k_farthest;
    }
};

std::optional<SurfaceTree::Hit> SurfaceTree::hit(const Eigen::Vector3d& origin,
                                                 const Eigen::Vector3d& direction) const {
    std::optional<Hit> best;
    visit_ray(0, {origin, direction, direction.cwiseInverse()}, best);
    return best;
}

void SurfaceTree::visit_ray(int number, const Ray& ray, std::optional<Hit>& best) const {
    const BoxNode& node = m_nodes[number];
    for (int i = 0; i < node.count; ++i) consider(m_faces[node.first + i], ray, best);
    if (node.count > 0) return;
    const auto entry = [&](int child) { return ray.entry(m_nodes[child].low, m_nodes[child].high); };
    const auto is_worth_it = [&](double way) { return way < (best ? best->way : k_farthest); };
    std::pair<double, int> near{entry(number + 1), number + 1}, far{entry(node.first), node.first};
    if (far < near) std::swap(near, far);
    if (is_worth_it(near.first)) visit_ray(near.second, ray, best);
    if (is_worth_it(far.first)) visit_ray(far.second, ray, best);
}

/// By Möller and Trumbore (1997). A triangle is taken larger by what rounding may lose at its edges.
void SurfaceTree::consider(int face, const Ray& ray, std::optional<Hit>& best) const {
    constexpr double tolerance = 1e-12;
    const Eigen::Vector3i t = m_surface.triangles().col(face);
    const Positions& x = m_surface.positions();
    const Eigen::Vector3d ab = x.col(t[1]) - x.col(t[0]), ac = x.col(t[2]) - x.col(t[0]);
    const Eigen::Vector3d p = ray.direction.cross(ac), from_corner = ray.origin - x.col(t[0]);
    const double determinant = ab.dot(p);
    if (determinant == 0) return;
    const Eigen::Vector3d q = from_corner.cross(ab);
    const double v = from_corner.dot(p) / determinant, w = ray.direction.dot(q) / determinant;
    const double way = ac.dot(q) / determinant;
    if (!(v >= -tolerance && w >= -tolerance && v + w <= 1 + tolerance && way >= 0)) return;
    if (best && best->way <= way) return;
    const Eigen::Vector3d weights = Eigen::Vector3d(1 - v - w, v, w).cwiseMax(0.0);
    const SurfacePoint at{face, weights / weights.sum()};
    best = Hit{at, m_surface.position_at(at), way};
}

}  // namespace chebnet
