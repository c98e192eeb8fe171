#include "edit/equalize.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "edit/resting_near.h"
#include "net/measures.h"
#include "solve/parts/nearest_rotation.h"
#include "surface/height.h"

namespace chebnet {

namespace {

constexpr std::pair<EqualizeWay, const char*> k_ways[] = {
    {EqualizeWay::usual, ""}, {EqualizeWay::at_rest, "equilibrium"}, {EqualizeWay::lengths, "projection"}};
// The first attempt may use up all rounds of springs and some steps of the method's last resort, which is slow on large
// nets; from there, shaking succeeds in a fraction of the time if anything does.
constexpr int k_first_iterations = 150;
constexpr int k_second_iterations = 300;
constexpr int k_iterations_to_rest = 30;  // more make it little fairer
// What holds vertices where they were in the original: enough for the net not to slide over its surface.
constexpr double k_anchor_weight = 0.02;
// How far a vertex is shaken at most, in edge lengths: far enough to leave a plane for good, and no farther than a
// rough scan has its vertices off.
constexpr double k_shake = 0.2;
constexpr double k_most_growth = 1e6;  // or shrinkage, by a length that is given
constexpr std::size_t k_most_worst_edges = 8;

EqualizeWay usual_way(const Net& original, const EqualizeOptions& options) {
    const bool is_small = original.vertex_count() <= k_most_vertices_at_rest;
    return options.guide || is_small ? EqualizeWay::at_rest : EqualizeWay::lengths;
}

double chosen_length(const Net& original, const EqualizeOptions& options) {
    if (options.choice != EqualLength::given) return original.mean_length();
    const double factor = options.length / original.mean_length();
    if (!(factor >= 1 / k_most_growth && factor <= k_most_growth))
        throw Error(ErrorCode::bad_option, "the length must be a millionth to a million times the mean length");
    return options.length;
}

Net with_mean_length_one(const Net& net) {
    return Net(net.rest_positions() / net.mean_length(), net.faces(), RestLengths::equal);
}

/// None if the faces of the net are no surface, as where it has one side only.
std::shared_ptr<const Guide> surface_of(const Net& net) {
    try {
        return std::make_shared<const Guide>(Surface({net.rest_positions(), net.faces()}));
    } catch (const Error&) {
        return nullptr;
    }
}

std::shared_ptr<const Guide> in_unit(double unit, const std::shared_ptr<const Guide>& guide) {
    return unit == 1 ? guide : std::make_shared<const Guide>(scaled(guide->surface(), 1 / unit));
}

/// Moved onto the surface, or what goes on beyond its border.
Positions moved_onto(const Guide& guide, Positions x) {
    int face = 0;
    for (auto point : x.colwise()) {
        const Height height = height_of(guide.surface(), guide.tree(), point, face);
        point -= height.height * height.normal;
        face = height.at.face;
    }
    return x;
}

Eigen::VectorXd lengths_of_edges(const Net& net, const Positions& positions) {
    return edge_ratios(net, positions).cwiseProduct(net.rest_lengths());
}

LengthSpread spread(const Eigen::VectorXd& lengths) {
    const Eigen::ArrayXd relative = lengths.array() / lengths.mean();
    return {relative.minCoeff(), relative.maxCoeff(), std::sqrt((relative - 1).square().mean())};
}

/// The rest positions of a net with edges of mean length 1, each vertex moved along its normal by chance.
Positions shaken(const Net& net) {
    std::mt19937 random;  // its numbers, unlike those of distributions, are the same everywhere
    Positions x = net.rest_positions();
    const Positions normals = vertex_normals(net, x);
    for (int v = 0; v < x.cols(); ++v) {
        const double between_0_and_1 = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
        x.col(v) += k_shake * (2 * between_0_and_1 - 1) * normals.col(v);
    }
    return x;
}

std::vector<int> worst_edges(const Eigen::VectorXd& ratios) {
    std::vector<int> edges;
    for (int e = 0; e < ratios.size(); ++e)
        if (!(deviation(ratios[e]) < k_equal_deviation)) edges.push_back(e);
    const auto end = edges.begin() + static_cast<std::ptrdiff_t>(std::min(edges.size(), k_most_worst_edges));
    std::partial_sort(edges.begin(), end, edges.end(),
                      [&](int a, int b) { return deviation(ratios[a]) > deviation(ratios[b]); });
    edges.erase(end, edges.end());
    return edges;
}

}  // namespace

const char* to_string(EqualizeWay way) {
    for (const auto& [each, method] : k_ways)
        if (each == way) return method;
    return "";
}

EqualizeWay equalize_way_named(std::string_view method) {
    for (const auto& [way, name] : k_ways)
        if (method == name) return way;
    throw Error(ErrorCode::bad_option,
                "a mesh is equalised by equilibrium or by projection, not by " + std::string(method));
}

Equalizer::Equalizer(Net original, EqualizeOptions options)
    : m_original(std::move(original)),
      m_options(std::move(options)),
      m_length(chosen_length(m_original, m_options)),
      m_fitting_length(m_length),
      m_editor(with_mean_length_one(m_original)),
      m_surface(m_options.guide ? in_unit(m_original.mean_length(), m_options.guide) : surface_of(m_editor.net())),
      m_best_deviation(std::numeric_limits<double>::infinity()),
      m_positions(m_original.rest_positions()) {
    if (m_options.way == EqualizeWay::usual) m_options.way = usual_way(m_original, m_options);
    check_options();
    begin_lengths();
    const bool is_equal = !comes_near_guide() && deviation_from_length() < k_equal_deviation;
    if (is_equal && keeps_limit())
        m_status = Status::converged;
    else if (m_options.way == EqualizeWay::at_rest && begin_fair())
        take_near_surface(m_fair->positions());
    else if (is_equal)
        m_status = Status::exact;
    else
        place(m_editor.positions());
}

void Equalizer::check_options() const {
    if (m_options.choice == EqualLength::fitting && !m_options.handles.empty())
        throw Error(ErrorCode::bad_option, "a net with handles cannot choose its fitting length: they fix its size");
    if (!(m_options.shear_limit >= 0 && m_options.shear_limit <= std::numbers::pi / 3))
        throw Error(ErrorCode::bad_option, "the limit of corners must be an angle from 0 to 60 degrees");
}

void Equalizer::begin_lengths() {
    m_stage = Stage::lengths;
    EditState state = m_editor.state();
    state.method = "projection";
    state.options.threshold = k_equal_deviation;
    state.options.max_iterations = k_first_iterations;
    m_editor.change_state(std::move(state));
    hold_handles();
}

void Equalizer::hold_handles() {
    std::vector<Handle> handles;
    for (int v : m_options.handles) handles.push_back({v, Eigen::Vector3d::Zero()});
    m_editor.set_handles(handles);
    m_editor.reset();
    handles = m_editor.handles();
    for (const Handle& handle : handles) m_centre += handle.target / static_cast<double>(handles.size());
    for (Handle& handle : handles)
        handle.target = m_centre + m_original.mean_length() / m_length * (handle.target - m_centre);
    m_editor.set_handles(handles);
    find_free_pieces();
}

void Equalizer::find_free_pieces() {
    std::vector<bool> is_handle(static_cast<std::size_t>(m_original.vertex_count()), false);
    for (int v : m_options.handles) is_handle[v] = true;
    for (std::vector<int>& piece : m_editor.topology().components())
        if (std::none_of(piece.begin(), piece.end(), [&](int v) { return is_handle[v]; }))
            m_free_pieces.push_back(std::move(piece));
}

EqualizeReport Equalizer::solve(const Budget& budget) {
    advance(budget);
    return report();
}

Status Equalizer::advance(const Budget& budget) {
    if (m_status != Status::running) return m_status;
    Stopwatch watch;
    const int iterations_before = m_iterations;
    do iterate();
    while (m_status == Status::running && m_iterations - iterations_before < budget.iterations &&
           watch.milliseconds() < budget.milliseconds);
    if (m_stage == Stage::lengths || m_stage == Stage::shaken)
        place(m_status == Status::running ? m_editor.positions() : m_best);
    // Coordinates far from the origin have fewer digits than those in the solver's unit.
    if (m_status == Status::converged && !(deviation_from_length() < k_equal_deviation)) m_status = Status::stalled;
    if (m_status == Status::converged && !keeps_limit()) m_status = Status::exact;
    m_elapsed_ms += watch.milliseconds();
    return m_status;
}

void Equalizer::iterate() {
    if (m_stage == Stage::fair) return make_fair();
    if (m_stage == Stage::rest) return come_to_rest();
    find_lengths();
}

// ------------------------------------------------------------------------------------------------- near the surface

/// False where there is nothing to be near to, or the handles are out of reach.
bool Equalizer::begin_fair() {
    if (!m_surface || !m_editor.unreachable_pairs().empty()) return false;
    m_unit = keeps_size() ? m_length / m_original.mean_length() : 1;
    const Net& net = m_editor.net();
    const FairStart::Options options{.fixed = m_options.handles,
                                     .pulls = anchors(),
                                     .unit = m_unit,
                                     .shear_limit = m_options.shear_limit,
                                     .size = fitting_size()};
    try {
        m_fair =
            std::make_unique<FairStart>(net, m_editor.topology(), *m_surface, net.rest_positions() / m_unit, options);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        return false;
    }
    m_stage = Stage::fair;
    return true;
}

/// Near a guide the net need not lie where the original does.
FairStart::Size Equalizer::fitting_size() const {
    if (m_options.choice != EqualLength::fitting) return FairStart::Size::kept;
    return m_options.guide ? FairStart::Size::by_lengths : FairStart::Size::by_places;
}

/// In the unit of the net near the surface.
std::vector<Pull> Equalizer::anchors() const {
    const Positions& x = m_editor.net().rest_positions();
    const Positions original = (m_options.guide ? moved_onto(*m_surface, x) : x) / m_unit;
    const std::vector<bool> is_free = free_vertices(m_original.vertex_count(), m_options.handles);
    std::vector<Pull> pulls;
    for (int v = 0; v < m_original.vertex_count(); ++v)
        if (is_free[v]) pulls.push_back({v, original.col(v), k_anchor_weight});
    return pulls;
}

void Equalizer::make_fair() {
    ++m_iterations;
    const bool goes_on = m_fair->step();
    m_unit = m_fair->unit();
    take_near_surface(m_fair->positions());
    if (goes_on) return;
    if (m_fair->make_exact(k_equal_deviation / 10))
        begin_rest();
    else
        m_stage = Stage::lengths;
}

void Equalizer::begin_rest() {
    Net exact(m_fair->positions(), m_original.faces(), RestLengths::equal);
    m_at_rest =
        std::make_unique<Editor>(resting_near(std::move(exact), in_unit(m_unit, m_surface), m_options.shear_limit));
    std::vector<Handle> handles;
    for (int v : m_options.handles) handles.push_back({v, m_fair->positions().col(v)});
    for (const Pull& pull : anchors()) handles.push_back({pull.vertex, pull.target, pull.weight});
    EditState state = m_at_rest->state();
    state.handles = std::move(handles);
    state.options.max_iterations = k_iterations_to_rest;
    m_at_rest->change_state(std::move(state));
    m_stage = Stage::rest;
}

void Equalizer::come_to_rest() {
    const SolveReport solved = m_at_rest->solve({.iterations = 1});
    m_iterations += std::max(1, solved.iterations);
    take_near_surface(m_at_rest->positions());
    if (solved.status == Status::running) return;
    if (deviation_from_length() < k_equal_deviation)
        m_status = Status::converged;
    else
        m_stage = Stage::lengths;
}

/// A given length scales the net about its centre.
void Equalizer::take_near_surface(const Positions& x) {
    const Eigen::Vector3d fixed = keeps_size() ? Eigen::Vector3d::Zero() : centre();
    if (m_options.choice == EqualLength::fitting)
        m_length = m_fitting_length = m_unit * m_original.mean_length();
    else
        choose_length(nearest_placements(x));
    m_positions = (m_length * x).colwise() + (1 - m_length / m_original.mean_length()) * fixed;
    for (int v : m_options.handles) m_positions.col(v) = m_original.rest_positions().col(v);
}

// ------------------------------------------------------------------------------------------------------ lengths alone

void Equalizer::find_lengths() {
    const SolveReport solved = m_editor.solve({.iterations = 1});
    m_iterations += solved.iterations;
    if (m_best.cols() == 0 || solved.max_deviation < m_best_deviation) {
        m_best = m_editor.positions();
        m_best_deviation = solved.max_deviation;
    }
    if (solved.status == Status::running) return;
    if (can_try_again(solved.status))
        try_again();
    else
        m_status = solved.status;
}

bool Equalizer::can_try_again(Status ended) const {
    return m_stage != Stage::shaken && ended != Status::converged && ended != Status::unreachable;
}

void Equalizer::try_again() {
    m_stage = Stage::shaken;
    EditState state = m_editor.state();
    state.options.max_iterations = k_second_iterations;
    state.positions = shaken(m_editor.net());
    m_editor.change_state(std::move(state));
}

/// From the editor's unit to the original's: free pieces nearest to the original, the others where their handles are.
void Equalizer::place(const Positions& scaled) {
    const double unit = m_original.mean_length();
    const std::vector<Placement> placements = nearest_placements(scaled);
    choose_length(placements);
    m_positions = (m_length * (scaled.colwise() - m_centre)).colwise() + unit * m_centre;
    for (std::size_t k = 0; k < placements.size(); ++k) {
        const Placement& piece = placements[k];
        for (int v : m_free_pieces[k])
            m_positions.col(v) = unit * piece.to + m_length * (piece.rotation * (scaled.col(v) - piece.from));
    }
    for (int v : m_options.handles) m_positions.col(v) = m_original.rest_positions().col(v);
}

void Equalizer::choose_length(const std::vector<Placement>& placements) {
    if (!m_options.handles.empty()) return;
    double overlap = 0, extent = 0;
    for (const Placement& placement : placements) overlap += placement.overlap, extent += placement.extent;
    // Without overlap every size is as far from the original as any other.
    m_fitting_length = overlap > 0 ? m_original.mean_length() * overlap / extent : m_length;
    if (m_options.choice == EqualLength::fitting) m_length = m_fitting_length;
}

/// Of each free piece, `x` being in the editor's unit.
std::vector<Equalizer::Placement> Equalizer::nearest_placements(const Positions& x) const {
    std::vector<Placement> placements;
    for (const std::vector<int>& piece : m_free_pieces)
        placements.push_back(nearest_placement(piece, x, m_editor.net().rest_positions()));
    return placements;
}

/// By least squares over the piece's vertices.
Equalizer::Placement Equalizer::nearest_placement(const std::vector<int>& piece, const Positions& x,
                                                  const Positions& y) {
    Placement placement;
    for (int v : piece) placement.from += x.col(v), placement.to += y.col(v);
    placement.from /= static_cast<double>(piece.size());
    placement.to /= static_cast<double>(piece.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (int v : piece) {
        covariance += (y.col(v) - placement.to) * (x.col(v) - placement.from).transpose();
        placement.extent += (x.col(v) - placement.from).squaredNorm();
    }
    placement.rotation = nearest_rotation(covariance, Eigen::Quaterniond::Identity()).toRotationMatrix();
    placement.overlap = placement.rotation.cwiseProduct(covariance).sum();
    return placement;
}

std::optional<Positions> Equalizer::surface_positions() const {
    if (!m_surface || m_options.guide) return std::nullopt;
    const Positions& x = m_original.rest_positions();
    if (keeps_size()) return x;
    return Positions(((m_length / m_original.mean_length()) * (x.colwise() - centre())).colwise() + centre());
}

double Equalizer::deviation_from_length() const {
    return max_deviation(lengths_of_edges(m_original, m_positions) / m_length);
}

int Equalizer::quads_beyond_limit() const {
    return sharp_quads(m_original, m_positions, m_options.shear_limit - k_limit_tolerance);
}

bool Equalizer::keeps_limit() const { return m_options.way != EqualizeWay::at_rest || quads_beyond_limit() == 0; }

/// That of the options also where it had nothing to do.
EqualizeWay Equalizer::way() const {
    if (m_status == Status::converged && m_iterations == 0) return m_options.way;
    return m_stage == Stage::fair || m_stage == Stage::rest ? EqualizeWay::at_rest : EqualizeWay::lengths;
}

EqualizeReport Equalizer::report() const {
    EqualizeReport report;
    report.status = m_status;
    report.length = m_length;
    report.way = way();
    report.iterations = m_iterations;
    report.milliseconds = m_elapsed_ms;
    report.fitting_length = m_fitting_length;
    report.unreachable_pairs = unreachable_pairs();
    report.max_deviation = deviation_from_length();
    if (m_status != Status::running) measure(report);
    return report;
}

/// What takes as long as an iteration, or longer.
void Equalizer::measure(EqualizeReport& report) const {
    const Eigen::VectorXd lengths = lengths_of_edges(m_original, m_positions);
    report.before = spread(lengths_of_edges(m_original, m_original.rest_positions()));
    report.after = spread(lengths);
    report.worst_edges = worst_edges(lengths / m_length);
    const Eigen::VectorXd moves = (m_positions - m_original.rest_positions()).colwise().norm() / m_length;
    report.mean_move = moves.mean();
    report.max_move = moves.maxCoeff();
    report.smallest_angle = corner_angle_range(m_original, m_positions).smallest;
    report.quads_beyond_limit = quads_beyond_limit();
    report.folds_before = sharp_folds(m_original, m_original.rest_positions(), k_fold);
    report.folds = sharp_folds(m_original, m_positions, k_fold);
    if (m_surface) report.distance = distance_from_surface();
}

/// In units of L.
GuideDistance Equalizer::distance_from_surface() const {
    const double mean = m_original.mean_length();
    Positions x = m_positions / mean;
    if (!keeps_size()) {
        const Eigen::Vector3d fixed = centre() / mean;
        x = (mean / m_length * (x.colwise() - fixed)).colwise() + fixed;
    }
    const auto [average, largest] = distance_to(*m_surface, m_original, x);
    const double unit = keeps_size() ? m_length / mean : 1;
    return {average / unit, largest / unit};
}

/// The editor's, in the original's unit.
std::vector<UnreachablePair> Equalizer::unreachable_pairs() const {
    std::vector<UnreachablePair> pairs = m_editor.unreachable_pairs();
    for (UnreachablePair& pair : pairs) pair.distance *= m_length, pair.reach *= m_length;
    return pairs;
}

}  // namespace chebnet
