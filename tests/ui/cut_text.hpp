#pragma once

// Finds texts of a frame that are cut, or lie over one another.

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui {

/// A letter is drawn this much wider than what is seen of it.
inline constexpr float margin_px = 1.0F;

using Corners = std::array<float, 4>;  ///< of a letter in the atlas: left, top, right, bottom

/// The letters of all fonts.
class Letters {
public:
    Letters() {
        for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) {
            for (const ImFontGlyph& glyph : font->Glyphs)
                letters_[{glyph.U0, glyph.V0, glyph.U1, glyph.V1}] = glyph.Codepoint;
        }
    }

    [[nodiscard]] std::optional<unsigned> whole(const Corners& at) const {
        const auto found = letters_.find(at);
        return found == letters_.end() ? std::nullopt : std::optional(found->second);
    }
    /// The letter of which only a part is drawn, and the corners of all of it.
    [[nodiscard]] std::optional<std::pair<Corners, unsigned>> part(const Corners& at) const {
        for (const auto& [all, letter] : letters_) {
            if (at[0] >= all[0] && at[1] >= all[1] && at[2] <= all[2] && at[3] <= all[3])
                return std::pair(all, letter);
        }
        return std::nullopt;
    }

private:
    std::map<Corners, unsigned> letters_;
};

struct Drawn {
    ImRect place;
    unsigned letter = 0;
    bool cut = false;
};

/// The quad that begins at an index, if it is one.
inline std::optional<std::array<const ImDrawVert*, 2>> quad_at(const ImDrawList& list, unsigned at,
                                                               unsigned end) {
    if (at + 6 > end) return std::nullopt;
    const auto index = [&](unsigned i) {
        return unsigned{list.IdxBuffer[static_cast<int>(at + i)]};
    };
    const unsigned first = index(0);
    if (index(1) != first + 1 || index(2) != first + 2 || index(3) != first ||
        index(4) != first + 2 || index(5) != first + 3)
        return std::nullopt;
    return std::array{&list.VtxBuffer[static_cast<int>(first)],
                      &list.VtxBuffer[static_cast<int>(first + 2)]};
}

inline std::string utf8_of(unsigned letter) {
    std::array<char, 5> bytes{};
    ImTextCharToUtf8(bytes.data(), letter);
    return bytes.data();
}

/// The letters of one list of a window that are in sight, in the order in which they were drawn.
inline std::vector<Drawn> letters_of(const ImDrawList& list, const Letters& letters) {
    std::vector<Drawn> drawn;
    const ImTextureID font = ImGui::GetIO().Fonts->TexID;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.TextureId != font) continue;
        const ImRect clip(command.ClipRect);
        const unsigned end = command.IdxOffset + command.ElemCount;
        for (unsigned at = command.IdxOffset; at < end;) {
            const auto quad = quad_at(list, at, end);
            if (!quad) {
                at += 3;
                continue;
            }
            at += 6;
            const auto [from, to] = *quad;
            const Corners corners{from->uv.x, from->uv.y, to->uv.x, to->uv.y};
            const ImRect place(from->pos, to->pos);
            if (place.Max.y <= clip.Min.y || place.Min.y >= clip.Max.y) continue;
            if (const auto whole = letters.whole(corners)) {
                const bool cut =
                    place.Min.x < clip.Min.x - margin_px || place.Max.x > clip.Max.x + margin_px;
                drawn.push_back({.place = place, .letter = *whole, .cut = cut});
            } else if (const auto part = letters.part(corners)) {
                // Above and below letters are cut where a list is scrolled.
                const bool narrow = corners[0] > part->first[0] || corners[2] < part->first[2];
                drawn.push_back({.place = place, .letter = part->second, .cut = narrow});
            }
        }
    }
    return drawn;
}

/// The text that a letter is a part of.
inline std::string text_around(const std::vector<Drawn>& drawn, std::size_t at) {
    const auto follows = [&](std::size_t next) {
        const ImRect& a = drawn[next - 1].place;
        const ImRect& b = drawn[next].place;
        return b.Min.x >= a.Min.x && b.Min.x - a.Max.x < 2.0F * ImGui::GetFontSize() &&
               b.Min.y < a.Max.y + a.GetHeight() && b.Max.y > a.Min.y - a.GetHeight();
    };
    std::size_t from = at;
    while (from > 0 && follows(from))
        --from;
    std::string text;
    for (std::size_t i = from; i < drawn.size() && (i == from || follows(i)); ++i) {
        if (i > from &&
            drawn[i].place.Min.x - drawn[i - 1].place.Max.x > 0.2F * ImGui::GetFontSize())
            text += ' ';
        text += utf8_of(drawn[i].letter);
    }
    return text;
}

inline bool overlap(const ImRect& a, const ImRect& b) {
    const float wide = std::min(a.Max.x, b.Max.x) - std::max(a.Min.x, b.Min.x);
    const float high = std::min(a.Max.y, b.Max.y) - std::max(a.Min.y, b.Min.y);
    return wide > 2.0F * margin_px && high > 2.0F * margin_px;
}

/// Texts of the last frame that are cut at a side, or that lie over other texts of the same window:
/// "WINDOW: text". Where a text is too long for its place it has to end in an ellipsis.
inline std::vector<std::string> cut_texts() {
    const Letters letters;
    const ImDrawData& data = *ImGui::GetDrawData();
    std::vector<std::string> found;
    const auto add = [&](const ImDrawList& list, const std::string& what) {
        std::string line = std::string(list._OwnerName) + ": " + what;
        if (std::ranges::find(found, line) == found.end()) found.push_back(std::move(line));
    };
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        const std::vector<Drawn> drawn = letters_of(list, letters);
        std::vector<std::size_t> by_height(drawn.size());
        std::iota(by_height.begin(), by_height.end(), std::size_t{0});
        std::ranges::sort(by_height, {}, [&](std::size_t at) { return drawn[at].place.Min.y; });
        for (std::size_t i = 0; i < by_height.size(); ++i) {
            const Drawn& letter = drawn[by_height[i]];
            if (letter.cut) add(list, "cut: " + text_around(drawn, by_height[i]));
            for (std::size_t k = i + 1; k < by_height.size(); ++k) {
                const Drawn& below = drawn[by_height[k]];
                if (below.place.Min.y > letter.place.Max.y) break;
                if (overlap(letter.place, below.place))
                    add(list, "over another text: " + text_around(drawn, by_height[i]) + " | " +
                                  text_around(drawn, by_height[k]));
            }
        }
    }
    return found;
}

}  // namespace zeroset::ui
