#include "edit/exact_change.h"

#include <unordered_map>
#include <utility>

namespace chebnet {

ExactChange::ExactChange(ChangedMesh changed, ExactChangeOptions options)
    : m_changed(std::move(changed)), m_options(std::move(options)) {
    if (m_options.length) begin(held_vertices());
}

/// By their numbers in the changed mesh. Of several that were one before, as along a cut, the first.
std::vector<int> ExactChange::held_vertices() const {
    std::unordered_map<int, int> first;
    for (std::size_t v = 0; v < m_changed.origins.size(); ++v)
        first.try_emplace(m_changed.origins[v], static_cast<int>(v));
    std::vector<int> vertices;
    for (const int before : m_options.held)
        if (const auto found = first.find(before); found != first.end()) vertices.push_back(found->second);
    return vertices;
}

void ExactChange::begin(std::vector<int> handles) {
    m_holds = !handles.empty();
    EqualizeOptions options;
    options.choice = EqualLength::given;
    options.length = m_changed.length_factor * *m_options.length;
    options.handles = std::move(handles);
    options.shear_limit = m_options.shear_limit;
    if (m_changed.keeps_edges) options.way = EqualizeWay::lengths;
    Net net(m_changed.mesh.positions, m_changed.mesh.faces, RestLengths::own);
    m_equalizer = std::make_unique<Equalizer>(std::move(net), std::move(options));
}

ExactChangeReport ExactChange::solve(const Budget& budget) {
    if (m_equalizer == nullptr) return {Status::converged, 0};
    const Status status = m_equalizer->advance(budget);
    const bool has_failed = status != Status::running && !keeps_lengths(status);
    if (!has_failed || !m_holds) return {status, m_iterations_held + m_equalizer->iterations()};
    m_iterations_held = m_equalizer->iterations();
    begin({});
    return solve(budget);
}

const Positions& ExactChange::positions() const {
    return m_equalizer == nullptr ? m_changed.mesh.positions : m_equalizer->positions();
}

}  // namespace chebnet
