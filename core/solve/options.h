#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/angle.h"

namespace chebnet {

/// What a guide does to a net (see Problem::guide).
enum class GuideMode {
    off,
    near,     ///< the net is drawn to it
    on,       ///< likewise, as strongly as makes the rest give way
    outside,  ///< the net does not go below it: into a closed piece, or to where an open one's normals do not point
};
inline constexpr int k_guide_modes = 4;
/// But for mode `outside`, which keeps out each vertex for itself, Options::guide_weight is that of so many vertices
/// together: a net of more is drawn as a whole as strongly. If each were drawn for itself, a fine net would rather
/// crumple than leave the guide with a handle.
inline constexpr double k_guided_vertices = 50;

/// The settings of the solvers: those of the paper's method have its names, and about half are those of `equilibrium`.
/// Every method reads what applies to it, see reads().
struct Options {
    double threshold = 1e-6;            ///< ε_3: converged when max dL is below
    double energy_tolerance = 1e-6;     ///< ε_1: a stage ends when the energy changes by less than this, relatively
    double gradient_tolerance = 1e-6;   ///< ε_2: a stage ends when ‖∇E‖ (in units of 1 / mean length) is below
    int max_iterations = 200;           ///< for one solve
    double p_start = 2;                 ///< exponent of stage 1
    double p_end = 50;                  ///< exponent of stages 2 and 3; the only one if adaptive_p is off
    bool adaptive_p = true;             ///< section 3.3: p_start first, then p_end
    double switch_deviation = 1e-2;     ///< ε_dL1: p_start until max dL is below
    bool adaptive_reduction = true;     ///< section 3.3: in stage 3 only the vertices near bad edges stay free
    double reduction_deviation = 1e-4;  ///< ε_dL2: all vertices free until max dL is below
    double active_fraction = 0.25;      ///< ε_4 = active_fraction · ε_3: edges with a larger dL keep their ends free
    int active_rings = 2;               ///< and so many rings of neighbours around them
    bool reduce_once = false;           ///< section 3.3 to the letter: these vertices are chosen once, and stay
    bool direct_energy = false;         ///< li2022 minimises E_p (eq. 2) itself in place of energy (3)
    /// equilibrium: no corner of a quad is sharper, radians (degrees in texts); 0: no limit
    double shear_limit = k_usual_shear_limit;
    double bending_weight = 1;    ///< equilibrium: of BendingTerm
    double shear_weight = 0.05;   ///< equilibrium: of ShearTerm
    double tip_weight = 0;        ///< equilibrium: of TipTerm
    bool straight_rods = false;   ///< equilibrium: net lines want to be straight rather than as at rest
    double rod_curvature = 0;     ///< equilibrium: to which net lines were bent beforehand, 1 / length; 0: not
    double warp_stiffness = 1;    ///< equilibrium: factor of bending_weight for the first family of net lines,
    double weft_stiffness = 1;    ///< and for the second; of no effect where there are not two (edge_families())
    bool square_corners = false;  ///< equilibrium: quads want right angles rather than those at rest
    double gravity = 0;           ///< equilibrium: the weight of an edge, see GravityTerm
    bool y_up = false;            ///< equilibrium: weight acts downwards along y rather than z
    GuideMode guide_mode = GuideMode::near;  ///< equilibrium: of no effect without a guide
    double guide_weight = 0.3;               ///< equilibrium: of ClosenessTerm, see k_guided_vertices
    double rest_tolerance = 1e-4;            ///< equilibrium: at rest when the gradient that constraints leave is below
    double length_scale = 1;                 ///< every edge is to be so many times as long as in the net as it came

    bool operator==(const Options&) const = default;
};

/// Against which weight acts.
inline int up_axis(const Options& options) { return options.y_up ? 1 : 2; }

/// Sets one option from text, e.g. set_option(o, "p_end", "30") or ("adaptive_p", "off"). Booleans take
/// on/off/true/false/1/0. Throws Error bad_option, naming the known options or the range, if key or value are not
/// valid.
void set_option(Options& options, std::string_view key, std::string_view value);

/// Throws Error bad_option, naming the range, for the first option that is out of it.
void check_options(const Options& options);

enum class OptionKind { number, integer, flag };
/// The name of the enumerator.
const char* to_string(OptionKind kind);

/// One line for each option, for help texts and the page. Its default is what get_option() says of Options{}.
struct OptionInfo {
    const char* name;
    OptionKind kind;
    double smallest, largest;  ///< of the number that a text has for it
    const char* sentence;
};
std::span<const OptionInfo> option_table();
/// The value of an option as the number that a text has for it (flags as 0 or 1; angles in degrees). Throws Error
/// bad_option for an unknown name.
double get_option(const Options& options, std::string_view key);

}  // namespace chebnet
