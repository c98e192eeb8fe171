#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "net/mesh.h"
#include "net/net.h"
#include "remesh/phase_clock.h"
#include "remesh/quad_mesher.h"
#include "remesh/remesh.h"
#include "remesh/singular_wishes.h"
#include "surface/guide.h"

namespace chebnet {

/// A net that a mesh of quads has been fitted to.
struct TriedNet {
    Net net;
    std::vector<SingularVertex> singular;
    KeptWishes kept;
    double distance;  ///< from the surface, in edges, on average
};

/// Tries meshes of one surface, along fields smoother and less smooth and with cells of other sizes, until one becomes
/// the net that is asked for. All errors by which a trial ends but too_large only mean that it has failed.
class NetTrials {
public:
    /// They all have to outlive it. A mesh whose edges err by more than `most_error` (evened_error()) is not fitted,
    /// nor any that would be tried after it; infinity: all are.
    NetTrials(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, QuadMesher& mesher,
              PhaseClock& clock, double most_error)
        : m_guide(guide), m_options(options), m_mesher(mesher), m_clock(clock), m_most_error(most_error) {}

    /// The first that is as it should be, or the best of some that are not quite so; nothing where no net is found.
    std::optional<TriedNet> best();
    /// Only one that is as it should be; what else is tried on the way is forgotten.
    std::optional<TriedNet> good();
    /// Of few cells, with the usual smoothing, to try something.
    std::optional<Net> small();
    /// Whether a mesh with edges too uneven for a net has ended the trials.
    bool were_uneven() const { return m_is_uneven; }
    /// Why there is none, after best() has found nothing.
    [[noreturn]] void refuse() const;

private:
    /// Which of them a fit follows otherwise than usual.
    struct Lines {
        bool suits_creases = false, lets_border_go = false;
    };

    bool find_good();
    bool try_with_lines();
    bool try_all();
    bool try_once(double size, double smoothing, bool turns);
    TriedNet fitted(const Mesh& mesh, double length, Lines lines);
    std::optional<TriedNet> with_loose_border(const Mesh& mesh, const TriedNet& found);
    std::optional<TriedNet> following_creases(const Mesh& mesh, const TriedNet& found);
    bool keeps_limit(const TriedNet& found) const;
    bool is_uneven(const Mesh& mesh) const;

    const std::shared_ptr<const Guide>& m_guide;
    const RemeshOptions& m_options;
    QuadMesher& m_mesher;
    PhaseClock& m_clock;
    double m_most_error;
    bool m_is_uneven = false;  // the last mesh
    std::vector<TriedNet> m_tried;
    std::string m_first_failure;
    std::optional<Error> m_too_many_lines;
};

}  // namespace chebnet
