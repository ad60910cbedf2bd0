// Tests of the gallery page: shown cards, search and opening.

#include "engine/image/rgba_image.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/widgets/card_grid.hpp"
#include "ui/window/offscreen_window.hpp"
#include "ui/window/texture.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui::gallery_page_test {
namespace {

std::vector<GalleryEntry> three_groups() {
    return {{"Torus", "x = 1", "A ring.", "Algebraic", "Anna, 1901"},
            {"Gyroid", "sin(x) = 0", "A labyrinth.", "Periodic", "Berta, 1902"},
            {"Cube", "max(x, y) = 1", "A die.", "Solids", "Clara, 1903"},
            {"Heart", "x = 2", "Red.", "Algebraic", "Dora, 1904"},
            {"Chair", "x = 3", "A seat.", "Algebraic", "Emma, 1905"}};
}

std::vector<std::size_t> items_of(const std::vector<Card>& cards) {
    std::vector<std::size_t> items;
    for (const Card& card : cards)
        items.push_back(card.item);
    return items;
}

TEST(CardGrid, BeginsARowWithEachGroup) {
    const auto cards = cards_of(three_groups(), "", 2);
    EXPECT_EQ(items_of(cards), (std::vector<std::size_t>{0, 3, 4, 1, 2}));
    const std::vector<std::pair<int, int>> places{{0, 0}, {0, 1}, {1, 0}, {2, 0}, {3, 0}};
    for (std::size_t i = 0; i < cards.size(); ++i)
        EXPECT_EQ(std::pair(cards[i].row, cards[i].col), places[i]) << i;
}

TEST(CardGrid, BeginsWithWhatIsNotTheGallerys) {
    auto entries = three_groups();
    entries.push_back({.title = "a",
                       .equation = "x",
                       .about = "",
                       .group = "Algebraic",
                       .source = "",
                       .path = "a.js#1"});
    entries.push_back({.title = "b",
                       .equation = "y",
                       .about = "",
                       .group = "Algebraic",
                       .source = "",
                       .path = "a.js#2"});
    const auto cards = cards_of(entries, "", 2);
    EXPECT_EQ(items_of(cards), (std::vector<std::size_t>{5, 6, 0, 3, 4, 1, 2}));
    EXPECT_EQ(cards[2].row, 1);
}

TEST(CardGrid, FindsWordsInAllTexts) {
    const auto found = [](const char* search) {
        return items_of(cards_of(three_groups(), search, 3));
    };
    using Items = std::vector<std::size_t>;
    EXPECT_EQ(found("tor"), (Items{0}));
    EXPECT_EQ(found("ALGEBRAIC red"), (Items{3}));
    EXPECT_EQ(found("sin("), (Items{1}));
    EXPECT_EQ(found("clara"), (Items{2}));
    EXPECT_EQ(found("labyrinth"), (Items{1}));
    EXPECT_EQ(found("torus heart"), Items());
}

TEST(CardGrid, BeginsWithWhatTitlesSay) {
    auto entries = three_groups();
    entries.push_back({"Cube of cubes", "x = 4", "Heart of glass.", "Solids", "Fay, 1906"});
    entries.push_back({"Heartless", "x = 5", "A ring.", "Periodic", "Gerd, 1907"});
    const auto cards = cards_of(entries, "heart", 3);
    EXPECT_EQ(items_of(cards), (std::vector<std::size_t>{3, 6, 5}));
    EXPECT_EQ(cards[2].row, 2);
}

TEST(CardGrid, StepsByRowsAndColumns) {
    const auto cards = cards_of(three_groups(), "", 2);
    EXPECT_EQ(stepped(cards, 0, 0, 1), 3U);
    EXPECT_EQ(stepped(cards, 3, 0, 1), 4U) << "on in the next row";
    EXPECT_EQ(stepped(cards, 3, 1, 0), 4U) << "the nearest of a shorter row";
    EXPECT_EQ(stepped(cards, 0, 2, 0), 1U);
    EXPECT_EQ(stepped(cards, 0, -1, 0), 0U);
    EXPECT_EQ(stepped(cards, 2, 5, 1), 2U);
    EXPECT_EQ(stepped(cards_of(three_groups(), "chair", 2), 0, 1, 0), 4U) << "was not found";
}

class GalleryPages : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.shown.gallery = three_groups();
    }
    static bool is_shown() { return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup); }
    static ImRect everywhere() { return {ImVec2(0.0F, 0.0F), ImGui::GetIO().DisplaySize}; }
    void open() {
        press_with_ctrl(GLFW_KEY_G);
        draw();
    }
};

TEST_P(GalleryPages, OpenAtTheirButtonAndCloseBesideThem) {
    draw();
    click(130, 22);
    OffscreenWindow::point({-1, -1}, false);
    draw();
    ASSERT_TRUE(is_shown());
    EXPECT_TRUE(state_.pages.gallery.open);
    click(2, 2);
    draw_frame();
    EXPECT_FALSE(state_.pages.gallery.open);
    EXPECT_FALSE(is_shown());
    EXPECT_FALSE(state_.wishes.gallery_item);
}

TEST_P(GalleryPages, OpenASurfaceByOneClick) {
    open();
    const ImGuiWindow* cards = child("##Popup");
    ASSERT_NE(cards, nullptr);
    const ImRect place = child(std::string(cards->Name) + "/##cards")->Rect();
    click_at({place.Min.x + static_cast<float>(px(60)), place.Min.y + static_cast<float>(px(80))});
    EXPECT_EQ(state_.wishes.gallery_item, 0U);
    EXPECT_FALSE(state_.pages.gallery.open);
    draw();
    EXPECT_FALSE(is_shown());
}

TEST_P(GalleryPages, AreSearchedByTypingAndOpenedByEnter) {
    open();
    OffscreenWindow::type("periodic");
    draw();
    EXPECT_EQ(state_.wishes.thumbnails.items, std::vector<std::size_t>{1});
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(state_.wishes.gallery_item, 1U);
    EXPECT_FALSE(state_.pages.gallery.open);
}

TEST_P(GalleryPages, KeepTheKeyboardAndSelectTheOldWord) {
    open();
    OffscreenWindow::type("zzz");
    draw();
    press(GLFW_KEY_ENTER);
    draw();
    EXPECT_TRUE(state_.pages.gallery.open);
    OffscreenWindow::type("heart");
    draw();
    EXPECT_EQ(state_.pages.gallery.search, "heart");
    EXPECT_EQ(state_.pages.gallery.selected, 3U) << "the best one";
    press(GLFW_KEY_ESCAPE);
    draw();
    open();
    EXPECT_EQ(state_.pages.gallery.search, "heart");
    OffscreenWindow::type("cube");
    draw();
    EXPECT_EQ(state_.pages.gallery.search, "cube") << "in the place of the old word";
}

TEST_P(GalleryPages, AreWalkedThroughByArrows) {
    open();
    press(GLFW_KEY_RIGHT);
    EXPECT_EQ(state_.pages.gallery.selected, 3U);
    for (int i = 0; i < 6; ++i)
        press(GLFW_KEY_DOWN);
    draw();
    EXPECT_EQ(state_.pages.gallery.selected, 2U);
    EXPECT_EQ(std::ranges::count(state_.wishes.thumbnails.items, 2U), 1) << "scrolled into sight";
    press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(state_.pages.gallery.open);
    EXPECT_FALSE(state_.wishes.gallery_item);
}

TEST_P(GalleryPages, ShowThePicturesOfTheCardsInSight) {
    open();
    EXPECT_EQ(state_.wishes.thumbnails.items.front(), 0U);
    EXPECT_EQ(state_.wishes.thumbnails.size_px, glm::ivec2(px(320), px(240)));
    const int before = count(window_->pixels(), colors().undecided, everywhere());
    Texture texture;
    texture.upload(RgbaImage{2, 2, std::vector<std::uint32_t>(4, colors().undecided)});
    state_.shown.thumbnails[0] = texture.name();
    const int after = count(draw(), colors().undecided, everywhere());
    EXPECT_GT(after - before, px(100) * px(60));
    state_.shown.thumbnails.clear();
    press(GLFW_KEY_ESCAPE);
    EXPECT_TRUE(state_.wishes.thumbnails.items.empty());
}

INSTANTIATE_TEST_SUITE_P(Looks, GalleryPages, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::gallery_page_test
