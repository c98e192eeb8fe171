#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "net/mesh.h"
#include "net/net.h"
#include "shapes/shapes.h"

namespace chebnet {

/// The values of one shape's parameters, each within its range.
class Values {
public:
    explicit Values(std::span<const ShapeParameter> parameters);
    /// `name` must be one of the parameters.
    double operator[](std::string_view name) const { return m_values[index(name)]; }
    double& operator[](std::string_view name) { return m_values[index(name)]; }

private:
    std::size_t index(std::string_view name) const;

    std::span<const ShapeParameter> m_parameters;
    std::vector<double> m_values;
};

/// One kind of shape: its line of the gallery, and how it is made.
struct Family {
    ShapeInfo info;
    Shape (*make)(const Values& values) = nullptr;  ///< null in a build that has the words only
};

extern const Family k_vault, k_dome, k_tube, k_torus, k_jack, k_steps, k_elephant, k_teddy, k_rabbit, k_horse, k_jug,
    k_shirt, k_sheet, k_saddle, k_canopy, k_vase, k_wave, k_scroll;

/// In the order of the gallery and help: smooth ones before figures of blocks.
inline constexpr const Family* k_families[] = {&k_dome,   &k_saddle, &k_canopy, &k_vault,    &k_wave,  &k_sheet,
                                               &k_scroll, &k_tube,   &k_vase,   &k_shirt,    &k_teddy, &k_rabbit,
                                               &k_horse,  &k_jug,    &k_steps,  &k_elephant, &k_jack,  &k_torus};

/// The parameter that every family has.
constexpr ShapeParameter vertices_parameter(double value) {
    return {"vertices", value, 100, 100000, "About how many vertices the net has."};
}

/// The parameter of figures of blocks that can also be had smooth.
constexpr ShapeParameter smooth_parameter() {
    return {"smooth", 0, 0, 1, "1: smooth but for cones at the corners; 0: of blocks."};
}
/// The parameter of smooth figures whose cones can be rounded: as they were before that, unless it is given.
constexpr ShapeParameter rounding_parameter() {
    return {"rounding", 0, 0, 1, "How far cones are rounded, where three, five or six edges meet; 1: no sharp fold."};
}
constexpr bool is_on(double value) { return value >= 0.5; }

/// The net of `surface`, whose edges all have one length, 10 units across, centred over the origin and standing on the
/// ground z = 0.
Net place_net(Mesh surface);

}  // namespace chebnet
