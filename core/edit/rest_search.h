#pragma once

#include <cstddef>
#include <limits>

#include "edit/edit_state.h"
#include "edit/editor.h"
#include "solve/trace.h"

namespace chebnet {

/// How far a search for a net that is less strained has come.
struct RestSearchReport {
    Status status = Status::running;
    double done = 0;                                                 ///< 0 … 1, about
    double energy_before = std::numeric_limits<double>::infinity();  ///< of the net as it was; infinite: it was none
    double energy = std::numeric_limits<double>::infinity();         ///< the least found so far
    int iterations = 0;                                              ///< since the beginning
    double milliseconds = 0;                                         ///< likewise
};

/// For an edit that has several equilibria, where local folds have snapped one way or the other: `equilibrium` keeps
/// the one that the present shape leads to, and how the hand has moved decides which that is. This looks for others
/// with less energy, by ways that lead past such folds: from the rest shape at once and in steps, and from the best net
/// so far with stiffer lines and without the limit of the corners for a while. None of them is sure to find the least.
class RestSearch {
public:
    /// From where the editor is, of which nothing is kept. Throws Error bad_option for another method than
    /// `equilibrium`.
    explicit RestSearch(const Editor& editor);

    /// Goes on until it ends or the budget runs out (status `running`; call again to go on). Ends as
    ///
    ///   converged     a net with less energy is found, at rest, or as near to rest as was found
    ///   unreachable   none is
    RestSearchReport solve(const Budget& budget = {});

    /// What to set the editor to. Throws Error bad_option unless converged.
    EditState state() const;

private:
    struct Way;
    static const Way k_ways[];

    void iterate();
    void begin_step();
    void end_way(Status status);
    void move_handles(double part, EditState& state) const;
    double energy() const;

    Editor m_editor;    // tries
    EditState m_asked;  // as the other editor was
    EditState m_best;   // the net of least energy so far
    std::size_t m_way = 0;
    int m_step = 0;  // of the way, from 0
    RestSearchReport m_report;
};

}  // namespace chebnet
