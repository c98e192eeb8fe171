#include "solve/parts/alternating.h"

#include <cmath>

#include "base/stopwatch.h"
#include "net/measures.h"
#include "solve/parts/degenerate_edges.h"
#include "solve/parts/stopping.h"

namespace chebnet {

void Alternating::prepare(const Problem& problem) {
    m_net = &problem.net;
    m_topology = &problem.topology;
    m_is_free = free_vertices(m_net->vertex_count(), problem.fixed);
    m_part = std::make_unique<LaplacianPart>(*m_net, m_is_free);
    m_step = m_make_step(*m_part);
}

Status Alternating::start(const Problem& problem, Positions& positions, const Options& options) {
    m_options = options;
    m_reachable = problem.reachable;
    open_degenerate_edges(*m_net, *m_topology, m_is_free, positions);
    measure(positions);
    if (m_max_deviation < m_options.threshold) return Status::converged;
    if (!std::isfinite(m_energy)) return Status::non_finite;
    return m_part->part().size() == 0 ? ended(m_reachable) : Status::running;
}

Status Alternating::iterate(Positions& positions, TraceRow& row) {
    const Positions origin = positions;
    const double energy_before = m_energy;
    Stopwatch watch;
    row.gradient_norm = m_step->fit(positions) / m_net->mean_length();
    row.factorisation_ms = watch.milliseconds();
    const bool finite = positions.allFinite();
    if (!finite) positions = origin;

    watch.restart();
    measure(positions);
    row.assembly_ms = watch.milliseconds();
    row.stage = 1;
    row.energy = m_energy;
    row.max_deviation = m_max_deviation;
    row.step = finite ? 1 : 0;
    row.free_vertices = m_part->part().size();

    if (!finite) return Status::non_finite;
    if (m_max_deviation < m_options.threshold) return Status::converged;
    const bool settled = has_settled(m_options, m_reachable, energy_before, m_energy, row.gradient_norm);
    return settled ? ended(m_reachable) : Status::running;
}

/// Does the local half at the present positions, and measures what it leaves.
void Alternating::measure(const Positions& positions) {
    m_step->project(positions);
    m_energy = m_step->energy(positions) / (m_net->mean_length() * m_net->mean_length());
    m_max_deviation = max_deviation(*m_net, positions);
}

}  // namespace chebnet
