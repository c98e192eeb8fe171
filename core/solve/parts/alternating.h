#pragma once

#include <array>
#include <memory>
#include <vector>

#include "solve/method.h"
#include "solve/parts/alternating_step.h"
#include "solve/parts/laplacian_part.h"

namespace chebnet {

/// Iterates an AlternatingStep until the lengths are right or its energy settles. Energy and gradient of the trace are
/// in units of the mean length; it has one stage and no exponent.
class Alternating : public Method {
public:
    explicit Alternating(MakeAlternatingStep make_step) : m_make_step(make_step) {}

    void prepare(const Problem& problem) override;
    Status start(const Problem& problem, Positions& positions, const Options& options) override;
    Status iterate(Positions& positions, TraceRow& row) override;

private:
    void measure(const Positions& positions);

    MakeAlternatingStep m_make_step;
    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    std::vector<bool> m_is_free;
    std::unique_ptr<LaplacianPart> m_part;
    std::unique_ptr<AlternatingStep> m_step;  // has seen the present positions
    Options m_options;
    bool m_reachable = true;
    double m_energy = 0;         // at the present positions, in units of the mean length
    double m_max_deviation = 0;  // likewise
};

/// What its one stage is called.
inline constexpr std::array k_alternating_names{"Alternating"};

}  // namespace chebnet
