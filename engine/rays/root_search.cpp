#include "engine/rays/root_search.hpp"

#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/form_signs.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/kernel/surface_facts.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace zeroset {
namespace {

constexpr std::size_t parts = batch_multiple;

/// f on a cell of the ray, at the place t in [-1, 1] from its near end to the far one: within
/// `spread` of c + along t.
template <class Real>
struct Cell {
    Real c, along, spread;
    bool falls, rises;  ///< f surely does, all along the cell
    bool continuous, nowhere;

    [[nodiscard]] bool is_monotone() const { return falls || rises; }
    /// The sign that f goes towards.
    [[nodiscard]] int trend() const { return rises ? 1 : -1; }
};

enum class Answer : std::uint8_t {
    Free,
    Root,
    Approaching,  ///< f rises or falls towards 0, from a known sign
    Open,
};
struct Verdict {
    Answer answer;
    int sign = 0;  ///< of f at the far end of a free cell; 0: not known
};

/// Cells that follow each other, in all of which f surely rises, or surely falls, towards 0: it is
/// not known yet whether it gets there.
struct Approach {
    double from, to;
    int trend;
};

/// Where the search stands on its way.
struct Progress {
    bool left;       ///< the root at the ray's origin is behind
    bool not_below;  ///< else: f is 0 or above at the origin, so where it falls it leaves that
    int sign;        ///< of f there, or where `approach` begins, if it is known; else 0
    bool unsettled = false;
    std::optional<Approach> approach = std::nullopt;
};

/// Whether f at the far end surely has the other sign than `sign`.
template <class Real>
bool turned(const Cell<Real>& f, int sign) {
    return (sign > 0 && f.c + f.along + f.spread < 0) || (sign < 0 && f.spread - f.along - f.c < 0);
}

template <class Real>
Verdict judge(const Cell<Real>& f, const Progress& at, RootWish wish) {
    const Real size = std::abs(f.c);
    const Real steepness = std::abs(f.along);
    const int sign = at.approach ? 0 : at.sign;
    if (f.nowhere) return {.answer = Answer::Free};
    // Where f is not continuous, the form is of another function with its zeros, not its signs.
    if (size > steepness + f.spread)
        return {.answer = Answer::Free, .sign = !f.continuous ? 0 : f.c > 0 ? 1 : -1};
    if (!f.continuous) return {.answer = Answer::Open};
    const bool is_left = at.left || (at.not_below && f.falls);
    if (f.is_monotone() && (!is_left || sign == f.trend()))
        return {.answer = Answer::Free, .sign = f.trend()};
    if (!is_left) return {.answer = Answer::Open};
    const bool holds_root = steepness > size + f.spread || turned(f, sign);
    const bool enough = f.is_monotone() || wish == RootWish::Any;
    if (holds_root && enough) return {.answer = Answer::Root};
    const bool approaches = f.is_monotone() && at.sign == -f.trend() &&
                            (!at.approach || at.approach->trend == f.trend());
    return {.answer = approaches ? Answer::Approaching : Answer::Open};
}

template <class Real>
class Search {
public:
    Search(const TraceFrame& surface, const SceneRay& ray, RayStart start, RootWish wish,
           Counters& counters)
        : surface_(surface),
          ray_(ray),
          wish_(wish),
          counters_(counters),
          own_error_(start == RayStart::Anywhere ? 0.0 : ray.own_error),
          place_error_(place_error(surface)),
          at_{.left = start == RayStart::Anywhere,
              .not_below = start == RayStart::NotBelow,
              .sign = start == RayStart::NotBelow ? 1 : 0} {
        const double cell = std::ldexp(surface.scene.clip.size(), -surface.depth.wanted);
        const double extent = std::min(surface.scene.clip.size(), surface.view.look_distance);
        finest_ = std::max({0x1p-16 * extent, 4 * cell, 64 * place_error_});
        for (int i = 0; i < 3; ++i)
            frustum_.forward[i] = static_cast<Real>(ray.direction[i]);
    }

    RootFinding run() {
        RootFinding finding;
        const double from = ray_.from - own_error_;
        if (from < ray_.to) divide(from, ray_.to, std::numeric_limits<Real>::infinity());
        finding.bracket = found_;
        finding.unsettled = at_.unsettled || (at_.approach && !found_);
        return finding;
    }

private:
    template <class Other>
    friend class Search;  // float goes on in double

    /// Searches a stretch, by `parts` cells; whether the search is over. `whole`: the spread of a
    /// cell that is the stretch.
    bool divide(double from, double to, Real whole);
    /// Divides a stretch in double, where rounding keeps cells in float from being decided.
    bool divide_in_double(double from, double to);
    void evaluate(double from, double to);
    [[nodiscard]] Cell<Real> cell(std::size_t i) const {
        return {.c = cells_.c[i],
                .along = cells_.k[2][i],
                .spread = cells_.e[i],
                .falls = cells_.slope_hi[i] < 0,
                .rises = cells_.slope_neg_lo[i] < 0,
                .continuous = cells_.continuous[i] != 0,
                .nowhere = cells_.nowhere[i] != 0};
    }
    /// Takes what is known of a cell that is not divided; whether the search is over.
    bool take(const Cell<Real>& f, const Verdict& verdict, double from, double to);
    /// Takes a cell behind an approach, which begins at `from`; whether f was 0 in the approach.
    bool ends_approach(const Cell<Real>& f, const Verdict& verdict, double from);
    bool take_root(const Cell<Real>& f, double from, double to);
    bool take_approach();
    /// Makes box i one about a stretch.
    void set_box(RangeBoxes<double, parts>& boxes, std::size_t i, double from, double to) const;
    /// Asks for ranges of a function in the first `count` boxes.
    void evaluate_boxes(const KernelFunction<RangeBatchOf<double>>& range, std::size_t count,
                        RangeBoxes<double, parts>& boxes) const;
    /// The sign of f at a place, by a box about it; 0: not known.
    [[nodiscard]] int sign_at(double place) const;
    int sign_by_boxes(double from, double to);
    /// Whether f surely is defined in a stretch.
    [[nodiscard]] bool is_defined(double from, double to) const;
    /// Whether f changes its sign in a stretch, is defined in it, and comes to 0 there from both
    /// sides, as far as f around it tells.
    [[nodiscard]] bool closes(double from, double to) const;
    bool take_undecided(const Cell<Real>& f, double from, double to);

    const TraceFrame& surface_;
    const SceneRay& ray_;
    RootWish wish_;
    Counters& counters_;
    double own_error_, place_error_;
    double finest_;  ///< a cell that is no longer is not divided
    FrustumOf<Real> frustum_{};
    FormCells<Real, parts> cells_;
    Progress at_;
    std::optional<RootBracket> found_;
};

template <class Real>
void Search<Real>::evaluate(double from, double to) {
    constexpr double unit = std::numeric_limits<Real>::epsilon();
    const double middle = 0.5 * from + 0.5 * to;
    const glm::dvec3 base = ray_.at(middle);
    for (int i = 0; i < 3; ++i) {
        frustum_.base[i] = static_cast<Real>(base[i]);
        // The error of making `base`, in units of this format.
        const double base_error = 0x1p-50 / unit * (std::abs(ray_.origin[i]) + std::abs(middle));
        frustum_.size[i] = upper_end(Real{}, (std::abs(base[i]) + base_error) * (1.0 + 0x1p-20));
        frustum_.direction_size[i] =
            upper_end(Real{}, std::abs(ray_.direction[i]) * (1.0 + 0x1p-20));
    }
    const double width = (to - from) / parts;
    const double radius = 0.5 * width + place_error_;
    for (std::size_t i = 0; i < parts; ++i) {
        const double s = from - middle + (static_cast<double>(i) + 0.5) * width;
        cells_.u[i] = 0;
        cells_.v[i] = 0;
        cells_.s[i] = static_cast<Real>(s);
        const double off = std::abs(static_cast<double>(cells_.s[i]) - s);
        cells_.s_radius[i] = upper_end(Real{}, radius + off);
    }
    counters_.form += parts;
    const Real* const uniforms = surface_.scene.uniforms.template boxes<Real>();
    surface_.kernel.ray_form(cells_.batch(parts, frustum_, uniforms));
    counters_.range += ask_unknown_signs(surface_.kernel.template in<Real>().range, frustum_, true,
                                         uniforms, parts, cells_);
}

template <class Real>
bool Search<Real>::take(const Cell<Real>& f, const Verdict& verdict, double from, double to) {
    if (at_.approach && verdict.answer != Answer::Approaching && ends_approach(f, verdict, from))
        return true;
    switch (verdict.answer) {
        case Answer::Free:
            at_.left = true;
            at_.sign = verdict.sign;
            return false;
        case Answer::Root: return take_root(f, from, to);
        case Answer::Approaching:
            at_.approach = {
                .from = at_.approach ? at_.approach->from : from, .to = to, .trend = f.trend()};
            return turned(f, at_.sign) && take_approach();
        case Answer::Open: break;
    }
    return take_undecided(f, from, to);
}

template <class Real>
bool Search<Real>::ends_approach(const Cell<Real>& f, const Verdict& verdict, double from) {
    // The sign at the near end of this cell, which is the far end of the approach.
    int sign = 0;
    if (verdict.answer == Answer::Free) sign = verdict.sign;
    if (verdict.answer == Answer::Root && f.is_monotone()) sign = -f.trend();
    if (sign == 0) sign = sign_at(from);
    if (sign == at_.approach->trend) return take_approach();
    at_.unsettled = at_.unsettled || sign == 0;
    at_.approach.reset();
    return false;
}

template <class Real>
bool Search<Real>::take_approach() {
    const Approach& approach = *at_.approach;
    found_ = RootBracket{.from = approach.from,
                         .to = approach.to,
                         .guess = approach.to,
                         .sign_before = -approach.trend,
                         .is_proved = !at_.unsettled};
    return true;
}

template <class Real>
bool Search<Real>::take_root(const Cell<Real>& f, double from, double to) {
    const double middle = 0.5 * from + 0.5 * to;
    const double half = 0.5 * (to - from);
    const double t = static_cast<double>(f.c) / -static_cast<double>(f.along);
    const int before = f.is_monotone() ? -f.trend() : at_.sign;
    found_ = RootBracket{.from = from,
                         .to = to,
                         .guess = middle + half * (std::abs(t) <= 1.0 ? t : 0.0),
                         .sign_before = before,
                         .is_proved = !at_.unsettled};
    return true;
}

template <class Real>
void Search<Real>::set_box(RangeBoxes<double, parts>& boxes, std::size_t i, double from,
                           double to) const {
    const glm::dvec3 a = ray_.at(from);
    const glm::dvec3 b = ray_.at(to);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<int>(k);
        boxes.ends[k][i] = place_error_ - std::min(a[axis], b[axis]);
        boxes.ends[k + 3][i] = place_error_ + std::max(a[axis], b[axis]);
    }
}

template <class Real>
void Search<Real>::evaluate_boxes(const KernelFunction<RangeBatchOf<double>>& range,
                                  std::size_t count, RangeBoxes<double, parts>& boxes) const {
    counters_.range += count;
    boxes.pad(count);
    range(boxes.batch(padded(count), surface_.scene.uniforms.template boxes<double>()));
}

template <class Real>
bool Search<Real>::is_defined(double from, double to) const {
    const SurfaceFacts& facts = surface_facts(surface_.kernel);
    if (facts.defined_everywhere || !facts.domain) return facts.defined_everywhere;
    RangeBoxes<double, parts> boxes;
    set_box(boxes, 0, from, to);
    evaluate_boxes(facts.domain, 1, boxes);
    return boxes.continuous[0] != 0;
}

template <class Real>
bool Search<Real>::closes(double from, double to) const {
    const double width = to - from;
    const std::array places{from - width, from, to, to + width};
    RangeBoxes<double, parts> boxes;
    for (std::size_t i = 0; i < places.size(); ++i)
        set_box(boxes, i, places[i], places[i]);
    evaluate_boxes(surface_.kernel.in_double.range, places.size(), boxes);
    return boxes.sign(0) * boxes.sign(3) < 0 &&
           falls_to_zero(boxes.least_size(1), boxes.least_size(0)) &&
           falls_to_zero(boxes.least_size(2), boxes.least_size(3)) &&
           is_defined(from - width, to + width);
}

template <class Real>
int Search<Real>::sign_at(double place) const {
    RangeBoxes<double, parts> boxes;
    set_box(boxes, 0, place, place);
    evaluate_boxes(surface_.kernel.in_double.range, 1, boxes);
    return boxes.sign(0);
}

/// The sign of f on a stretch, by boxes about parts of it, in double; 0: not known. Beside a pole
/// those are tighter than forms.
template <class Real>
int Search<Real>::sign_by_boxes(double from, double to) {
    RangeBoxes<double, parts> boxes;
    const double width = (to - from) / parts;
    for (std::size_t i = 0; i < parts; ++i) {
        const double near = from + static_cast<double>(i) * width;
        set_box(boxes, i, near, near + width);
    }
    evaluate_boxes(surface_.kernel.in_double.range, parts, boxes);
    bool above = true;
    bool below = true;
    for (std::size_t i = 0; i < parts; ++i) {
        above = above && boxes.f_neg_lo[i] < 0.0;
        below = below && boxes.f_hi[i] < 0.0;
    }
    return above == below ? 0 : above ? 1 : -1;
}

/// Takes a cell that is not to be divided any more.
template <class Real>
bool Search<Real>::take_undecided(const Cell<Real>& f, double from, double to) {
    if (const int sign = sign_by_boxes(from, to); sign != 0) {
        at_.sign = sign;
        at_.left = true;
        return false;
    }
    at_.unsettled = true;
    // Beside the origin it is the root there that cannot be told from others; beside a pole there
    // is no enclosure.
    const bool is_known = f.continuous && std::isfinite(f.spread) && std::isfinite(f.c);
    if (!at_.left || !(is_known || closes(from, to))) {
        at_.sign = 0;
        return false;
    }
    found_ = RootBracket{.from = from,
                         .to = to,
                         .guess = 0.5 * from + 0.5 * to,
                         .sign_before = 0,
                         .is_proved = false};
    return true;
}

/// Whether smaller cells tell no more: spreads fall with the square of the length, or nearly so,
/// until rounding makes all of them.
template <class Real>
bool is_noise(const Cell<Real>& f, Real whole) {
    return f.continuous && f.spread > Real(0.5) * whole && std::isfinite(f.spread);
}

template <class Real>
bool Search<Real>::divide_in_double(double from, double to) {
    Search<double> finer(surface_, ray_, RayStart::Anywhere, wish_, counters_);
    finer.own_error_ = own_error_;
    finer.at_ = at_;
    const bool over = finer.divide(from, to, std::numeric_limits<double>::infinity());
    at_ = finer.at_;
    found_ = finer.found_;
    return over;
}

template <class Real>
bool Search<Real>::divide(double from, double to, Real whole) {
    if (surface_.stopped()) return true;
    evaluate(from, to);
    std::array<Cell<Real>, parts> cells;
    for (std::size_t i = 0; i < parts; ++i)
        cells[i] = cell(i);
    const double width = (to - from) / parts;
    for (std::size_t i = 0; i < parts; ++i) {
        const double near = from + static_cast<double>(i) * width;
        const double far = i + 1 == parts ? to : near + width;
        const double least = at_.left ? finest_ : std::max(finest_, 8.0 * own_error_);
        const Verdict verdict = judge(cells[i], at_, wish_);
        const bool divides = verdict.answer == Answer::Open && width > least;
        if (divides && std::is_same_v<Real, float> && is_noise(cells[i], whole)) {
            if (divide_in_double(near, far)) return true;
        } else if (divides ? divide(near, far, cells[i].spread)
                           : take(cells[i], verdict, near, far)) {
            return true;
        }
    }
    return false;
}

}  // namespace

RootFinding search_ray(const TraceFrame& surface, const SceneRay& ray, RayStart start,
                       RootWish wish, Counters& counters) {
    if (surface.precision == Precision::Double)
        return Search<double>(surface, ray, start, wish, counters).run();
    return Search<float>(surface, ray, start, wish, counters).run();
}

}  // namespace zeroset
