#pragma once

#include <memory>
#include <utility>

#include "solve/method.h"

namespace chebnet::samples {

/// A method that counts how often its symbolic work is done.
class CountingMethod : public Method {
public:
    CountingMethod(std::unique_ptr<Method> method, int& prepared) : m_method(std::move(method)), m_prepared(prepared) {}
    void prepare(const Net& net, const Topology& topology, std::span<const int> fixed) override {
        ++m_prepared;
        m_method->prepare(net, topology, fixed);
    }
    bool knows_holds() const override { return m_method->knows_holds(); }
    void set_holds(std::span<const Hold> holds) override { m_method->set_holds(holds); }
    Status start(Positions& x, const Options& options, bool reachable) override {
        return m_method->start(x, options, reachable);
    }
    Status iterate(Positions& x, TraceRow& row) override { return m_method->iterate(x, row); }

private:
    std::unique_ptr<Method> m_method;
    int& m_prepared;
};

}  // namespace chebnet::samples
