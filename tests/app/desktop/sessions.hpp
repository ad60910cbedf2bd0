#pragma once

// Fixture of a session without a window: what the panels wish, frame by frame.

#include "app/desktop/session.hpp"
#include "document/document.hpp"
#include "engine/export/file.hpp"
#include "tests/support/test_folder.hpp"
#include "ui/model/ui_state.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string>

namespace zeroset::test {

class Sessions : public testing::Test {
protected:
    void SetUp() override {
        setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
        state_.edited.document = with_text("x = 1");
    }

    static Document with_text(const std::string& text) {
        Document document = empty_document();
        document.statements[0].text = text;
        return document;
    }
    void start(const SessionOptions& options = {}) {
        session_ = std::make_unique<Session>(state_, options);
    }
    /// Follows one more frame, `after_s` seconds after the last.
    void frame(double after_s = 0.1) { session_->follow(now_s_ += after_s); }
    void give(ui::Command command) {
        state_.wishes.command = command;
        frame();
    }
    void answer(std::size_t choice) {
        ASSERT_TRUE(state_.pages.dialogs.question);
        state_.pages.dialogs.question->chosen = choice;
        frame();
    }
    void choose(const std::filesystem::path& path) {
        ASSERT_TRUE(state_.pages.dialogs.file);
        state_.pages.dialogs.file->path = path.string();
        state_.pages.dialogs.file->finished = true;
        frame();
    }
    void type(const std::string& text, double after_s = 2.0) {
        state_.edited.document.statements[0].text += text;
        frame(after_s);
    }
    [[nodiscard]] const std::string& text() const {
        return state_.edited.document.statements[0].text;
    }
    [[nodiscard]] std::filesystem::path file(const std::string& name) const {
        return folder_ / name;
    }
    static std::string content(const std::filesystem::path& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const std::filesystem::path& path, const std::string& text) {
        ASSERT_TRUE(write_file(path, std::as_bytes(std::span(text))));
    }

    TestFolder folder_;
    ui::UiState state_;
    std::unique_ptr<Session> session_;
    double now_s_ = 0.0;
};

}  // namespace zeroset::test
