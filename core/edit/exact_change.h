#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/angle.h"
#include "change/change.h"
#include "edit/equalize.h"

namespace chebnet {

struct ExactChangeOptions {
    std::optional<double> length{};  ///< of all edges of the net before; none: each has its own, and keeps what it gets
    std::vector<int> held{};         ///< vertices of the net before that stay where they are, if a net is found so
    double shear_limit = k_usual_shear_limit;  ///< as EqualizeOptions has it
};

struct ExactChangeReport {
    Status status = Status::running;
    int iterations = 0;  ///< since the beginning
};

/// Makes a changed net exact: its edges get the length of before times the change's factor, near the shape that it has
/// (Equalizer), or by `projection` where nothing but lost digits is to be found. First with the vertices held that are
/// left of those to be; where no net is found so, with all of it free. A net with corners sharper than the limit,
/// status `exact`, is one: what is held does not move for their sake. A net whose edges have a length each is left as
/// the change made it.
class ExactChange {
public:
    /// Throws what Equalizer throws.
    explicit ExactChange(ChangedMesh changed, ExactChangeOptions options = {});

    /// Goes on until it ends or the budget runs out (status `running`); each of the two ways has a budget of its own.
    /// Never throws over a hard problem, and ends as Equalizer::solve() does.
    ExactChangeReport solve(const Budget& budget = {});

    /// 3×V, in the order of the changed mesh: exact once the status is `converged` or `exact`.
    const Positions& positions() const;

private:
    std::vector<int> held_vertices() const;
    void begin(std::vector<int> handles);

    ChangedMesh m_changed;
    ExactChangeOptions m_options;
    std::unique_ptr<Equalizer> m_equalizer;  // null: each edge has its own length
    bool m_holds = false;
    int m_iterations_held = 0;  // of the way that was given up
};

}  // namespace chebnet
