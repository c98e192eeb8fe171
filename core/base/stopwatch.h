#pragma once

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#else
#include <chrono>
#endif

namespace chebnet {

/// Milliseconds since it was made or last restarted.
class Stopwatch {
public:
    double milliseconds() const { return now() - m_start; }
    void restart() { m_start = now(); }

private:
    /// By JavaScript in WebAssembly, where the clock of the standard library would add its error messages to the
    /// module.
    static double now() {
#ifdef __EMSCRIPTEN__
        return emscripten_get_now();
#else
        const auto since = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration<double, std::milli>(since).count();
#endif
    }

    double m_start = now();
};

}  // namespace chebnet
