#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/options.h"
#include "solve/pull.h"
#include "solve/terms/term.h"

namespace chebnet {

class Guide;

/// The energy that a net at rest has least of: bending of net lines and shear, both counted from a rest shape; tips at
/// singular vertices; its weight; closeness to a guide; the pull of soft handles.
class RestEnergy {
public:
    /// What Options::shear_limit is: a constraint, which is none of the energy's, or where no net keeps it a term, by
    /// which corners beyond it share what they lack.
    enum class Limit { is_kept, gives_way };

    /// Whether both options ask for the same energy, and for the same limit of the corners.
    static bool is_the_same(const Options& a, const Options& b);
    /// Whether a guide is one of its terms. Null: there is none.
    static bool is_guided(const Options& options, const Guide* guide);
    /// Whether the rest shape is where it is least if nothing deforms it, wherever and however turned it stands.
    static bool is_least_at_rest_shape(const Options& options, std::span<const Pull> pulls, const Guide* guide);

    /// Takes its terms anew. `guide`: null if there is none; `unit`: of the net, in that of the guide and of the
    /// options' lengths; `weightless`: see GravityTerm. Keeps references.
    void choose(const Net& net, const Topology& topology, const Positions& rest_shape, const Options& options,
                std::span<const Pull> pulls, const Guide* guide, double unit, const std::vector<bool>& weightless,
                Limit limit);
    /// The same pulls to other targets.
    void move_pulls(const Net& net, std::span<const Pull> pulls);
    bool is_chosen() const { return !m_terms.empty(); }
    void forget() { m_terms.clear(); }

    /// At `x` (3×V), with its gradient there.
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient);
    /// That of each term, at the last positions.
    std::span<const double> values() const { return m_values; }
    std::span<const std::unique_ptr<Term>> terms() const { return m_terms; }

private:
    std::vector<std::unique_ptr<Term>> m_terms;  // that of pulls, if there are any, is the last
    std::vector<double> m_values;
};

}  // namespace chebnet
