#include "engine/image/color_map.hpp"

#include "engine/base/enum_names.hpp"
#include "engine/image/gamma.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

// Each map is a path through OKLab (Björn Ottosson, 2020), where distances are perceived
// differences: lightness and hue change evenly, and the chroma stays within what screens can show.

namespace zeroset {
namespace {

constexpr auto names = enum_names<ColorMap>("aurora", "ember", "balance", "gray", "cycle");

constexpr Reflectance no_number{0.18F, 0.18F, 0.18F};

struct Lch {
    double lightness, chroma, hue_deg;
};

/// The reflectance that a picture of gamma 2 shows as `light`, linear, on an sRGB screen.
float reflectance(double light) {
    const double within = std::clamp(light, 0.0, 1.0);
    const double shown =
        within <= 0.0031308 ? 12.92 * within : 1.055 * std::pow(within, 1.0 / 2.4) - 0.055;
    return static_cast<float>(gamma_decoded(shown));
}

Reflectance shown_as(const Lch& color) {
    const double hue = color.hue_deg * std::numbers::pi / 180.0;
    const double a = color.chroma * std::cos(hue);
    const double b = color.chroma * std::sin(hue);
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(color.lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(color.lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(color.lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {reflectance(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            reflectance(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            reflectance(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

/// Piecewise linear: `first` at t = 0, `middle` at `bend`, `last` at 1.
double bent(double t, double bend, double first, double middle, double last) {
    return t < bend ? std::lerp(first, middle, t / bend)
                    : std::lerp(middle, last, (t - bend) / (1.0 - bend));
}

Lch path(ColorMap map, double t) {
    switch (map) {
        case ColorMap::Aurora:
            return {.lightness = std::lerp(0.30, 0.93, t),
                    .chroma = bent(t, 0.45, 0.13, 0.098, 0.175),
                    .hue_deg = std::lerp(300.0, 105.0, t)};
        case ColorMap::Ember:
            return {.lightness = std::lerp(0.28, 0.95, t),
                    .chroma = bent(t, 0.4, 0.11, 0.165, 0.07),
                    .hue_deg = std::lerp(-10.0, 95.0, t)};
        case ColorMap::Balance: {
            const double off = std::abs(2.0 * t - 1.0);
            return {.lightness = std::lerp(0.95, 0.42, off),
                    .chroma = 0.118 * off,
                    .hue_deg = t < 0.5 ? 252.0 : 35.0};
        }
        case ColorMap::Gray:
            return {.lightness = std::lerp(0.15, 0.97, t), .chroma = 0.0, .hue_deg = 0.0};
        case ColorMap::Cycle:
            return {.lightness = 0.72, .chroma = 0.11, .hue_deg = 30.0 + 360.0 * t};
    }
    return {};
}

constexpr std::size_t steps = 512;
using Table = std::array<Reflectance, steps + 1>;

const Table& table_of(ColorMap map) {
    static const std::vector<Table> tables = [] {
        std::vector<Table> made(color_maps().size());
        for (std::size_t m = 0; m < made.size(); ++m) {
            for (std::size_t i = 0; i <= steps; ++i)
                made[m][i] = shown_as(path(color_maps()[m], static_cast<double>(i) / steps));
        }
        return made;
    }();
    return tables[static_cast<std::size_t>(map)];
}

}  // namespace

std::span<const ColorMap> color_maps() { return names.values(); }

std::string_view name_of(ColorMap map) { return names.of(map); }

std::optional<ColorMap> color_map_named(std::string_view name) { return names.named(name); }

Reflectance color_at(ColorMap map, double place) {
    if (std::isnan(place)) return no_number;
    const double step = std::floor(std::clamp(place, 0.0, 1.0) * steps + 0.5);
    return table_of(map)[static_cast<std::size_t>(step)];
}

std::uint32_t shown_color_at(ColorMap map, double place) {
    std::uint32_t color = 0xFF000000U;
    unsigned shift = 0;
    for (const float light : color_at(map, place)) {
        color |= channel_of_light(light) << shift;
        shift += 8;
    }
    return color;
}

}  // namespace zeroset
