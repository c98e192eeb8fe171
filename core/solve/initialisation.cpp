#include "solve/initialisation.h"

#include <charconv>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "net/measures.h"
#include "solve/parts/arap_step.h"
#include "solve/parts/local_global_step.h"

namespace chebnet {

namespace {

constexpr int k_most_iterations = 10000;

constexpr InitialisationInfo k_initialisations[] = {
    {"naive", false, "Nothing: handles jump to their targets, all else stays.",
     "Li, Guo, Wang, Chai, Liu, Fu: Interactive Editing of Discrete Chebyshev Nets. Computer Graphics Forum 41(2), "
     "2022, section 4"},
    {"arap", true, "A few iterations of ARAP first: the net follows its handles as rigidly as it can.",
     "Sorkine, Alexa: As-Rigid-As-Possible Surface Modeling. Symposium on Geometry Processing 2007"},
    {"local_global", true, "A few iterations of local-global first: edges are pulled towards their lengths.",
     "Bouaziz, Deuss, Schwartzburg, Weise, Pauly: Shape-Up: Shaping Discrete Geometry with Projections. Computer "
     "Graphics Forum 31(5), 2012"},
};

/// N of a text "N"; 0 if it is none within the limits.
int parse_iterations(std::string_view text) {
    int n = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    const bool valid = error == std::errc() && stop == text.data() + text.size() && n <= k_most_iterations;
    return valid && n > 0 ? n : 0;
}

}  // namespace

std::span<const InitialisationInfo> initialisation_table() { return k_initialisations; }

Initialisation::Initialisation(std::string_view text) : m_name(text) {
    if (text == "naive") return;
    const std::size_t colon = text.find(':');
    const std::string_view kind = text.substr(0, colon);
    if (kind == "arap") m_make_step = make_alternating_step<ArapStep>;
    if (kind == "local_global") m_make_step = make_alternating_step<LocalGlobalStep>;
    if (m_make_step != nullptr && colon != std::string_view::npos)
        m_iterations = parse_iterations(text.substr(colon + 1));
    if (m_iterations == 0)
        throw Error(ErrorCode::bad_option, "initialisation must be naive, arap:N or local_global:N with N from 1 to " +
                                               std::to_string(k_most_iterations) + ", not " + quoted(text));
}

void Initialisation::prepare(const Net& net, std::span<const int> fixed) {
    if (m_make_step == nullptr) return;
    m_part = std::make_unique<LaplacianPart>(net, free_vertices(net.vertex_count(), fixed));
    m_step = m_make_step(*m_part);
}

Trace Initialisation::apply(Positions& positions) {
    const Stopwatch watch;
    Trace trace;
    Positions moved = positions;
    for (int k = 1; k <= m_iterations; ++k) {
        m_step->iterate(moved);
        trace.push_back(row_of(k - m_iterations, moved));
        trace.back().total_ms = watch.milliseconds();
    }
    if (!moved.allFinite()) return {};
    positions = std::move(moved);
    return trace;
}

TraceRow Initialisation::row_of(int iteration, const Positions& positions) const {
    const Net& net = m_part->net();
    TraceRow row;
    row.iteration = iteration;
    row.energy = m_step->energy(positions) / (net.mean_length() * net.mean_length());
    row.max_deviation = max_deviation(net, positions);
    row.step = 1;
    row.free_vertices = m_part->part().size();
    return row;
}

}  // namespace chebnet
