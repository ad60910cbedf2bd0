#include "engine/annotate/label_font.hpp"

#include "engine/annotate/paint.hpp"
#include "engine/base/translation.hpp"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Height of a digit in DejaVu Sans.
constexpr double digit_height_em = 0.729;

/// The code point that begins `text`, which loses it; U+FFFD where it is no UTF-8.
int take_code_point(std::string_view& text) {
    const auto byte = static_cast<unsigned char>(text.front());
    const std::size_t more = byte < 0xC0 ? 0 : byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
    text.remove_prefix(1);
    if (byte < 0x80) return byte;
    if (more == 0 || text.size() < more) return 0xFFFD;
    int point = byte & (0x3F >> more);
    for (std::size_t i = 0; i < more; ++i)
        point = point << 6 | (static_cast<unsigned char>(text[i]) & 0x3F);
    text.remove_prefix(more);
    return point;
}

struct Glyphs {
    std::vector<unsigned char> coverage;
    int width = 0, height = 0;
};

void paint_glyph(Framebuffer& picture, const Glyphs& glyph, int left, int top,
                 std::uint32_t color) {
    picture.blank_rows.clear();
    for (int row = 0; row < glyph.height; ++row) {
        for (int col = 0; col < glyph.width; ++col) {
            const int x = left + col;
            const int y = top + row;
            if (x < 0 || x >= picture.width || y < 0 || y >= picture.height) continue;
            const auto at = static_cast<std::size_t>(row * glyph.width + col);
            std::uint32_t& pixel = picture.color[picture.index(x, y)];
            pixel = blended(pixel, color, glyph.coverage[at] / 255.0);
        }
    }
}

}  // namespace

struct LabelFont::Face {
    std::vector<unsigned char> file;
    stbtt_fontinfo info{};

    [[nodiscard]] double advance(int code_point, double scale) const {
        int width = 0;
        int bearing = 0;
        stbtt_GetCodepointHMetrics(&info, code_point, &width, &bearing);
        return scale * width;
    }
};

std::expected<LabelFont, std::string> LabelFont::load() {
    const std::string path = std::string(ZEROSET_FONT_DIR) + "/DejaVuSans.ttf";
    std::ifstream stream(path, std::ios::binary);
    auto face = std::make_shared<Face>();
    face->file.assign(std::istreambuf_iterator<char>(stream), {});
    if (face->file.empty() || stbtt_InitFont(&face->info, face->file.data(), 0) == 0) {
        return std::unexpected(
            filled(tr("cannot read the font {0}; install DejaVu (fonts-dejavu-core), or draw "
                      "without axes, marks and legend (--no-legend)"),
                   {path}));
    }
    return LabelFont(std::move(face));
}

double LabelFont::width(std::string_view text, double em) const {
    const double scale =
        static_cast<double>(stbtt_ScaleForMappingEmToPixels(&face_->info, static_cast<float>(em)));
    double width = 0.0;
    while (!text.empty())
        width += face_->advance(take_code_point(text), scale);
    return width;
}

void LabelFont::paint(Framebuffer& picture, const Text& text) const {
    glm::dvec2 start = text.at;
    const double wide = text.anchor == Anchor::TopLeft ? 0.0 : width(text.words, text.em);
    const bool centred = text.anchor == Anchor::Middle || text.anchor == Anchor::TopMiddle;
    start.x -= centred ? 0.5 * wide : wide;
    start.y += text.em * (text.anchor == Anchor::Middle ? 0.5 * digit_height_em : baseline_em);
    // Lines of text begin at whole pixels, so that those below one another look alike.
    if (text.anchor != Anchor::Middle) start.x = std::floor(start.x);
    if (text.outline >> 24U != 0) {
        for (const glm::dvec2& aside : outline_offsets(text.em))
            paint_letters(picture, start + aside, text.words, text.em, text.outline);
    }
    paint_letters(picture, start, text.words, text.em, text.color);
}

void LabelFont::paint_letters(Framebuffer& picture, const glm::dvec2& start, std::string_view words,
                              double em, std::uint32_t color) const {
    const float scale = stbtt_ScaleForMappingEmToPixels(&face_->info, static_cast<float>(em));
    double pen = start.x;
    const double baseline = std::round(start.y);
    while (!words.empty()) {
        const int point = take_code_point(words);
        const double whole = std::floor(pen);
        const auto shift = static_cast<float>(pen - whole);
        int left = 0;
        int top = 0;
        int right = 0;
        int bottom = 0;
        stbtt_GetCodepointBitmapBoxSubpixel(&face_->info, point, scale, scale, shift, 0.0F, &left,
                                            &top, &right, &bottom);
        Glyphs glyph{.coverage = {}, .width = right - left, .height = bottom - top};
        glyph.coverage.resize(static_cast<std::size_t>(glyph.width * glyph.height));
        stbtt_MakeCodepointBitmapSubpixel(&face_->info, glyph.coverage.data(), glyph.width,
                                          glyph.height, glyph.width, scale, scale, shift, 0.0F,
                                          point);
        paint_glyph(picture, glyph, static_cast<int>(whole) + left,
                    static_cast<int>(baseline) + top, color);
        pen += face_->advance(point, static_cast<double>(scale));
    }
}

}  // namespace zeroset
