// Tests of what is kept of a session against a crash, and offered after it.

#include "tests/app/desktop/sessions.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace zeroset::test::session_recovery_test {
namespace {

namespace fs = std::filesystem;

TEST_F(Sessions, KeepTheDocumentAgainstACrash) {
    // A child process that ends without cleaning up, as if it were killed.
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        start();
        type(" + lost", Session::autosave_s + 1);
        ::_exit(0);
    }
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    start();
    ASSERT_TRUE(state_.pages.dialogs.question);
    EXPECT_NE(state_.pages.dialogs.question->text.find("x = 1 + lost"), std::string::npos);
    answer(0);
    EXPECT_EQ(text(), "x = 1 + lost");
    EXPECT_TRUE(state_.shown.document.unsaved);
    session_.reset();
    start();
    EXPECT_FALSE(state_.pages.dialogs.question) << "it is offered once";
}

TEST_F(Sessions, LeaveTheDocumentWhereTheWindowCannotGoOn) {
    start();
    type("+y", 0.1);
    session_->abandon();
    type("+z", 10.0);
    session_.reset();
    state_.edited.document = with_text("x = 2");
    start();
    answer(0);
    EXPECT_EQ(text(), "x = 1+y");
}

TEST_F(Sessions, DoNotOfferWhatAnotherWindowHas) {
    start();
    type(" + open", Session::autosave_s + 1);
    ui::UiState other;
    const Session second(other, {});
    EXPECT_FALSE(other.pages.dialogs.question);
}

TEST_F(Sessions, KeepWhatIsAsItBeganButNotAsItWasSaved) {
    start();
    type(" + y", 0.1);
    give(ui::Command::Save);
    choose(file("a.zeroset.json"));
    give(ui::Command::Undo);
    EXPECT_EQ(text(), "x = 1");
    ASSERT_TRUE(session_->due_s(now_s_));
    frame(Session::autosave_s + 1);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "state/zeroset/autosave"), {}), 2);
}

TEST_F(Sessions, LeaveNothingWhenTheyAreClosed) {
    start();
    type(" + y", Session::autosave_s + 1);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "state/zeroset/autosave"), {}), 2);
    session_.reset();
    EXPECT_TRUE(fs::is_empty(folder_ / "state/zeroset/autosave"));
}

TEST_F(Sessions, SayWhenTheyWantToSave) {
    start();
    EXPECT_FALSE(session_->due_s(now_s_));
    type("+y");
    const auto due = session_->due_s(now_s_);
    ASSERT_TRUE(due);
    EXPECT_NEAR(*due, Session::autosave_s - now_s_, 1e-9);
    frame(*due);
    EXPECT_FALSE(session_->due_s(now_s_));
}

TEST_F(Sessions, TouchNoFilesWhenTheyShallNot) {
    start({"", "", false});
    type("+y", Session::autosave_s + 1);
    EXPECT_FALSE(fs::exists(folder_ / "state"));
}

}  // namespace
}  // namespace zeroset::test::session_recovery_test
