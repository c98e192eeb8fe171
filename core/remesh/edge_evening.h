#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "edit/rods.h"
#include "linear/graph_system.h"
#include "net/net.h"
#include "net/topology.h"
#include "remesh/fit.h"
#include "remesh/rails.h"
#include "solve/pull.h"
#include "surface/guide.h"

namespace chebnet {

/// Brings the edges of a mesh of quads nearer to one length, while its vertices slide over a surface and along rails
/// and corners stay open: Gauss–Newton steps.
class EdgeEvening {
public:
    /// `options`: its length, limit and pulls. `rods`: how those of the net are to be laid in the end. All but these
    /// have to outlive it.
    EdgeEvening(const Guide& guide, const Net& mesh, const Topology& topology, const FitOptions& options,
                const Rails& rails, Rods rods);

    /// Until that hardly brings lengths nearer to each other any more. `go_on`: is told the part of the steps that is
    /// done before each, and may end it all by an exception.
    void run(const std::function<void(double)>& go_on);
    /// The same for a few steps.
    void try_out(const std::function<void(double)>& go_on);

    const Positions& positions() const { return m_positions; }
    /// L, that of the options, or the one that fits.
    double length() const { return m_length; }
    /// Of lengths, root mean square, in L.
    double length_error() const;

private:
    struct Bar {
        int a, b, link;
    };
    /// x_a − 2 x_b + x_c and the links of its three pairs.
    struct Bend {
        int a, b, c, link_ab, link_bc, link_ac;
        bool is_kink;  // where a line crosses one from a singular vertex
    };
    /// How edges are evened out.
    struct Evening {
        double straight;  // weight of the second difference of a net line
        int most_steps;
        int straight_steps;  // after these kinks may come about beside lines from singular vertices; −1: never
        int last_steps;      // it ends when so many leave more than this part of the error of lengths
        double least_gain;
        double open;             // corners are kept open by so much more than the limit, in radians
        double limit_stiffness;  // beside edges that weigh 1
        double inertia;          // what a step costs: nothing else keeps vertices from drifting along the surface
    };
    static Evening evening_for(Rods rods);

    void find_bars();
    void find_bends();
    void add_bend(int a, int b, int c, bool is_kink);
    int link(int a, int b);
    Eigen::Matrix2Xi links() const;
    void run(int most_steps, const std::function<void(double)>& go_on);
    double fitting_length() const;
    Eigen::Vector3d vector(const Bar& bar) const;
    void step();
    void draw_to_surface();
    void draw_to(const Rail& rail);
    void draw_to_points();
    void straighten(const Bend& bend);
    void pull(const Bar& bar, double rest, double weight);

    const Guide& m_guide;
    const Net& m_mesh;
    const Topology& m_topology;
    const FitOptions& m_options;
    const Rails& m_rails;
    Evening m_evening;
    double m_length;
    Positions m_positions;
    std::vector<int> m_guess;  // of each vertex the triangle it was last above; −1: none yet
    std::vector<Pull> m_pulls;
    std::map<std::pair<int, int>, int> m_links;
    std::vector<Bar> m_edges, m_diagonals;
    std::vector<Bend> m_bends;
    bool m_has_kinks = false;
    std::unique_ptr<SingleBlockSystem> m_system;
    Eigen::Matrix3Xd m_force;
};

}  // namespace chebnet
