#include "ui/style/fonts.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_freetype.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

#ifndef ZEROSET_FONT_DIR
#define ZEROSET_FONT_DIR "/usr/share/fonts/truetype/dejavu"
#endif

namespace zeroset::ui {
namespace {

struct FontChoice {
    const char* file;
    float size;  ///< design units
};

/// File and size of each FontRole, indexed by it.
constexpr std::array<FontChoice, 4> choices{{{.file = "DejaVuSans.ttf", .size = 14.0F},
                                             {.file = "DejaVuSans.ttf", .size = 12.0F},
                                             {.file = "DejaVuSansMono.ttf", .size = 15.0F},
                                             {.file = "DejaVuSansMono.ttf", .size = 12.0F}}};

/// Ranges of characters (first, last) that formulas and their explanations use; ends with 0.
constexpr std::array<ImWchar, 17> glyph_ranges{
    0x0020, 0x017F,  // Latin, with × · ÷ and the superscripts 1 to 3
    0x0370, 0x03FF,  // Greek
    0x2000, 0x206F,  // dashes, quotes, spaces
    0x2070, 0x209F,  // superscripts and subscripts
    0x2190, 0x21FF,  // arrows
    0x2200, 0x22FF,  // mathematical operators, with − √ ≤ ≥ ≠ ≈ ∞
    0x25A0, 0x25FF,  // geometric shapes
    0xFFFD, 0xFFFD,  // replacement character
    0};

void add_font(ImFontAtlas& atlas, const FontChoice& choice, float content_scale) {
    const float size_px = std::round(choice.size * content_scale);
    const std::string path = std::string(ZEROSET_FONT_DIR) + "/" + choice.file;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) &&
        atlas.AddFontFromFileTTF(path.c_str(), size_px, nullptr, glyph_ranges.data()) != nullptr) {
        return;
    }
    ImFontConfig config;
    config.SizePixels = size_px;
    atlas.AddFontDefault(&config);
}

}  // namespace

void load_fonts(float content_scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    for (const FontChoice& choice : choices) {
        add_font(atlas, choice, content_scale);
    }
}

ImFont* font(FontRole role) { return ImGui::GetIO().Fonts->Fonts[static_cast<int>(role)]; }

}  // namespace zeroset::ui
