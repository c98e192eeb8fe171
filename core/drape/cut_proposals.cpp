#include "drape/cut_proposals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "base/error.h"
#include "drape/drape_pieces.h"
#include "drape/sample_points.h"
#include "surface/geodesics.h"

namespace chebnet {

namespace {

constexpr int k_cut_trial_cells = 1000;
constexpr int k_places = 6;
// Of the surface's size: over what faults are gathered, and how far places keep apart.
constexpr double k_gathered = 0.08, k_apart = 0.2;
// How many cuts are tried with the edges asked for.
constexpr std::size_t k_cut_finals = 3;
// A sheared cell counts as so much of an uncovered one, to choose between cuts.
constexpr double k_cut_shear_weight = 0.05;

double size_of(const Surface& surface) {
    return (surface.positions().rowwise().maxCoeff() - surface.positions().rowwise().minCoeff()).norm();
}

DrapedPieces laid(const Surface& surface, const std::vector<CutLine>& cuts, DrapeOptions drape, double length) {
    PiecesOptions options;
    drape.length = length;
    drape.arms = DrapeOptions::Arms::geodesic;
    options.drape = drape;
    options.first_seed = true;
    return drape_pieces(cut_open(surface, cuts), options);
}

double worth(const DrapedPieces& made) { return made.report.coverage - k_cut_shear_weight * made.report.much_sheared; }

// ------------------------------------------------------------------------------------------------------ where it fails

/// Of the cells of a net, their middles and how far their worst corner is from a right angle, as a part of it.
struct Cells {
    Positions middles;
    Eigen::VectorXd shear;
};

Cells cells_of(const Net& net) {
    Cells cells{Positions(3, net.face_count()), Eigen::VectorXd(net.face_count())};
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
            return net.rest_positions().col(face[k % face.size()]);
        };
        cells.middles.col(f).setZero();
        for (std::size_t k = 0; k < face.size(); ++k)
            cells.middles.col(f) += corner(k) / static_cast<double>(face.size());
        const Eigen::Vector3d a = corner(1) - corner(0), b = corner(face.size() - 1) - corner(0);
        const double right = std::numbers::pi / 2;
        cells.shear[f] = std::abs(std::atan2(a.cross(b).norm(), a.dot(b)) - right) / right;
    }
    return cells;
}

/// Samples of a surface, and at each how much a net fails there: 1 where none is, else the shear.
struct Faults {
    std::vector<SurfacePoint> at;
    Positions positions;
    Eigen::VectorXd fault;
};

Faults faults_of(const Surface& surface, const Net& net, double length) {
    const Cells cells = cells_of(net);
    Faults faults;
    const int stride = 1 + (surface.face_count() - 1) / k_samples;
    for (const SamplePoint& sample : sample_points(surface, stride)) faults.at.push_back(sample.at);
    faults.positions.resize(3, std::ssize(faults.at));
    faults.fault.resize(std::ssize(faults.at));
    for (Eigen::Index k = 0; k < std::ssize(faults.at); ++k) {
        faults.positions.col(k) = surface.position_at(faults.at[static_cast<std::size_t>(k)]);
        Eigen::Index nearest = 0;
        const double square =
            (cells.middles.colwise() - faults.positions.col(k)).colwise().squaredNorm().minCoeff(&nearest);
        faults.fault[k] = square > length * length ? 1 : cells.shear[nearest];
    }
    return faults;
}

/// Where most faults are gathered, each place some way from those before it.
std::vector<SurfacePoint> worst_places(const Surface& surface, const Faults& faults) {
    const double near = k_gathered * size_of(surface), apart = k_apart * size_of(surface);
    const Eigen::Index count = faults.positions.cols();
    Eigen::VectorXd gathered(count);
    const auto squares_from = [&](Eigen::Index k) {
        return (faults.positions.colwise() - faults.positions.col(k)).colwise().squaredNorm().eval();
    };
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto weights = (squares_from(k).array() < near * near).cast<double>().matrix().eval();
        gathered[k] = weights.dot(faults.fault) / weights.sum();
    }
    std::vector<SurfacePoint> places;
    while (std::ssize(places) < k_places) {
        Eigen::Index worst = 0;
        if (gathered.maxCoeff(&worst) < 0) break;
        places.push_back(faults.at[static_cast<std::size_t>(worst)]);
        const auto squares = squares_from(worst);
        for (Eigen::Index k = 0; k < count; ++k)
            if (squares[k] < apart * apart) gathered[k] = -1;
    }
    return places;
}

// ------------------------------------------------------------------------------------------------------------ the cuts

/// Points at which a cut may end: on the border, and on cuts before it.
std::vector<SurfacePoint> ends_on(const Surface& surface, const std::vector<CutLine>& cuts) {
    std::vector<SurfacePoint> ends;
    for (const std::vector<int>& loop : surface.boundary_loops())
        for (const int side : loop) ends.push_back(Surface::start_of(side));
    for (const CutLine& cut : cuts) ends.insert(ends.end(), cut.begin(), cut.end());
    return ends;
}

std::vector<CutLine> candidates(const Surface& surface, const SurfaceTree& tree, const std::vector<CutLine>& cuts,
                                const std::vector<SurfacePoint>& places) {
    std::vector<CutLine> lines;
    // As it will be where its points are given again, ends near the border being moved there.
    const auto add = [&](const SurfacePoint& from, const SurfacePoint& to) {
        lines.push_back(cut_line(surface, tree, points_of(surface, {from, to})));
    };
    const std::vector<SurfacePoint> ends = ends_on(surface, cuts);
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) add(places[j], places[i]);
        if (ends.empty()) continue;
        const std::vector<double> distances = geodesic_distances(surface, {{places[i]}});
        const auto distance = [&](const SurfacePoint& end) {
            Eigen::Index corner = 0;
            end.weights.maxCoeff(&corner);
            return distances[surface.triangles()(corner, end.face)];
        };
        add(places[i], *std::min_element(ends.begin(), ends.end(),
                                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); }));
    }
    return lines;
}

struct Trial {
    CutLine line;
    double worth;
};

std::vector<CutLine> with(std::vector<CutLine> cuts, const CutLine& line) {
    cuts.push_back(line);
    return cuts;
}

/// The best first.
std::vector<Trial> tried(const Surface& surface, const std::vector<CutLine>& cuts, const std::vector<CutLine>& lines,
                         const DrapeOptions& options, double length) {
    std::vector<Trial> trials;
    for (const CutLine& line : lines) try {
            trials.push_back({line, worth(laid(surface, with(cuts, line), options, length))});
        } catch (const Error&) {
            continue;  // no way between the two, or no net
        }
    std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.worth > b.worth; });
    return trials;
}

}  // namespace

CutProposals propose_cuts(const Surface& surface, const DrapeOptions& options, int most) {
    const SurfaceTree tree(surface);
    const double trial_length = std::max(options.length, std::sqrt(surface.area() / k_cut_trial_cells));
    CutProposals proposals{{}, {laid(surface, {}, options, options.length).report.coverage}};
    while (std::ssize(proposals.cuts) < most) {
        const DrapedPieces now = laid(surface, proposals.cuts, options, trial_length);
        const std::vector<SurfacePoint> places = worst_places(surface, faults_of(surface, now.net, trial_length));
        std::vector<Trial> trials =
            tried(surface, proposals.cuts, candidates(surface, tree, proposals.cuts, places), options, trial_length);
        trials.resize(std::min(trials.size(), k_cut_finals), {});
        double best = proposals.coverage.back() + k_least_gain;
        const CutLine* found = nullptr;
        for (const Trial& trial : trials) {
            const double coverage =
                laid(surface, with(proposals.cuts, trial.line), options, options.length).report.coverage;
            if (coverage <= best) continue;
            best = coverage;
            found = &trial.line;
        }
        if (found == nullptr) break;
        proposals.cuts.push_back(*found);
        proposals.coverage.push_back(best);
    }
    return proposals;
}

}  // namespace chebnet
