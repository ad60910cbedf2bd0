#include "ui/widgets/card_grid.hpp"

#include "engine/base/translation.hpp"
#include "ui/model/text_match.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>

namespace zeroset::ui {

namespace {

/// A group's name, and whether it is the gallery's own.
struct Group {
    bool own;
    std::string name;

    bool operator==(const Group&) const = default;
};

Group group_of(const GalleryEntry& entry) {
    return {.own = entry.path.empty(), .name = entry.group};
}

/// Returns the groups in the order in which they first occur, the gallery's own last.
std::vector<Group> groups_of(const std::vector<GalleryEntry>& gallery) {
    std::vector<Group> groups;
    for (const GalleryEntry& entry : gallery) {
        Group group = group_of(entry);
        if (std::ranges::find(groups, group) == groups.end()) groups.push_back(std::move(group));
    }
    std::ranges::stable_partition(groups, [](const Group& group) { return !group.own; });
    return groups;
}

/// How well a search finds the entry, a greater number is better: as its title, or as any text.
/// Nothing: it does not.
std::optional<int> rank_of(const GalleryEntry& entry, const std::string& search) {
    const auto both = [](const std::string& text) {
        const std::string shown = tr(text.c_str());
        return shown == text ? text : shown + "\n" + text;
    };
    const std::string title = both(entry.title);
    if (!contains_words(title + "\n" + both(entry.group) + "\n" + entry.equation + "\n" +
                            both(entry.about) + "\n" + entry.source,
                        search))
        return std::nullopt;
    const auto named = match_of(title, search);
    return named ? static_cast<int>(named->closeness) : 0;
}

/// An entry that a search has found.
struct Ranked {
    std::size_t item;
    int rank;
};

}  // namespace

std::vector<Card> cards_of(const std::vector<GalleryEntry>& gallery, const std::string& search,
                           int columns) {
    std::vector<std::vector<Ranked>> groups;
    for (const Group& group : groups_of(gallery)) {
        std::vector<Ranked> found;
        for (std::size_t i = 0; i < gallery.size(); ++i) {
            if (group_of(gallery[i]) != group) continue;
            if (const auto rank = rank_of(gallery[i], search))
                found.push_back({.item = i, .rank = *rank});
        }
        std::ranges::stable_sort(found, std::ranges::greater{}, &Ranked::rank);
        if (!found.empty()) groups.push_back(std::move(found));
    }
    std::ranges::stable_sort(groups, std::ranges::greater{},
                             [](const auto& group) { return group.front().rank; });
    std::vector<Card> cards;
    int row = 0;
    for (const auto& group : groups) {
        int col = 0;
        for (const Ranked& found : group) {
            if (col == columns) {
                ++row;
                col = 0;
            }
            cards.push_back({.item = found.item, .row = row, .col = col++});
        }
        ++row;
    }
    return cards;
}

std::size_t stepped(const std::vector<Card>& cards, std::size_t selected, int rows, int cols) {
    const auto from = std::ranges::find(cards, selected, &Card::item);
    if (from == cards.end()) return cards.front().item;
    const auto last = static_cast<std::ptrdiff_t>(cards.size()) - 1;
    const std::ptrdiff_t along = std::clamp<std::ptrdiff_t>(from - cards.begin() + cols, 0, last);
    const Card& start = cards[static_cast<std::size_t>(along)];
    const int row = std::clamp(start.row + rows, 0, cards.back().row);
    const auto distance = [&](const Card& card) {
        return card.row == row ? std::abs(card.col - start.col) : 1 << 20;
    };
    return std::ranges::min_element(cards, {}, distance)->item;
}

void draw_thumbnail(unsigned int name, const ImVec2& lo, const ImVec2& hi, const Palette& colors) {
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    canvas.AddRectFilledMultiColor(lo, hi, colors.sky, colors.sky, colors.ground, colors.ground);
    if (name == 0) {
        const ImVec2 size = ImGui::CalcTextSize("...");
        canvas.AddText(ImVec2(0.5F * (lo.x + hi.x - size.x), 0.5F * (lo.y + hi.y - size.y)),
                       colors.quiet, "...");
        return;
    }
    const auto id = static_cast<std::uintptr_t>(name);
    // ImGui's texture handle is a pointer that the OpenGL renderer uses as a number.
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui keeps OpenGL's number as a pointer
    canvas.AddImage(reinterpret_cast<ImTextureID>(id), lo, hi);
}

}  // namespace zeroset::ui
