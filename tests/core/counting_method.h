#pragma once

#include <memory>
#include <utility>

#include "solve/method.h"

namespace chebnet::samples {

/// A method that counts how often its symbolic work is done.
class CountingMethod : public Method {
public:
    CountingMethod(std::unique_ptr<Method> method, int& prepared) : m_method(std::move(method)), m_prepared(prepared) {}
    void prepare(const Problem& problem) override {
        ++m_prepared;
        m_method->prepare(problem);
    }
    Heeds heeds() const override { return {.pulls = m_method->heeds().pulls}; }
    Status start(const Problem& problem, Positions& x, const Options& options) override {
        return m_method->start(problem, x, options);
    }
    Status iterate(Positions& x, TraceRow& row) override { return m_method->iterate(x, row); }

private:
    std::unique_ptr<Method> m_method;
    int& m_prepared;
};

}  // namespace chebnet::samples
