#pragma once

#include <memory>

#include "net/net.h"
#include "net/topology.h"
#include "solve/method.h"
#include "solve/options.h"
#include "solve/parts/corner_limit.h"
#include "solve/trace.h"

namespace chebnet {

/// The shape from which a net's energy counts: its rest positions or, where these are no net within the limit of
/// corners, the net that they become at rest, without handles. Making that takes steps.
class RestShape {
public:
    /// `opener`: the method that makes it, for nets that count from their rest positions; null: it stays as it is.
    explicit RestShape(MakeMethod opener) : m_opener(opener) {}

    bool is_known() const { return m_positions.cols() > 0; }
    /// 3×V, as far as it has come; empty: not known.
    const Positions& positions() const { return m_positions; }
    void forget();

    /// Begins with the rest positions. Net and topology must last until it is opened. `limit`: what it has to keep.
    void begin(const Net& net, const Topology& topology, const Options& options, const CornerLimit& limit);
    /// Whether it is not yet opened.
    bool is_opening() const { return m_opening != nullptr; }
    /// One step of that, which fills the row. Where no such net is found, the rest shape is what it was.
    void open(TraceRow& row);

private:
    const MakeMethod m_opener;
    std::unique_ptr<Method> m_opening;  // while it is under way
    const Net* m_net = nullptr;         // likewise
    double m_threshold = 0;
    int m_steps = 0;
    Positions m_positions;
};

}  // namespace chebnet
