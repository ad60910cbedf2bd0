#include "engine/scene/coloring.hpp"

#include "engine/base/enum_names.hpp"

namespace zeroset {
namespace {

constexpr auto color_names =
    enum_names<ColorBy>("plain", "normal", "height", "depth", "mean-curvature",
                        "gaussian-curvature", "gradient", "expression");

}  // namespace

std::span<const ColorBy> color_modes() { return color_names.values(); }

std::string_view name_of(ColorBy by) { return color_names.of(by); }

std::optional<ColorBy> color_by_named(std::string_view name) { return color_names.named(name); }

bool has_range(ColorBy by) { return by != ColorBy::Plain && by != ColorBy::Normal; }

bool has_formula(ColorBy by) { return by >= ColorBy::MeanCurvature; }

bool is_of_skin(ColorBy by) { return is_signed(by) || by == ColorBy::Gradient; }

bool is_signed(ColorBy by) {
    return by == ColorBy::MeanCurvature || by == ColorBy::GaussianCurvature;
}

ColorMap usual_map(ColorBy by) { return is_signed(by) ? ColorMap::Balance : ColorMap::Aurora; }

}  // namespace zeroset
