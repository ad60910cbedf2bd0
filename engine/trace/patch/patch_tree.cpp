#include "engine/trace/patch/patch_tree.hpp"

#include "engine/kernel/surface_facts.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <span>
#include <utility>

namespace zeroset {
namespace {

/// The tree of a kernel, for the last uniforms.
struct KeptTree {
    std::mutex mutex;
    std::vector<double> uniforms;  ///< the ends of those that the code reads
    std::shared_ptr<const PatchTree> tree;
};

std::vector<double> ends_read(const PatchCode& code, const Uniforms& uniforms) {
    const std::vector<double>& all = uniforms.neg_lo_hi_double;
    if (!code.reads) return all;
    std::vector<double> ends;
    for (const std::size_t item : *code.reads) {
        for (std::size_t end = 2 * item; end < 2 * item + 2; ++end)
            ends.push_back(end < all.size() ? all[end] : std::numeric_limits<double>::infinity());
    }
    return ends;
}

/// The parts of a box; the others are not set.
PatchForms::Boxes parts_of(const UvBox& box, const Division& division) {
    PatchForms::Boxes parts{};
    const double u_radius = box.u_radius / static_cast<double>(division.cols);
    const double v_radius = box.v_radius / static_cast<double>(division.rows);
    for (std::size_t i = 0; i < division.cols * division.rows; ++i) {
        const auto col = static_cast<double>(i % division.cols);
        const auto row = static_cast<double>(i / division.cols);
        parts[i] = {.u = box.u - box.u_radius + (2.0 * col + 1.0) * u_radius,
                    .v = box.v - box.v_radius + (2.0 * row + 1.0) * v_radius,
                    .u_radius = u_radius,
                    .v_radius = v_radius};
    }
    return parts;
}

/// Sets the boxes of the parts of a node; returns the grown boxes that their forms are over.
PatchForms::Boxes place_parts(const PatchNode& node, const Division& division,
                              PatchNode::Children& parts) {
    PatchForms::Boxes boxes = parts_of(node.box, division);
    for (std::size_t i = 0; i < parts.nodes.size(); ++i) {
        parts.nodes[i].box = boxes[i];
        parts.nodes[i].level = node.level + 1;
        boxes[i] = boxes[i].grown(form_growth);
    }
    return boxes;
}

PartForms forms_of(std::span<const PatchNode> nodes) {
    PartForms all{};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const PatchForm& form = nodes[i].form;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = static_cast<int>(k);
            all.c[k][i] = form.c[at];
            all.ku[k][i] = form.ku[at];
            all.kv[k][i] = form.kv[at];
            all.e[k][i] = form.e[at];
        }
        if (form.known() && !form.nowhere) all.known |= std::uint32_t{1} << i;
    }
    return all;
}

/// Whether little of a form's error is what its model does not know.
bool is_good(const PatchModel& model, const PatchForm& form) {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = static_cast<int>(k);
        const double size = std::abs(form.c[at]) + form.spread()[at];
        if (model.error[k] > std::max(0.25 * form.e[at], 0x1p-30 * size)) return false;
    }
    return true;
}

/// In upward rounding.
ModelSizes sizes_of(const PatchModel& model) {
    std::array<double, std::size_t{patch_degree} + 1> sums{};
    for (std::size_t i = 0; i < patch_terms; ++i) {
        const glm::dvec3 term(model.terms[0][i], model.terms[1][i], model.terms[2][i]);
        sums[static_cast<std::size_t>(patch_powers[i].p + patch_powers[i].q)] += glm::length(term);
    }
    ModelSizes sizes{};
    std::ranges::transform(sums, sizes.begin(), [](double sum) {
        return static_cast<float>(sum * (1.0 + 0x1p-22)) + std::numeric_limits<float>::min();
    });
    return sizes;
}

bool is_tighter(const PatchForm& form, const PatchForm& other) {
    return form.nowhere || form.e.x + form.e.y + form.e.z < other.e.x + other.e.y + other.e.z;
}

/// A bound of the length of vectors within `radius` of `middle`; unknown coordinates count as 0.
double length_of(const glm::dvec3& middle, const glm::dvec3& radius) {
    glm::dvec3 size = glm::abs(middle) + radius;
    for (int k = 0; k < 3; ++k) {
        if (!(size[k] < std::numeric_limits<double>::infinity())) size[k] = 0.0;
    }
    return glm::length(size);
}

bool is_bounded(const glm::dvec3& radius) {
    return radius.x < unbounded && radius.y < unbounded && radius.z < unbounded;
}

/// The lengths of a part along u and v by its slopes. Where there is none, as beside a jump or the
/// start of a root, it counts as long as all that is known of the part: it is divided across.
std::pair<double, double> lengths_of(const PatchForm& form) {
    const double whole = glm::length(form.spread());
    const auto along = [&](const glm::dvec3& slope, const glm::dvec3& radius) {
        const bool is_open = form.known() && !is_bounded(radius);
        return is_open ? whole : length_of(slope, radius);
    };
    return {along(form.du, form.du_radius), along(form.dv, form.dv_radius)};
}

std::optional<Box> box_of(const PatchCode& code) {
    if (!code.box) return std::nullopt;
    const std::array<double, 6>& ends = *code.box;
    return Box{.lo = {ends[0], ends[2], ends[4]}, .hi = {ends[1], ends[3], ends[5]}};
}

}  // namespace

Division division_of(double width, double height) {
    if (width > 8.0 * height) return {.cols = 16, .rows = 1};
    if (width > 2.0 * height) return {.cols = 8, .rows = 2};
    if (height > 8.0 * width) return {.cols = 1, .rows = 16};
    if (height > 2.0 * width) return {.cols = 2, .rows = 8};
    return {.cols = 4, .rows = 4};
}

Division quarters_of(double width, double height) {
    if (width > 4.0 * height) return {.cols = 4, .rows = 1};
    if (height > 4.0 * width) return {.cols = 1, .rows = 4};
    return {.cols = 2, .rows = 2};
}

PatchNode::~PatchNode() {
    delete children.load();  // NOLINT(cppcoreguidelines-owning-memory)
    delete quarters.load();  // NOLINT(cppcoreguidelines-owning-memory)
}

PatchTree::PatchTree(std::shared_ptr<const PatchCode> code, Uniforms uniforms)
    : box_(box_of(*code)), forms_(std::move(code), std::move(uniforms)) {
    const UpwardRegisters upward;
    root_.box = {.u = 0.5, .v = 0.5, .u_radius = 0.5, .v_radius = 0.5};
    PatchForms::Boxes boxes;
    boxes.fill(root_.box.grown(form_growth));
    PatchForms::Forms forms;
    forms_.evaluate(boxes, forms);
    root_.form = forms.front();
}

bool PatchTree::make_models(std::span<const UvBox> boxes, PatchNode::Children& parts) const {
    parts.models.resize(boxes.size());
    if (!forms_.make_models(boxes, parts.models)) {
        parts.models.clear();
        return false;
    }
    bool are_good = true;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const PatchModel& model = parts.models[i];
        PatchNode& node = parts.nodes[i];
        if (model.known()) {
            node.form = form_of(model);
            node.model = &model;
            node.sizes = sizes_of(model);
        }
        are_good = are_good && model.known() && is_good(model, node.form);
    }
    return are_good;
}

void PatchTree::make_forms(const PatchForms::Boxes& boxes, PatchNode::Children& parts) const {
    if (make_models(boxes, parts)) return;
    PatchForms::Forms forms;
    forms_.evaluate(boxes, forms);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        PatchNode& node = parts.nodes[i];
        if (node.model != nullptr && !is_tighter(forms[i], node.form)) continue;
        node.form = forms[i];
        node.model = nullptr;
    }
}

PatchNode::Children* PatchTree::keep(std::atomic<PatchNode::Children*>& at,
                                     std::unique_ptr<PatchNode::Children> made) const {
    // Where two threads make the same parts, those of the first one count.
    PatchNode::Children* before = nullptr;
    if (!at.compare_exchange_strong(before, made.get(), std::memory_order_acq_rel)) return before;
    nodes_ += made->nodes.size();
    return made.release();
}

PatchNode::Children* PatchTree::parts(PatchNode& node) const {
    if (PatchNode::Children* const known = node.children.load(std::memory_order_acquire))
        return known;
    if (is_full()) return nullptr;
    const auto [width, height] = lengths_of(node.form);
    const bool is_jump = node.form.is_bounded_jump() && node.level > 0;
    auto made = is_jump ? jump_parts(node) : parts_by(node, division_of(width, height));
    return keep(node.children, std::move(made));
}

std::unique_ptr<PatchNode::Children> PatchTree::parts_by(const PatchNode& node,
                                                         const Division& division) const {
    auto made = std::make_unique<PatchNode::Children>(PatchForms::at_once);
    make_forms(place_parts(node, division, *made), *made);
    made->forms = forms_of(made->nodes);
    return made;
}

std::unique_ptr<PatchNode::Children> PatchTree::jump_parts(const PatchNode& node) const {
    constexpr Division across{.cols = 16, .rows = 1};
    constexpr Division along{.cols = 1, .rows = 16};
    if (is_thin(node.box))
        return parts_by(node, node.box.u_radius < node.box.v_radius ? along : across);
    auto first = parts_by(node, across);
    auto second = parts_by(node, along);
    const auto size = [](const PatchNode::Children& parts) {
        double sum = 0.0;
        for (const PatchNode& part : parts.nodes)
            sum += part.form.nowhere || !part.form.known() ? 0.0 : glm::length(part.form.spread());
        return sum;
    };
    return size(*first) <= size(*second) ? std::move(first) : std::move(second);
}

PatchNode::Children* PatchTree::quarters(PatchNode& node) const {
    const auto of_use = [](PatchNode::Children* some) {
        return some->nodes.empty() ? nullptr : some;
    };
    if (PatchNode::Children* const known = node.quarters.load(std::memory_order_acquire))
        return of_use(known);
    if (is_full()) return nullptr;
    auto made = std::make_unique<PatchNode::Children>(4);
    const PatchForm& form = node.form;
    const Division division =
        quarters_of(length_of(form.du, form.du_radius), length_of(form.dv, form.dv_radius));
    const PatchForms::Boxes boxes = place_parts(node, division, *made);
    if (make_models(std::span(boxes).first(4), *made)) {
        made->forms = forms_of(made->nodes);
    } else {
        made = std::make_unique<PatchNode::Children>(0);
    }
    return of_use(keep(node.quarters, std::move(made)));
}

Box PatchTree::within(const Box& clip) const {
    if (!box_) return clip;
    return {.lo = glm::max(clip.lo, box_->lo), .hi = glm::min(clip.hi, box_->hi)};
}

std::vector<Box> PatchTree::boxes() const {
    std::vector<Box> boxes;
    const auto add = [&](const PatchForm& form) {
        if (form.nowhere) return;
        const glm::dvec3 spread = form.spread() * (1.0 + 0x1p-40) + 0x1p-50 * glm::abs(form.c);
        const Box box = within({.lo = form.c - spread, .hi = form.c + spread});
        if (glm::all(glm::lessThanEqual(box.lo, box.hi))) boxes.push_back(box);
    };
    PatchNode::Children* const parts = this->parts(root_);
    if (parts == nullptr) {
        add(root_.form);
        return boxes;
    }
    for (PatchNode& part : parts->nodes) {
        PatchNode::Children* const smaller = this->parts(part);
        if (smaller == nullptr) {
            add(part.form);
            continue;
        }
        for (const PatchNode& node : smaller->nodes)
            add(node.form);
    }
    return boxes;
}

std::shared_ptr<const PatchTree> patch_tree(const Kernel& kernel, const Uniforms& uniforms) {
    assert(is_patch(kernel));
    const std::shared_ptr<KeptTree> kept = kernel.memory->of<KeptTree>();
    const std::scoped_lock lock(kept->mutex);
    const auto code = surface_facts(kernel).patch;
    std::vector<double> ends = ends_read(*code, uniforms);
    const bool is_same = kept->tree != nullptr && !kept->tree->is_full() && kept->uniforms == ends;
    if (!is_same) {
        kept->uniforms = std::move(ends);
        kept->tree = std::make_shared<const PatchTree>(code, uniforms);
    }
    return kept->tree;
}

const PatchTree& tree_of(const TraceFrame& frame) {
    assert(dynamic_cast<const PatchTree*>(frame.prepared) != nullptr);
    return *static_cast<const PatchTree*>(frame.prepared);
}

}  // namespace zeroset
