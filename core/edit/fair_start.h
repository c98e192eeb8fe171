#pragma once

#include <memory>
#include <vector>

#include "edit/rods.h"
#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/free_part.h"
#include "solve/parts/term_descent.h"
#include "solve/pull.h"
#include "solve/terms/term.h"
#include "surface/guide.h"

namespace chebnet {

/// From a mesh with unequal edges to a net near its surface: the least of the bending of its lines and of its distance
/// from the surface, with edges and corners drawn towards what they are to be, and then projected onto the lengths.
/// What is nearly fair and nearly exact crumples no more.
class FairStart {
public:
    /// What becomes of the net's unit.
    enum class Size {
        kept,
        by_lengths,  ///< it changes so that edges have their lengths on the average
        by_places,   ///< it changes so that the net, as a shape of any size, lies nearest to where it began
    };
    struct Options {
        std::vector<int> fixed;   ///< vertices that stay where they are
        std::vector<Pull> pulls;  ///< of others, in the net's unit
        double unit = 1;          ///< of the net, in the guide's
        double shear_limit = 0;   ///< radians; 0: none
        Size size = Size::kept;
        Rods rods = Rods::straight;
        double tip_weight = 0;  ///< of TipTerm, beside bending that weighs 1
    };

    /// `net`: with the lengths that edges are to have; it begins at `positions` (3×V). Keeps references to net,
    /// topology and guide. Throws Error too_large.
    FairStart(const Net& net, const Topology& topology, const Guide& guide, Positions positions, Options options);

    /// From now on others than those of the options, in the net's unit of the moment.
    void set_pulls(std::vector<Pull> pulls);
    /// One step. False when it has come as far as it needs to.
    bool step();
    /// Whether that has led to a net, dL < `threshold` and as near to 0 as can be; else the positions stay.
    bool make_exact(double threshold);

    const Positions& positions() const { return m_positions; }
    double unit() const { return m_options.unit; }

private:
    void choose_terms();
    void set_unit(double unit);
    void fit_lengths();
    void fit_places();

    const Net& m_net;
    const Topology& m_topology;
    const Guide& m_guide;
    Options m_options;
    Positions m_laid;  // at first, in the guide's unit
    Positions m_positions;
    std::vector<bool> m_is_free;
    FreePart m_part;
    TermDescent m_descent;
    std::vector<std::unique_ptr<Term>> m_terms;
    int m_steps = 0;
};

}  // namespace chebnet
