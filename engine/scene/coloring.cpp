#include "engine/scene/coloring.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace zeroset {
namespace {

constexpr std::array<ColorBy, 8> modes{ColorBy::Plain,         ColorBy::Normal,
                                       ColorBy::Height,        ColorBy::Depth,
                                       ColorBy::MeanCurvature, ColorBy::GaussianCurvature,
                                       ColorBy::Gradient,      ColorBy::Expression};
constexpr std::array<std::string_view, 8> names{"plain",    "normal",         "height",
                                                "depth",    "mean-curvature", "gaussian-curvature",
                                                "gradient", "expression"};

}  // namespace

std::span<const ColorBy> color_modes() { return modes; }

std::string_view name_of(ColorBy by) { return names[static_cast<std::size_t>(by)]; }

std::optional<ColorBy> color_by_named(std::string_view name) {
    const auto* const found = std::ranges::find(names, name);
    if (found == names.end()) return std::nullopt;
    return modes[static_cast<std::size_t>(found - names.begin())];
}

bool has_range(ColorBy by) { return by != ColorBy::Plain && by != ColorBy::Normal; }

bool has_formula(ColorBy by) { return by >= ColorBy::MeanCurvature; }

bool is_of_skin(ColorBy by) { return is_signed(by) || by == ColorBy::Gradient; }

bool is_signed(ColorBy by) {
    return by == ColorBy::MeanCurvature || by == ColorBy::GaussianCurvature;
}

ColorMap usual_map(ColorBy by) { return is_signed(by) ? ColorMap::Balance : ColorMap::Aurora; }

}  // namespace zeroset
