#pragma once

#include "document/colors.hpp"
#include "engine/image/framebuffer.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The list of statements as tests type into it.

namespace zeroset::ui {

class Statements : public Panels {
protected:
    using Texts = std::vector<std::string>;

    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.view_open = false;
    }
    /// Sets rows with these texts and gives the keyboard to the row with id `row`.
    void begin(const Texts& texts, int row, RowFocus::Caret caret = RowFocus::Caret::End) {
        set_rows(state_, texts);
        state_.wishes.focus = RowFocus{row, caret};
        draw();
        ASSERT_TRUE(is_typing(row));
    }
    void type(const char* text) {
        OffscreenWindow::type(text);
        draw_frame();
    }
    void press_with_alt(int key) {
        OffscreenWindow::hold_alt(true);
        press(key);
        OffscreenWindow::hold_alt(false);
    }
    void press_with_shift(int key) {
        OffscreenWindow::hold_shift(true);
        press(key);
        OffscreenWindow::hold_shift(false);
    }
    [[nodiscard]] Texts texts() const {
        Texts texts;
        for (const Statement& statement : state_.edited.document.statements)
            texts.push_back(statement.text);
        return texts;
    }
    [[nodiscard]] int id_at(std::size_t index) const {
        return state_.edited.document.statements.at(index).id;
    }
    /// Index of the row that has the keyboard; -1: none.
    [[nodiscard]] int typing() const {
        for (std::size_t i = 0; i < state_.edited.document.statements.size(); ++i) {
            if (is_typing(id_at(i))) return static_cast<int>(i);
        }
        return -1;
    }
    /// A place in a row: `x` design units from the list's left end or, if negative, from its right
    /// end.
    [[nodiscard]] glm::vec2 in_row(int row, int x) const {
        const ImRect list = child("##side/##list_")->WorkRect;
        const float across = static_cast<float>(px(x));
        return {x < 0 ? list.Max.x + across : list.Min.x + across,
                field(row).Pos.y + static_cast<float>(px(13))};
    }
    void set_error(int row, const std::string& text, std::size_t at, bool unfinished = false) {
        state_.edited.document.statements[static_cast<std::size_t>(row - 1)].text = text;
        state_.shown.reading.reports[row] = {text, {}, RowError{"wrong", at, unfinished}};
    }
};

}  // namespace zeroset::ui
