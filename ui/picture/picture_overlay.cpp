#include "ui/picture/picture_overlay.hpp"

#include "ui/picture/legend.hpp"
#include "ui/picture/picture_marks.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset::ui {
namespace {

/// The fonts' glyphs: opacities.
struct Glyphs {
    const std::uint8_t* alpha;
    int width, height;

    /// At a place from 0 to 1.
    [[nodiscard]] double at(double u, double v) const {
        const double x = std::clamp(u * width - 0.5, 0.0, width - 1.001);
        const double y = std::clamp(v * height - 0.5, 0.0, height - 1.001);
        const double col = std::floor(x);
        const double row = std::floor(y);
        const auto texel = [&](double c, double r) {
            return static_cast<double>(
                alpha[static_cast<std::size_t>(r) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(c)]);
        };
        const double above = std::lerp(texel(col, row), texel(col + 1, row), x - col);
        const double below = std::lerp(texel(col, row + 1), texel(col + 1, row + 1), x - col);
        return std::lerp(above, below, y - row) / 255.0;
    }
};

double channel(std::uint32_t color, unsigned index) {
    return static_cast<double>(color >> (8U * index) & 0xFFU);
}

/// A triangle of ImGui's, with the weights of its corners.
class Triangle {
public:
    Triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c) : corners_{&a, &b, &c} {
        area_ = cross(0, 1, corners_[2]->pos);
        if (area_ < 0) {
            std::swap(corners_[1], corners_[2]);
            area_ = -area_;
        }
    }

    /// The weights at a point, if it belongs to the triangle: points on an edge that two share
    /// belong to one of them.
    [[nodiscard]] bool weights(const ImVec2& p, std::array<double, 3>& w) const {
        if (!(area_ > 0)) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = (i + 1) % 3;
            const std::size_t to = (i + 2) % 3;
            w[i] = cross(from, to, p) / area_;
            if (w[i] < 0 || (w[i] == 0 && !owns_edge(from, to))) return false;
        }
        return true;
    }
    [[nodiscard]] std::uint32_t color(const std::array<double, 3>& w, const Glyphs& glyphs,
                                      double& opacity) const {
        std::uint32_t mixed = 0;
        const auto mix = [&](auto value) {
            return w[0] * value(*corners_[0]) + w[1] * value(*corners_[1]) +
                   w[2] * value(*corners_[2]);
        };
        for (unsigned i = 0; i < 3; ++i) {
            const double part = mix([i](const ImDrawVert& v) { return channel(v.col, i); });
            mixed |= static_cast<std::uint32_t>(part + 0.5) << (8U * i);
        }
        const double u = mix([](const ImDrawVert& v) { return static_cast<double>(v.uv.x); });
        const double v = mix([](const ImDrawVert& p) { return static_cast<double>(p.uv.y); });
        const double alpha = mix([](const ImDrawVert& p) { return channel(p.col, 3); });
        opacity = alpha / 255.0 * glyphs.at(u, v);
        return mixed;
    }
    [[nodiscard]] std::array<const ImDrawVert*, 3> corners() const { return corners_; }

private:
    [[nodiscard]] double cross(std::size_t from, std::size_t to, const ImVec2& p) const {
        const ImVec2 a = corners_.at(from)->pos;
        const ImVec2 b = corners_.at(to)->pos;
        const auto in_double = [](float x) { return static_cast<double>(x); };
        return (in_double(b.x) - in_double(a.x)) * (in_double(p.y) - in_double(a.y)) -
               (in_double(b.y) - in_double(a.y)) * (in_double(p.x) - in_double(a.x));
    }
    /// Top and left edges, as graphics cards do.
    [[nodiscard]] bool owns_edge(std::size_t from, std::size_t to) const {
        const ImVec2 a = corners_.at(from)->pos;
        const ImVec2 b = corners_.at(to)->pos;
        return b.y < a.y || (b.y == a.y && b.x > a.x);
    }

    std::array<const ImDrawVert*, 3> corners_;
    double area_;
};

void blend(std::uint32_t& pixel, std::uint32_t color, double opacity) {
    std::uint32_t mixed = 0xFF000000U;
    for (unsigned i = 0; i < 3; ++i) {
        const double part = std::lerp(channel(pixel, i), channel(color, i), opacity);
        mixed |= static_cast<std::uint32_t>(part + 0.5) << (8U * i);
    }
    pixel = mixed;
}

/// Columns or rows [first, last) whose centres lie between lo and hi, as far as they are clipped.
struct Span {
    int first, last;

    Span(float lo, float hi, float clip_lo, float clip_hi, int size)
        : first(std::max(static_cast<int>(std::ceil(std::max(lo, clip_lo) - 0.5F)), 0)),
          last(std::min(static_cast<int>(std::floor(std::min(hi, clip_hi) - 0.5F)) + 1, size)) {}
};

void fill(const Triangle& triangle, const ImVec4& clip, const Glyphs& glyphs,
          Framebuffer& picture) {
    const auto corners = triangle.corners();
    const auto [left, right] =
        std::minmax({corners[0]->pos.x, corners[1]->pos.x, corners[2]->pos.x});
    const auto [top, bottom] =
        std::minmax({corners[0]->pos.y, corners[1]->pos.y, corners[2]->pos.y});
    const Span cols(left, right, clip.x, clip.z, picture.width);
    const Span rows(top, bottom, clip.y, clip.w, picture.height);
    std::array<double, 3> w{};
    for (int row = rows.first; row < rows.last; ++row) {
        for (int col = cols.first; col < cols.last; ++col) {
            const ImVec2 centre(static_cast<float>(col) + 0.5F, static_cast<float>(row) + 0.5F);
            if (!triangle.weights(centre, w)) continue;
            double opacity = 0.0;
            const std::uint32_t color = triangle.color(w, glyphs, opacity);
            blend(picture.color[picture.index(col, row)], color, opacity);
        }
    }
}

void fill(const ImDrawData& data, const Glyphs& glyphs, Framebuffer& picture) {
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            for (unsigned k = 0; k + 2 < command.ElemCount; k += 3) {
                const auto corner = [&](unsigned at) -> const ImDrawVert& {
                    const ImDrawIdx index =
                        list.IdxBuffer[static_cast<int>(command.IdxOffset + k + at)];
                    return list.VtxBuffer[static_cast<int>(command.VtxOffset + index)];
                };
                fill(Triangle(corner(0), corner(1), corner(2)), command.ClipRect, glyphs, picture);
            }
        }
    }
}

/// ImGui without a window.
class Canvas {
public:
    Canvas(float width, float height, float scale, Theme theme) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.DisplaySize = ImVec2(width, height);
        load_fonts(scale);
        unsigned char* alpha = nullptr;
        io.Fonts->GetTexDataAsAlpha8(&alpha, &glyphs_.width, &glyphs_.height);
        glyphs_.alpha = alpha;
        apply_theme(theme, scale);
        ImGui::NewFrame();
    }
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;
    ~Canvas() { ImGui::DestroyContext(); }

    [[nodiscard]] const Glyphs& glyphs() const { return glyphs_; }

private:
    Glyphs glyphs_{};
};

/// Letters of a size that suits the picture.
float scale_for(const Framebuffer& picture) {
    constexpr float usual_side = 800.0F;
    constexpr float small_side = 300.0F;
    const auto side = static_cast<float>(std::min(picture.width, picture.height));
    const float least = side < small_side ? 0.75F : 1.0F;
    return std::clamp(std::round(4.0F * side / usual_side) / 4.0F, least, 8.0F);
}

}  // namespace

void draw_over(Framebuffer& picture, float scale, Theme theme,
               const std::function<void(ImDrawList&)>& draw) {
    picture.blank_rows.clear();
    const Canvas canvas(static_cast<float>(picture.width), static_cast<float>(picture.height),
                        scale, theme);
    draw(*ImGui::GetBackgroundDrawList());
    ImGui::Render();
    fill(*ImGui::GetDrawData(), canvas.glyphs(), picture);
}

void draw_marks_over(Framebuffer& picture, const Camera& camera, const std::vector<Marker>& markers,
                     const Legend* legend) {
    if (markers.empty() && legend == nullptr) return;
    const Palette& colors = palette(Theme::Dark);
    const ImVec2 size(static_cast<float>(picture.width), static_cast<float>(picture.height));
    draw_over(picture, scale_for(picture), Theme::Dark, [&](ImDrawList& canvas) {
        draw_markers(canvas, ImVec2(0.0F, 0.0F), size, {markers, picture, camera}, colors);
        const float margin = em(1.0F);
        draw_corner_legend(canvas, ImVec2(size.x - margin, size.y - margin),
                           ImVec2(size.x - 2.0F * margin, size.y - 2.0F * margin), {legend, false},
                           colors);
    });
}

}  // namespace zeroset::ui
