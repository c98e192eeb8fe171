#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "net/net.h"
#include "solve/parts/alternating_step.h"
#include "solve/parts/laplacian_part.h"
#include "solve/trace.h"

namespace chebnet {

/// One line of the table of initialisations.
struct InitialisationInfo {
    const char* name;  ///< if it is counted, the text is name:N
    bool counted;
    const char* sentence;
    const char* citation;
};
std::span<const InitialisationInfo> initialisation_table();

/// What is done to the positions before a method starts (Li et al. 2022, section 4; the paper does five iterations):
///
///   naive           nothing: handles have jumped to their targets, all else stays
///   arap:N          N iterations of ARAP (ArapStep)
///   local_global:N  N iterations of local–global (LocalGlobalStep)
///
/// The linear system is factored once for a set of handles.
class Initialisation {
public:
    /// From text as above, 1 ≤ N ≤ 10000. Throws Error bad_option.
    explicit Initialisation(std::string_view text = "naive");

    const std::string& name() const { return m_name; }

    /// Does the symbolic and numeric work for a set of fixed vertices. The net must outlive this.
    void prepare(const Net& net, std::span<const int> fixed);
    /// Moves free vertices of `positions` (3×V), whose handles stand at their targets. Leaves them if the result would
    /// not be finite. Returns a row for each iteration: stage 0, the last one's number is 0, times from the beginning
    /// of this call. Only after prepare().
    Trace apply(Positions& positions);

private:
    TraceRow row_of(int iteration, const Positions& positions) const;

    std::string m_name;
    MakeAlternatingStep m_make_step = nullptr;  // null: naive
    int m_iterations = 0;
    std::unique_ptr<LaplacianPart> m_part;
    std::unique_ptr<AlternatingStep> m_step;
};

}  // namespace chebnet
