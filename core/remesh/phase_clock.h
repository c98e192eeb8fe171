#pragma once

#include <array>
#include <optional>

#include "base/stopwatch.h"
#include "remesh/remesh.h"

namespace chebnet {

/// Tells how far a net on a whole surface has come, and measures how long each phase takes.
class PhaseClock {
public:
    /// `progress`, which may be empty, has to outlive it.
    explicit PhaseClock(const RemeshProgress& progress) : m_progress(progress) {}

    /// A phase ends where another begins.
    void begin(RemeshPhase phase) {
        if (m_stands_at) return;
        end();
        m_phase = phase;
        tell(0);
    }
    void tell(double done) const {
        if (m_progress) m_progress(m_phase, m_stands_at.value_or(done));
    }
    void end() {
        m_milliseconds[static_cast<int>(m_phase)] += m_watch.milliseconds();
        m_watch.restart();
    }

    /// Until go_on(), the present phase has come this far, whatever begins meanwhile: all of that is part of it.
    void stand_at(double done) { m_stands_at = done; }
    void go_on() { m_stands_at.reset(); }

    const std::array<double, k_remesh_phases>& milliseconds() const { return m_milliseconds; }

private:
    const RemeshProgress& m_progress;
    RemeshPhase m_phase = RemeshPhase::triangles;
    std::optional<double> m_stands_at;
    Stopwatch m_watch;
    std::array<double, k_remesh_phases> m_milliseconds{};
};

}  // namespace chebnet
