#include "engine/expr/patch_graph.hpp"

#include "engine/expr/copy.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The function of which nothing is known, at a point that a row is given by.
class PatchField : public Field {
public:
    PatchField(PatchKind kind, const std::optional<RowBox>& box) : kind_(kind), box_(box) {}

    [[nodiscard]] PatchKind kind() const { return kind_; }
    [[nodiscard]] const std::optional<RowBox>& box() const { return box_; }
    [[nodiscard]] std::string text() const override { return {}; }
    [[nodiscard]] bool is_total() const override { return false; }
    [[nodiscard]] bool is_continuous() const override { return false; }

    void values(int, const float*, float* out, int lanes) const override { value(out, lanes); }
    void values(int, const double*, double* out, int lanes) const override { value(out, lanes); }
    void ranges(int, const float*, float* out, int lanes) const override { range(out, lanes); }
    void ranges(int, const double*, double* out, int lanes) const override { range(out, lanes); }
    void forms(const float*, float* out, int lanes) const override { form(out, lanes); }
    void forms(const double*, double* out, int lanes) const override { form(out, lanes); }

private:
    template <class Real>
    static void fill(Real* out, int lanes, std::size_t first, std::size_t count, Real value) {
        const auto width = static_cast<std::size_t>(lanes);
        std::fill_n(out + first * width, count * width, value);
    }
    template <class Real>
    static void value(Real* out, int lanes) {
        fill(out, lanes, 0, FieldValue::answers, std::numeric_limits<Real>::quiet_NaN());
    }
    template <class Real>
    static void range(Real* out, int lanes) {
        fill(out, lanes, FieldRange::range, 2, std::numeric_limits<Real>::infinity());
        fill(out, lanes, FieldRange::somewhere, 1, Real{1});
        fill(out, lanes, FieldRange::everywhere, 2, Real{0});
    }
    template <class Real>
    static void form(Real* out, int lanes) {
        fill(out, lanes, 0, FieldForm::answers, std::numeric_limits<Real>::infinity());
        fill(out, lanes, FieldForm::somewhere, 1, Real{1});
        fill(out, lanes, FieldForm::everywhere, 2, Real{0});
    }

    PatchKind kind_;
    std::optional<RowBox> box_;
};

/// One for each kind and box of late, so that equal rows are equal graphs.
std::shared_ptr<const Field> field_of(PatchKind kind, const std::optional<RowBox>& box) {
    constexpr std::size_t most_kept = 256;
    static std::mutex mutex;
    static std::deque<std::shared_ptr<const PatchField>> fields;
    const std::scoped_lock lock(mutex);
    const auto known = std::ranges::find_if(
        fields, [&](const auto& field) { return field->kind() == kind && field->box() == box; });
    if (known != fields.end()) return *known;
    if (fields.size() == most_kept) fields.pop_front();
    return fields.emplace_back(std::make_shared<const PatchField>(kind, box));
}

const PatchField* patch_field_of(const Expr& surface) {
    if (surface.nodes().empty()) return nullptr;
    return dynamic_cast<const PatchField*>(surface.node(surface.root()).field.get());
}

}  // namespace

NodeId make_patch(ExprBuilder& builder, PatchKind kind, const std::array<NodeId, 3>& point,
                  const std::optional<RowBox>& box) {
    return builder.look_up(field_of(kind, box), point[0], point[1], point[2]);
}

std::optional<PatchGraphs> patch_of(const Expr& surface) {
    const PatchField* const field = patch_field_of(surface);
    if (field == nullptr) return std::nullopt;
    ExprBuilder builder;
    const std::vector<NodeId> copies = copy_nodes(builder, surface);
    const Node& root = surface.node(surface.root());
    const auto names = surface.parameters();
    PatchGraphs graphs{.point = {}, .kind = field->kind(), .box = field->box()};
    const std::array operands{root.a, root.b, root.c};
    for (std::size_t i = 0; i < operands.size(); ++i)
        graphs.point.at(i) = builder.finish(copies[operands.at(i)], {names.begin(), names.end()});
    return graphs;
}

bool is_patch(const Expr& surface) { return patch_field_of(surface) != nullptr; }

}  // namespace zeroset
