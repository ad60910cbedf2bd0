#include "document/colors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <optional>

namespace zeroset {
namespace {

/// Turns 0xAABBGGRR into 0xRRGGBB, and back.
std::uint32_t swapped(std::uint32_t color) {
    return (color & 0xFFU) << 16U | (color & 0xFF00U) | (color >> 16U & 0xFFU);
}

/// The reflectance of a channel that shows as `byte`, see swatch_color.
float light(std::uint32_t byte) {
    const float part = static_cast<float>(byte & 0xFFU) / 255.0F;
    return part * part;
}

std::uint32_t free_color(const Document& document, std::size_t fallback) {
    const std::vector<std::uint32_t>& fronts = palette_fronts();
    for (const std::uint32_t front : fronts) {
        if (std::ranges::find(document.statements, std::optional(front), &Statement::color) ==
            document.statements.end()) {
            return front;
        }
    }
    return fronts[fallback % fronts.size()];
}

}  // namespace

const std::vector<std::uint32_t>& palette_fronts() {
    static const std::vector<std::uint32_t> fronts = [] {
        std::vector<std::uint32_t> colors;
        for (std::size_t i = 0; i < palette().size(); ++i)
            colors.push_back(swapped(swatch_color(i)) & 0xFFFFFFU);
        return colors;
    }();
    return fronts;
}

std::string color_text(std::uint32_t color) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%06X", color & 0xFFFFFFU);
    return text.data();
}

std::optional<std::uint32_t> color_from(std::string_view text) {
    std::uint32_t color = 0;
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + 1, end, color, 16);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return color;
}

SurfaceColors surface_colors(std::uint32_t front) {
    const auto known = std::ranges::find(palette_fronts(), front);
    if (known != palette_fronts().end()) {
        return colors_of(static_cast<std::size_t>(known - palette_fronts().begin()));
    }
    SurfaceColors colors{.front = {light(front >> 16U), light(front >> 8U), light(front)},
                         .back = {}};
    const float(&side)[3] = colors.front;
    const float brightness = 0.2126F * side[0] + 0.7152F * side[1] + 0.0722F * side[2];
    const bool is_light = brightness > 0.5F;
    // Paler tones are as bright as they can be, so that they keep their hue in shade.
    const float strongest = std::max({side[0], side[1], side[2], 1e-3F});
    for (std::size_t i = 0; i < 3; ++i)
        colors.back[i] = is_light ? 0.25F * side[i] : 0.5F + 0.45F * side[i] / strongest;
    return colors;
}

std::uint32_t back_color(std::uint32_t front) {
    return swapped(swatch_color(surface_colors(front).back)) & 0xFFFFFFU;
}

bool choose_colors(Document& document, const std::vector<int>& surface_rows) {
    bool changed = false;
    for (std::size_t i = 0; i < surface_rows.size(); ++i) {
        const auto row = std::ranges::find(document.statements, surface_rows[i], &Statement::id);
        if (row == document.statements.end() || row->color) continue;
        row->color = free_color(document, i);
        changed = true;
    }
    return changed;
}

}  // namespace zeroset
