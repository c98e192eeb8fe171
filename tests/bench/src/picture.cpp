#include "picture.h"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "net/measures.h"

namespace chebnet::bench {
namespace {

constexpr int k_width = 560, k_height = 480;
constexpr int k_fine = 3;  // each way, pixels drawn for one of the picture
constexpr double k_margin = 0.05;
constexpr double k_collapsed = 5 * std::numbers::pi / 180;

using Rgb = Eigen::Vector3f;  // 0 … 1
const Rgb k_white(1, 1, 1), k_face(0.93F, 0.93F, 0.91F), k_blue(0.13F, 0.38F, 0.78F), k_red(0.84F, 0.12F, 0.1F);
const Rgb k_pink(0.93F, 0.27F, 0.6F), k_grey(0.62F, 0.62F, 0.62F), k_dark(0.12F, 0.12F, 0.12F),
    k_orange(0.95F, 0.5F, 0.05F);

Rgb mix(const Rgb& a, const Rgb& b, double t) { return a + static_cast<float>(std::clamp(t, 0.0, 1.0)) * (b - a); }

/// A picture with depth: of what is drawn at one place, the nearest stays.
class Canvas {
public:
    Canvas()
        : m_colours(static_cast<std::size_t>(k_columns) * k_rows, k_white),
          m_depths(m_colours.size(), std::numeric_limits<float>::infinity()) {}

    static constexpr int k_columns = k_width * k_fine, k_rows = k_height * k_fine;

    void set(int column, int row, double depth, const Rgb& colour) {
        if (column < 0 || column >= k_columns || row < 0 || row >= k_rows) return;
        const std::size_t at = static_cast<std::size_t>(row) * k_columns + static_cast<std::size_t>(column);
        if (depth > m_depths[at]) return;
        m_depths[at] = static_cast<float>(depth);
        m_colours[at] = colour;
    }

    /// Corners are (column, row, depth).
    void fill_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Rgb& colour) {
        const double area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
        if (std::abs(area) < 1e-9) return;
        const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
        const auto [top, bottom] = std::minmax({a.y(), b.y(), c.y()});
        for (int row = std::max(0, static_cast<int>(top)); row <= std::min(k_rows - 1, static_cast<int>(bottom)); ++row)
            for (int column = std::max(0, static_cast<int>(left));
                 column <= std::min(k_columns - 1, static_cast<int>(right)); ++column) {
                const double x = column + 0.5, y = row + 0.5;
                const double s = ((x - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (y - a.y())) / area;
                const double t = ((b.x() - a.x()) * (y - a.y()) - (x - a.x()) * (b.y() - a.y())) / area;
                if (s < 0 || t < 0 || s + t > 1) continue;
                set(column, row, a.z() + s * (b.z() - a.z()) + t * (c.z() - a.z()), colour);
            }
    }

    void fill_disc(const Eigen::Vector3d& centre, double radius, const Rgb& colour) {
        for (int row = static_cast<int>(centre.y() - radius); row <= centre.y() + radius; ++row)
            for (int column = static_cast<int>(centre.x() - radius); column <= centre.x() + radius; ++column)
                if (std::hypot(column + 0.5 - centre.x(), row + 0.5 - centre.y()) <= radius)
                    set(column, row, centre.z(), colour);
    }

    void draw_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double width, const Rgb& colour) {
        const int steps = 1 + static_cast<int>((b - a).head<2>().norm());
        for (int i = 0; i <= steps; ++i) fill_disc(a + (b - a) * i / steps, width / 2, colour);
    }

    void draw_circle(const Eigen::Vector3d& centre, double radius, double width, const Rgb& colour) {
        const int steps = static_cast<int>(4 * radius);
        for (int i = 0; i < steps; ++i) {
            const double angle = 2 * std::numbers::pi * i / steps;
            const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
            fill_disc(Eigen::Vector3d(centre.x(), centre.y(), -1e9) + radius * out, width / 2, colour);
        }
    }

    void write(const std::string& path) const {
        std::vector<unsigned char> bytes;
        for (int row = 0; row < k_height; ++row)
            for (int column = 0; column < k_width; ++column) {
                const Rgb colour = mean(column, row);
                for (int i = 0; i < 3; ++i) bytes.push_back(static_cast<unsigned char>(std::lround(255 * colour[i])));
            }
        if (stbi_write_png(path.c_str(), k_width, k_height, 3, bytes.data(), 3 * k_width) == 0)
            throw Error(ErrorCode::file_access, path + ": cannot be written");
    }

private:
    Rgb mean(int column, int row) const {
        Rgb sum = Rgb::Zero();
        for (int i = 0; i < k_fine * k_fine; ++i)
            sum += m_colours[static_cast<std::size_t>(row * k_fine + i / k_fine) * k_columns +
                             static_cast<std::size_t>(column * k_fine + i % k_fine)];
        return sum / (k_fine * k_fine);
    }

    std::vector<Rgb> m_colours;
    std::vector<float> m_depths;
};

/// From space to (column, row, depth), without perspective.
class Projection {
public:
    explicit Projection(const Camera& camera) {
        constexpr double degree = std::numbers::pi / 180;
        const double azimuth = camera.azimuth * degree, elevation = camera.elevation * degree;
        m_axes.row(0) << std::cos(azimuth), std::sin(azimuth), 0;
        m_axes.row(2) << -std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            -std::sin(elevation);
        m_axes.row(1) = -m_axes.row(0).cross(m_axes.row(2));
        Eigen::AlignedBox3d seen;
        for (int corner = 0; corner < 8; ++corner)
            seen.extend(m_axes * camera.room.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
        m_scale =
            (1 - 2 * k_margin) * std::min(Canvas::k_columns / seen.sizes().x(), Canvas::k_rows / seen.sizes().y());
        m_shift = Eigen::Vector3d(Canvas::k_columns, Canvas::k_rows, 0) / 2 - m_scale * seen.center();
    }

    Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return m_scale * (m_axes * x) + m_shift; }
    double scale() const { return m_scale; }
    /// How directly a surface with this normal is seen, 0 … 1.
    double facing(const Eigen::Vector3d& normal) const { return std::abs(m_axes.row(2).dot(normal.transpose())); }

private:
    Eigen::Matrix3d m_axes;  // right, down, away
    double m_scale;
    Eigen::Vector3d m_shift;
};

std::vector<Rgb> edge_colours(const Net& net, const Positions& positions, Colouring colouring) {
    std::vector<Rgb> colours;
    for (const double r : edge_ratios(net, positions)) {
        if (colouring == Colouring::longer)
            colours.push_back(r > 1 ? k_pink : k_grey);
        else
            colours.push_back(mix(k_blue, k_red, (deviation(r) - 1e-6) / 1e-6));
    }
    return colours;
}

Eigen::Vector3d normal_of(std::span<const int> face, const Positions& positions) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < face.size(); ++i)
        normal += positions.col(face[i]).cross(positions.col(face[(i + 1) % face.size()]));
    return normal.normalized();
}

Eigen::Vector3d centre_of(std::span<const int> face, const Positions& positions) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int v : face) sum += positions.col(v);
    return sum / static_cast<double>(face.size());
}

/// Of a face, the angle at the corner farthest from a right one, radians.
double smallest_angle(std::span<const int> face, const Positions& positions) {
    double smallest = std::numbers::pi;
    const std::size_t size = face.size();
    for (std::size_t i = 0; i < size; ++i) {
        const Eigen::Vector3d at = positions.col(face[i]);
        const Eigen::Vector3d a = positions.col(face[(i + 1) % size]) - at,
                              b = positions.col(face[(i + size - 1) % size]) - at;
        smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
    return smallest;
}

void draw_faces(const Net& net, const Positions& positions, Colouring colouring, const Projection& project,
                Canvas& canvas) {
    for (int f = 0; f < net.face_count(); ++f) {
        const auto face = net.faces()[f];
        const double shear = 1 - smallest_angle(face, positions) / (std::numbers::pi / 2);
        const Rgb base = colouring == Colouring::angle ? mix(k_face, k_red, shear) : k_face;
        const Rgb colour = base * static_cast<float>(0.62 + 0.38 * project.facing(normal_of(face, positions)));
        const Eigen::Vector3d centre = project(centre_of(face, positions));
        for (std::size_t i = 0; i < face.size(); ++i)
            canvas.fill_triangle(centre, project(positions.col(face[i])),
                                 project(positions.col(face[(i + 1) % face.size()])), colour);
    }
}

}  // namespace

void draw_net(const Net& net, const Positions& positions, const std::vector<Handle>& handles, Colouring colouring,
              const Camera& camera, const std::string& path) {
    const Projection project(camera);
    Canvas canvas;
    draw_faces(net, positions, colouring, project, canvas);

    // In front of the faces they belong to, but not of those a good deal nearer.
    const double edge = net.mean_length() * project.scale();
    const Eigen::Vector3d nearer(0, 0, -0.3 * edge);
    const double width = std::clamp(0.12 * edge, 1.5, 5.0);
    const std::vector<Rgb> colours = edge_colours(net, positions, colouring);
    for (int e = 0; e < net.edge_count(); ++e)
        canvas.draw_line(project(positions.col(net.edges()(0, e))) + nearer,
                         project(positions.col(net.edges()(1, e))) + nearer, width,
                         colours[static_cast<std::size_t>(e)]);
    for (const Handle& handle : handles) {
        const bool is_anchor = handle.target == net.rest_positions().col(handle.vertex);
        canvas.fill_disc(project(positions.col(handle.vertex)) + 3 * nearer, 4.5 * k_fine,
                         is_anchor ? k_dark : k_orange);
    }
    if (colouring == Colouring::angle)
        for (int f = 0; f < net.face_count(); ++f)
            if (smallest_angle(net.faces()[f], positions) < k_collapsed)
                canvas.draw_circle(project(centre_of(net.faces()[f], positions)), 9 * k_fine, k_fine, k_dark);
    canvas.write(path);
}

}  // namespace chebnet::bench
