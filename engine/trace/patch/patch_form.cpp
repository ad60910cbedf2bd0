#include "engine/trace/patch/patch_form.hpp"

#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/point_batch.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace zeroset {
namespace {

constexpr std::size_t at_once = PatchForms::at_once;
using Cells = FormCells<double, at_once>;

/// The distance of an eye so far away that a cell of its frustum,
///   s forward + (distance + s) u right,
/// is a box but for 1 / distance of it, less than a quarter of an ulp.
constexpr double distance = 0x1p56;

/// The range of a variable in a box; one variable runs along the view, the other one across.
struct Axis {
    double middle, radius;
};

/// The radius, enlarged by more than is lost by rounding and by the frustum.
double grown(const Axis& axis) {
    return axis.radius * (1.0 + 0x1p-50) + 0x1p-52 * std::abs(axis.middle);
}

/// Evaluates the forms of one coordinate, with its slope along variable `along` (0 or 1).
void ask(const Kernel& kernel, const Uniforms& uniforms, const PatchForms::Boxes& boxes, int along,
         Cells& cells) {
    FrustumOf<double> frustum{};
    const int across = 1 - along;
    frustum.right[across] = 1.0;
    frustum.forward[along] = 1.0;
    frustum.distance = distance;
    double across_radius = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < at_once; ++i) {
        const UvBox& box = boxes[i];
        const Axis u{.middle = box.u, .radius = box.u_radius};
        const Axis v{.middle = box.v, .radius = box.v_radius};
        const Axis& depth = along == 0 ? u : v;
        const Axis& aside = along == 0 ? v : u;
        cells.u[i] = aside.middle / distance;
        cells.v[i] = 0.0;
        cells.s[i] = depth.middle;
        cells.s_radius[i] = grown(depth);
        across_radius = std::max(across_radius, grown(aside));
        most = std::max(most, std::abs(aside.middle) + across_radius);
    }
    frustum.u_radius = across_radius / distance;
    frustum.v_radius = 0.0;
    frustum.size[across] = most * (1.0 + 0x1p-20);
    frustum.direction_size[along] = 1.0 + 0x1p-20;
    frustum.direction_size[across] = most / distance * (1.0 + 0x1p-20);
    kernel.form(cells.batch(at_once, frustum, uniforms.boxes<double>()));
}

/// A range as middle and radius.
struct MiddleRadius {
    double middle, radius;
};

/// The derivative by a variable that is scaled from `radius` to [-1, 1]; `other`: a bound of the
/// derivative by the other variable.
MiddleRadius slope_of(const Cells& cells, std::size_t i, double radius, double other) {
    const double lo = -cells.slope_neg_lo[i];
    const double hi = cells.slope_hi[i];
    if (!std::isfinite(lo) || !std::isfinite(hi)) return {.middle = 0.0, .radius = unbounded};
    const double middle = 0.5 * lo + 0.5 * hi;
    const double half = std::max(hi - middle, middle - lo) + 0x1p-50 * (std::abs(middle) + other);
    return {.middle = middle * radius, .radius = half * radius * (1.0 + 0x1p-50)};
}

double slope_bound(const Cells& cells, std::size_t i) {
    return std::max(std::abs(cells.slope_neg_lo[i]), std::abs(cells.slope_hi[i]));
}

/// Makes a range the form of a coordinate, as beside a jump.
void hold(PatchForm& form, int k, double lo, double hi) {
    form.c[k] = 0.5 * lo + 0.5 * hi;
    form.ku[k] = form.kv[k] = 0.0;
    form.e[k] = (0.5 * hi - 0.5 * lo) * (1.0 + 0x1p-20) + 0x1p-50 * std::abs(form.c[k]);
}

/// Bounds a coordinate by its range in each box whose form knows nothing of it.
void ask_ranges(const Kernel& kernel, const Uniforms& uniforms, const PatchForms::Boxes& boxes,
                int k, PatchForms::Forms& forms) {
    const auto knows = [k](const PatchForm& form) { return form.e[k] < unbounded; };
    for (PatchForm& form : forms) {
        form.lo[k] = -unbounded;
        form.hi[k] = unbounded;
    }
    if (std::ranges::all_of(forms, knows)) return;
    RangeBoxes<double, at_once> ranges;
    for (std::size_t i = 0; i < at_once; ++i) {
        const UvBox& box = boxes[i];
        const double u_radius = grown({.middle = box.u, .radius = box.u_radius});
        const double v_radius = grown({.middle = box.v, .radius = box.v_radius});
        ranges.ends[0][i] = u_radius - box.u;
        ranges.ends[1][i] = v_radius - box.v;
        ranges.ends[2][i] = 0.0;
        ranges.ends[3][i] = box.u + u_radius;
        ranges.ends[4][i] = box.v + v_radius;
        ranges.ends[5][i] = 0.0;
    }
    kernel.range(ranges.batch(at_once, uniforms.boxes<double>()));
    for (std::size_t i = 0; i < at_once; ++i) {
        if (knows(forms[i])) continue;
        const double lo = -ranges.f_neg_lo[i];
        const double hi = ranges.f_hi[i];
        if (std::isnan(lo) || std::isnan(hi)) continue;
        forms[i].lo[k] = lo;
        forms[i].hi[k] = hi;
        // Nowhere defined: both ends are beyond all numbers.
        if (lo == unbounded && hi == -unbounded) forms[i].nowhere = true;
        if (lo <= hi && lo > -unbounded && hi < unbounded) hold(forms[i], k, lo, hi);
    }
}

}  // namespace

namespace {

/// More than rounding may move the ends of a clip box.
double spare_of(const Box& clip, int k) {
    return 0x1p-40 * (std::abs(clip.lo[k]) + std::abs(clip.hi[k]));
}

bool is_beside(const PatchForm& form, const Box& clip, int k) {
    const double spare = spare_of(clip, k);
    const double spread = std::abs(form.ku[k]) + std::abs(form.kv[k]) + form.e[k];
    return form.c[k] - spread > clip.hi[k] + spare || form.c[k] + spread < clip.lo[k] - spare;
}

/// Whether no place of a known form is in a clip box.
bool is_beside(const PatchForm& form, const Box& clip) {
    return is_beside(form, clip, 0) || is_beside(form, clip, 1) || is_beside(form, clip, 2);
}

}  // namespace

std::optional<PatchForm> form_within(const PatchForm& form, const Box& clip) {
    if (form.nowhere) return std::nullopt;
    PatchForm within = form;
    for (int k = 0; k < 3; ++k) {
        if (form.e[k] < unbounded) {
            if (is_beside(form, clip, k)) return std::nullopt;
            continue;
        }
        const double spare = spare_of(clip, k);
        const double clip_lo = clip.lo[k] - spare;
        const double clip_hi = clip.hi[k] + spare;
        const bool is_between = form.lo[k] <= form.hi[k];
        if (!is_between && form.hi[k] < clip_lo && form.lo[k] > clip_hi) return std::nullopt;
        const double lo = is_between ? std::max(form.lo[k], clip_lo) : clip_lo;
        const double hi = is_between ? std::min(form.hi[k], clip_hi) : clip_hi;
        if (lo > hi) return std::nullopt;
        within.c[k] = 0.5 * lo + 0.5 * hi;
        within.ku[k] = within.kv[k] = 0.0;
        within.e[k] = 0.5 * (hi - lo) * (1.0 + 0x1p-20) + spare;
    }
    return within;
}

PatchForm form_of(const PatchModel& model) {
    PatchForm form{};
    form.continuous = true;
    form.lo = glm::dvec3(-unbounded);
    form.hi = glm::dvec3(unbounded);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = static_cast<int>(k);
        const auto& terms = model.terms[k];
        double size = std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]);
        double middle = terms[0];
        double spread = 0.0;
        double by_u = 0.0;
        double by_v = 0.0;
        for (std::size_t i = patch_term(2, 0); i < patch_terms; ++i) {
            const double term = std::abs(terms[i]);
            size += term;
            by_u += patch_powers[i].p * term;
            by_v += patch_powers[i].q * term;
            // Powers that are even run from 0 to 1.
            const bool is_even = patch_powers[i].p % 2 == 0 && patch_powers[i].q % 2 == 0;
            if (is_even) middle += 0.5 * terms[i];
            spread += is_even ? 0.5 * term : term;
        }
        form.c[at] = middle;
        form.ku[at] = form.du[at] = terms[patch_term(1, 0)];
        form.kv[at] = form.dv[at] = terms[patch_term(0, 1)];
        form.e[at] = spread + model.error[k] + 0x1p-46 * size;
        form.du_radius[at] = by_u;
        form.dv_radius[at] = by_v;
        form.value_error[at] = model.error[k] + 0x1p-46 * size;
    }
    return form;
}

PatchPoint value_of(const PatchModel& model, double p, double q) {
    std::array<double, std::size_t{patch_degree} + 1> p_powers{1.0};
    std::array<double, std::size_t{patch_degree} + 1> q_powers{1.0};
    for (std::size_t i = 1; i < p_powers.size(); ++i) {
        p_powers[i] = p_powers[i - 1] * p;
        q_powers[i] = q_powers[i - 1] * q;
    }
    PatchPoint point{.s = glm::dvec3(0.0), .su = glm::dvec3(0.0), .sv = glm::dvec3(0.0)};
    for (std::size_t i = 0; i < patch_terms; ++i) {
        const glm::dvec3 term(model.terms[0][i], model.terms[1][i], model.terms[2][i]);
        const auto by_p = static_cast<std::size_t>(patch_powers[i].p);
        const auto by_q = static_cast<std::size_t>(patch_powers[i].q);
        point.s += term * (p_powers[by_p] * q_powers[by_q]);
        if (by_p > 0) point.su += term * (patch_powers[i].p * p_powers[by_p - 1] * q_powers[by_q]);
        if (by_q > 0) point.sv += term * (patch_powers[i].q * p_powers[by_p] * q_powers[by_q - 1]);
    }
    return point;
}

FormWithin::FormWithin(const PatchForm& form, const Box& clip) {
    if (!form.known()) {
        changed_ = form_within(form, clip);
        if (changed_) form_ = &*changed_;
        return;
    }
    if (!form.nowhere && !is_beside(form, clip)) form_ = &form;
}

bool PatchForms::make_models(std::span<const UvBox> boxes, std::span<PatchModel> models) const {
    if (code_->modeler == nullptr) return false;
    code_->modeler->make_models(boxes, uniforms_, models);
    return true;
}

void PatchForms::evaluate(const Boxes& boxes, Forms& forms) const {
    thread_local Cells along_u;
    thread_local Cells along_v;
    for (int k = 0; k < 3; ++k) {
        const Kernel& kernel = code_->point[static_cast<std::size_t>(k)];
        ask(kernel, uniforms_, boxes, 0, along_u);
        ask(kernel, uniforms_, boxes, 1, along_v);
        for (std::size_t i = 0; i < at_once; ++i) {
            PatchForm& form = forms[i];
            if (k == 0) {
                form.continuous = true;
                form.nowhere = false;
            }
            form.c[k] = along_u.c[i];
            form.ku[k] = along_u.k[2][i];
            form.kv[k] = along_u.k[0][i];
            form.e[k] = along_u.e[i];
            form.value_error[k] = 0x1p-50 * along_u.r[i];
            const MiddleRadius u = slope_of(along_u, i, boxes[i].u_radius, slope_bound(along_v, i));
            const MiddleRadius v = slope_of(along_v, i, boxes[i].v_radius, slope_bound(along_u, i));
            form.du[k] = u.middle;
            form.du_radius[k] = u.radius;
            form.dv[k] = v.middle;
            form.dv_radius[k] = v.radius;
            form.continuous = form.continuous && along_u.continuous[i] != 0;
            form.nowhere = form.nowhere || along_u.nowhere[i] != 0;
        }
        ask_ranges(kernel, uniforms_, boxes, k, forms);
    }
}

void PatchForms::evaluate(std::span<const glm::dvec2> places, std::span<PatchPoint> points) const {
    assert(places.size() == points.size());
    if (places.empty()) return;
    thread_local PointBatch<double> batch;
    batch.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        batch.set(i, places[i].x, places[i].y, 0.0);
    batch.pad();
    for (int k = 0; k < 3; ++k) {
        const Kernel& kernel = code_->point[static_cast<std::size_t>(k)];
        kernel.value(batch.batch(uniforms_.points<double>()));
        for (std::size_t i = 0; i < places.size(); ++i) {
            points[i].s[k] = batch.f(i);
            points[i].su[k] = batch.gradient(0, i);
            points[i].sv[k] = batch.gradient(1, i);
        }
    }
}

}  // namespace zeroset
