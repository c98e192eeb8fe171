#include "solve/parts/rest_shape.h"

#include <utility>

#include "net/measures.h"

namespace chebnet {

namespace {

// After so many it is taken as far as it has come.
constexpr int k_most_steps = 100;

}  // namespace

void RestShape::forget() {
    m_positions.resize(3, 0);
    m_opening.reset();
}

/// What the active set would still open is not within the limit, as the energy is to be least there.
void RestShape::begin(const Net& net, const Topology& topology, const Options& options, const CornerLimit& limit) {
    m_positions = net.rest_positions();
    if (m_opener == nullptr || (max_deviation(net, m_positions) < options.threshold &&
                                limit.largest_lack(m_positions) <= CornerLimit::k_tolerance))
        return;
    auto opening = m_opener();
    opening->prepare({net, topology, {}});
    Options of_opening;
    of_opening.threshold = options.threshold;
    of_opening.shear_limit = options.shear_limit;
    if (opening->start({net, topology, {}}, m_positions, of_opening) != Status::running) return;
    m_opening = std::move(opening);
    m_net = &net;
    m_threshold = options.threshold;
    m_steps = 0;
}

void RestShape::open(TraceRow& row) {
    const Status status = m_opening->iterate(m_positions, row);
    if (status == Status::running && ++m_steps < k_most_steps) return;
    if (!(max_deviation(*m_net, m_positions) < m_threshold)) m_positions = m_net->rest_positions();
    m_opening.reset();
}

}  // namespace chebnet
