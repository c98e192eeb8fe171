#include "edits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/angle.h"
#include "solve/method.h"

namespace chebnet::soak {

namespace {

double real(Random& random, double smallest, double largest) {
    return std::uniform_real_distribution<double>(smallest, largest)(random);
}

Eigen::Vector3d direction(Random& random) {
    std::normal_distribution<double> normal;
    Eigen::Vector3d d(normal(random), normal(random), normal(random));
    return d.stableNormalized();
}

double extent(const Net& net) {
    const Positions& x = net.rest_positions();
    return (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
}

std::vector<Handle> go_home(const Editor& editor, Random&) {
    std::vector<Handle> handles = editor.handles();
    for (Handle& handle : handles) handle.target = editor.net().rest_positions().col(handle.vertex);
    return handles;
}

/// Moves one handle, as a hand does, or about half of them by up to `distance`, from rest or from where they are.
std::vector<Handle> moved(const Editor& editor, Random& random, double distance) {
    std::vector<Handle> handles = random() % 2 == 0 ? editor.handles() : go_home(editor, random);
    const std::size_t sure = random() % handles.size();
    const bool several = random() % 2 == 0;
    for (std::size_t i = 0; i < handles.size(); ++i)
        if (i == sure || (several && random() % 2 == 0))
            handles[i].target += real(random, 0, distance) * direction(random);
    return handles;
}

std::vector<Handle> nudge(const Editor& editor, Random& random) {
    return moved(editor, random, editor.net().mean_length());
}

std::vector<Handle> pull(const Editor& editor, Random& random) {
    return moved(editor, random, 0.3 * extent(editor.net()));
}

std::vector<Handle> overstretch(const Editor& editor, Random& random) {
    return moved(editor, random, 10 * extent(editor.net()));
}

/// To where the hand of a person never gets, but a file or a program may.
std::vector<Handle> banish(const Editor& editor, Random& random) {
    return moved(editor, random, std::pow(10, real(random, 2, 300)));
}

std::vector<Handle> gather(const Editor& editor, Random& random) {
    std::vector<Handle> handles = editor.handles();
    const Eigen::Vector3d place = handles[random() % handles.size()].target;
    for (Handle& handle : handles) handle.target = place;
    return handles;
}

std::vector<Handle> line_up(const Editor& editor, Random& random) {
    std::vector<Handle> handles = editor.handles();
    const Eigen::Vector3d from = handles[0].target, along = direction(random);
    for (Handle& handle : handles) handle.target = from + along * along.dot(handle.target - from);
    return handles;
}

std::vector<Handle> swap(const Editor& editor, Random& random) {
    std::vector<Handle> handles = editor.handles();
    for (std::size_t i = handles.size(); i > 1; --i) std::swap(handles[i - 1].target, handles[random() % i].target);
    return handles;
}

/// From rest, all as one body.
std::vector<Handle> turn(const Editor& editor, Random& random) {
    std::vector<Handle> handles = editor.handles();
    const Eigen::AngleAxisd rotation(real(random, 0, EIGEN_PI), direction(random));
    const Eigen::Vector3d shift = real(random, 0, 3) * extent(editor.net()) * direction(random);
    const Eigen::Vector3d centre = editor.net().rest_positions().rowwise().mean();
    for (Handle& handle : handles)
        handle.target = centre + rotation * (editor.net().rest_positions().col(handle.vertex) - centre) + shift;
    return handles;
}

constexpr EditKind k_edit_kinds[] = {
    {"nudge", 6, nudge},   {"pull", 6, pull},     {"overstretch", 2, overstretch},
    {"banish", 1, banish}, {"gather", 1, gather}, {"line up", 1, line_up},
    {"swap", 1, swap},     {"turn", 2, turn},     {"go home", 4, go_home},
};

}  // namespace

std::span<const EditKind> edit_kinds() { return k_edit_kinds; }

const EditKind& random_edit_kind(Random& random) {
    int total = 0;
    for (const EditKind& kind : k_edit_kinds) total += kind.weight;
    int left = static_cast<int>(random() % static_cast<unsigned>(total));
    for (const EditKind& kind : k_edit_kinds)
        if ((left -= kind.weight) < 0) return kind;
    return k_edit_kinds[0];
}

Options random_behaviour(Random& random) {
    Options options;
    if (random() % 2 == 0) return options;
    options.shear_limit = std::vector{0.0, 30.0, 45.0, 60.0}[random() % 4] * k_degree;
    options.straight_rods = random() % 3 == 0;
    if (random() % 3 == 0) options.bending_weight = std::pow(10, real(random, -2, 2));
    if (random() % 3 == 0) options.shear_weight = random() % 2 == 0 ? 0 : std::pow(10, real(random, -3, 1));
    if (random() % 4 == 0) options.gravity = std::pow(10, real(random, -4, 0));
    return options;
}

namespace {

/// At least one stays exact.
void make_some_otherwise(std::vector<Handle>& handles, std::string_view method, Random& random) {
    const auto table = method_table();
    const auto info = std::ranges::find_if(table, [&](const MethodInfo& each) { return each.name == method; });
    for (std::size_t i = 1; i < handles.size(); ++i) {
        const auto kind = random() % 3;
        if (kind == 0 && info->heeds.pulls) handles[i].weight = std::pow(10, real(random, -2, 2));
        if (kind == 1 && info->heeds.slides) handles[i].slides = 1 + static_cast<Axes>(random() % 6);
    }
}

}  // namespace

std::vector<Handle> random_handles(const Net& net, std::string_view method, Random& random) {
    std::vector<int> vertices(static_cast<std::size_t>(net.vertex_count()));
    std::iota(vertices.begin(), vertices.end(), 0);
    std::shuffle(vertices.begin(), vertices.end(), random);
    const std::size_t wanted = random() % 8 == 0 ? 1 + random() % vertices.size() : 1 + random() % 8;
    vertices.resize(std::min(wanted, vertices.size()));
    std::vector<Handle> handles;
    for (int v : vertices) handles.push_back({v, net.rest_positions().col(v)});
    if (random() % 3 == 0) make_some_otherwise(handles, method, random);
    return handles;
}

Manner random_manner(Random& random) {
    Manner manner;
    manner.drags = random() % 3 == 0;
    if (random() % 5 == 0) manner.radius = std::pow(10, real(random, 0, 1.5));
    if (random() % 2 == 0) manner.iterations = 1 + static_cast<int>(random() % 12);
    if (random() % 4 == 0) manner.along = 1 + static_cast<Axes>(random() % 7);
    return manner;
}

}  // namespace chebnet::soak
