#include "engine/base/translation.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/label.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/card_grid.hpp"
#include "ui/widgets/scroll_fade.hpp"
#include "ui/widgets/typing_popup.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace zeroset::ui {
namespace {

constexpr const char* gallery_popup = "##gallery page";
/// Width of the picture from which the page covers only it; a narrower picture's page covers the
/// window.
constexpr float least_width_em = 34.0F;
constexpr float card_em = 13.0F;  ///< least width of a card
constexpr float gap_em = 0.7F;
/// Least height of the window for showing details of the selected surface.
constexpr float details_from_em = 26.0F;
constexpr float details_em = 6.0F;
/// No line of the gallery: the best of those found is selected.
constexpr auto no_item = std::numeric_limits<std::size_t>::max();
constexpr glm::vec2 picture_size(320.0F, 240.0F);  ///< at scale 1
constexpr float picture_aspect = 0.75F;            ///< height over width

struct Grid {
    int columns;
    float card_width;
    float picture_height;
    float card_height;
};

void place_gallery(const Layout& layout) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float left = side_panel_width(layout);
    const bool wide = window.x - left >= em(least_width_em);
    const float margin = wide ? em(0.8F) : em(0.4F);
    const ImVec2 lo((wide ? left : 0.0F) + margin, margin);
    const float bottom = window.y - (wide ? status_bar_height() : 0.0F) - margin;
    ImGui::SetNextWindowPos(lo);
    ImGui::SetNextWindowSize(ImVec2(window.x - margin - lo.x, bottom - lo.y));
}

bool has_details() { return ImGui::GetIO().DisplaySize.y >= em(details_from_em); }

void draw_head(GalleryPage& page, const Palette& colors) {
    const float size = ImGui::GetFrameHeight();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Gallery"));
    ImGui::SameLine(0.0F, em(1.0F));
    const float space = ImGui::GetContentRegionAvail().x - size - em(0.4F);
    ImGui::SetNextItemWidth(std::min(space, em(24.0F)));
    if (draw_popup_field(page, tr("find a name, a word, a part of an equation"), page.search)) {
        page.selected = no_item;
        page.follow = true;
    }
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - size);
    if (icon_button("##close", Icon::Cross, {.size = size, .color = colors.quiet},
                    tr("Close (Esc)"))) {
        page.open = false;
    }
}

Grid grid_of(float width) {
    const float gap = em(gap_em);
    const float columns = std::max(std::floor((width + gap) / (em(card_em) + gap)), 1.0F);
    const float card = std::floor((width - (columns - 1.0F) * gap) / columns);
    const float picture = std::floor(picture_aspect * card);
    const float texts = 2.0F * ImGui::GetTextLineHeight() + em(0.9F);
    return {.columns = static_cast<int>(columns),
            .card_width = card,
            .picture_height = picture,
            .card_height = picture + texts};
}

void follow_arrows(GalleryPage& page, const std::vector<Card>& cards) {
    constexpr int rows_of_a_page = 2;
    int rows = 0;
    int cols = 0;
    if (is_pressed(ImGuiKey_UpArrow)) --rows;
    if (is_pressed(ImGuiKey_DownArrow)) ++rows;
    if (is_pressed(ImGuiKey_PageUp)) rows -= rows_of_a_page;
    if (is_pressed(ImGuiKey_PageDown)) rows += rows_of_a_page;
    if (is_pressed(ImGuiKey_LeftArrow)) --cols;
    if (is_pressed(ImGuiKey_RightArrow)) ++cols;
    const bool lost = std::ranges::find(cards, page.selected, &Card::item) == cards.end();
    if (rows == 0 && cols == 0 && !lost) return;
    page.selected = stepped(cards, page.selected, rows, cols);
    page.follow = true;
}

/// A text of the entry in the language of the window; those of people's documents stay.
const char* shown_text(const GalleryEntry& entry, const std::string& text) {
    return entry.path.empty() ? tr(text.c_str()) : text.c_str();
}

void draw_texts(const GalleryEntry& entry, const ImVec2& lo, const Grid& grid,
                const Palette& colors) {
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const float left = lo.x + em(0.5F);
    const float top = lo.y + grid.picture_height + em(0.3F);
    const float space = grid.card_width - em(0.8F);
    canvas.AddText(ImVec2(left, top), colors.text,
                   elided(shown_text(entry, entry.title), space).c_str());
    const ImVec2 below(left, top + ImGui::GetTextLineHeight() + em(0.15F));
    ImGui::PushFont(font(FontRole::SmallFormula));
    canvas.AddText(below, colors.quiet, elided(in_one_line(entry.equation), space).c_str());
    ImGui::PopFont();
}

/// Draws a card; true if it was clicked.
bool draw_card(UiState& state, std::size_t item, const Grid& grid) {
    const Palette& colors = palette(state.edited.theme);
    GalleryPage& page = state.pages.gallery;
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const ImVec2 hi(lo.x + grid.card_width, lo.y + grid.card_height);
    ImGui::PushID(static_cast<int>(item));
    const bool clicked =
        ImGui::InvisibleButton("##card", ImVec2(grid.card_width, grid.card_height));
    ImGui::PopID();
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemHovered() && (moved.x != 0.0F || moved.y != 0.0F)) page.selected = item;
    const bool selected = page.selected == item;
    if (selected && page.follow) {
        ImGui::ScrollToRect(ImGui::GetCurrentWindow(), ImRect(lo, hi),
                            ImGuiScrollFlags_KeepVisibleEdgeY);
        page.follow = false;
    }
    if (!ImGui::IsItemVisible()) return clicked;
    state.wishes.thumbnails.items.push_back(item);
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.AddRectFilled(lo, hi, selected ? colors.row_active : colors.row_field);
    const auto& thumbnails = state.shown.thumbnails;
    const auto picture = thumbnails.find(item);
    draw_thumbnail(picture == thumbnails.end() ? 0 : picture->second, lo,
                   ImVec2(hi.x, lo.y + grid.picture_height), colors);
    draw_texts(state.shown.gallery[item], lo, grid, colors);
    const GalleryEntry& entry = state.shown.gallery[item];
    if (!has_details()) draw_tooltip(shown_text(entry, entry.about));
    if (selected) canvas.AddRect(lo, hi, colors.accent, 0.0F, 0, em(0.14F));
    return clicked;
}

void draw_group_title(const GalleryEntry& entry, bool first, const Palette& colors) {
    if (!first) ImGui::Dummy(ImVec2(0.0F, em(0.4F)));
    ImGui::PushStyleColor(ImGuiCol_Text, colors.accent);
    ImGui::TextUnformatted(shown_text(entry, entry.group));
    ImGui::PopStyleColor();
}

/// Draws all cards; returns the clicked item, if any.
std::optional<std::size_t> draw_cards(UiState& state, const std::vector<Card>& cards,
                                      const Grid& grid) {
    const Palette& colors = palette(state.edited.theme);
    std::optional<std::size_t> clicked;
    std::string group;
    for (const Card& card : cards) {
        const GalleryEntry& entry = state.shown.gallery[card.item];
        const bool begins = card.item == cards.front().item || entry.group != group;
        if (begins) draw_group_title(entry, card.item == cards.front().item, colors);
        group = entry.group;
        if (card.col > 0) ImGui::SameLine(0.0F, em(gap_em));
        if (draw_card(state, card.item, grid)) clicked = card.item;
    }
    return clicked;
}

/// Draws equation, description and source of the selected surface.
void draw_details(const GalleryEntry& entry, const Palette& colors) {
    ImGui::Separator();
    ImGui::PushFont(font(FontRole::SmallFormula));
    draw_elided(in_one_line(entry.equation), ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(shown_text(entry, entry.about));
    ImGui::PopTextWrapPos();
    ImGui::PushFont(font(FontRole::Small));
    ImGui::PushStyleColor(ImGuiCol_Text, colors.quiet);
    const bool cut = draw_elided(entry.source, ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (cut) draw_tooltip(entry.source);
}

void draw_page(UiState& state) {
    GalleryPage& page = state.pages.gallery;
    const Palette& colors = palette(state.edited.theme);
    draw_head(page, colors);
    const bool details = has_details();
    const float height = ImGui::GetContentRegionAvail().y - (details ? em(details_em) : 0.0F);
    const float bar = ImGui::GetStyle().ScrollbarSize + em(0.3F);
    const Grid grid = grid_of(ImGui::GetContentRegionAvail().x - bar);
    const std::vector<Card> cards = cards_of(state.shown.gallery, page.search, grid.columns);
    std::optional<std::size_t> picked;
    ImGui::BeginChild("##cards", ImVec2(0.0F, height), false, ImGuiWindowFlags_NoNav);
    state.wishes.thumbnails.items.clear();
    if (cards.empty()) {
        ImGui::TextDisabled("%s", tr("nothing found"));
    } else {
        follow_arrows(page, cards);
        picked = draw_cards(state, cards, grid);
        draw_scroll_fade(ImGui::GetColorU32(ImGuiCol_PopupBg) | IM_COL32_A_MASK);
    }
    ImGui::EndChild();
    if (details && !cards.empty()) draw_details(state.shown.gallery[page.selected], colors);
    const bool enter = is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter);
    if (enter && !cards.empty()) picked = page.selected;
    if (picked) state.wishes.gallery_item = picked;
    if (picked || is_pressed_once(ImGuiKey_Escape)) page.open = false;
}

}  // namespace

void draw_gallery_page(UiState& state) {
    GalleryPage& page = state.pages.gallery;
    if (state.shown.gallery.empty() || !follow_popup(page, gallery_popup)) {
        state.wishes.thumbnails.items.clear();
        return;
    }
    const float scale = em(1.0F) / 14.0F * ImGui::GetIO().DisplayFramebufferScale.x;
    state.wishes.thumbnails.size_px = glm::ivec2(glm::round(scale * picture_size));
    if (page.frames == 1) page.follow = true;
    place_gallery(state.edited.layout);
    draw_popup(page, gallery_popup, [&] { draw_page(state); });
}

}  // namespace zeroset::ui
