// Tests of document files, and of questions before work is lost.

#include "document/json/document_file.hpp"
#include "document/json/document_json.hpp"
#include "pipeline/file_access.hpp"
#include "tests/app/desktop/sessions.hpp"
#include "ui/style/theme.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace zeroset::test::session_test {
namespace {

namespace fs = std::filesystem;

TEST_F(Sessions, ProposeAFileForWhatIsSavedThatIsNotThereYet) {
    const fs::path path = folder_ / "cone.zeroset.json";
    SessionOptions options;
    options.path = path.string();
    start(options);
    ui::ExportPage& page = state_.pages.exports;
    page.endings = {".png", ".mp4", ".stl", ".svg"};
    frame();
    EXPECT_EQ(state_.shown.export_target, "") << "the page is closed";
    page.open = true;
    frame();
    EXPECT_EQ(state_.shown.export_target, (folder_ / "cone.png").string());
    state_.shown.export_progress.name = "cone.png";
    frame();
    std::ofstream(folder_ / "cone.png") << "a picture";
    state_.shown.export_progress.name.clear();
    frame();
    EXPECT_EQ(state_.shown.export_target, (folder_ / "cone-2.png").string());
    page.wish.kind = ExportKind::Film;
    frame();
    EXPECT_EQ(state_.shown.export_target, (folder_ / "cone.mp4").string());
    page.endings[1] = "####.png";
    frame();
    EXPECT_EQ(state_.shown.export_target, "") << "many files: the name is asked for";
}

TEST_F(Sessions, ProposeTheFolderThatWasChosenLast) {
    start();
    ui::ExportPage& page = state_.pages.exports;
    page.endings = {".png", ".mp4", ".stl", ".svg"};
    page.open = true;
    fs::create_directory(folder_ / "pictures");
    give(ui::Command::Export);
    choose(folder_ / "pictures" / "mine.png");
    EXPECT_EQ(state_.wishes.export_path, (folder_ / "pictures" / "mine.png").string());
    frame();
    EXPECT_EQ(state_.shown.export_target, (folder_ / "pictures" / "picture.png").string());
}

TEST_F(Sessions, ShowAVolumeThatIsDropped) {
    start();
    write(file("a.nrrd"), "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n" +
                              std::string("\0\1\2\3\4\5\6\7", 8));
    session_->open({file("a.nrrd").string()});
    frame();
    ASSERT_EQ(state_.edited.document.statements.size(), 2);
    EXPECT_EQ(text(), "scan = volume(\"" + file("a.nrrd").string() + "\")");
    EXPECT_EQ(state_.edited.document.statements[1].text, "scan(x, y, z) = a");
    EXPECT_EQ(slider_of(state_.edited.document, "a").hi, 7);
    EXPECT_EQ(state_.edited.document.clip.hi, glm::dvec3(1));
    write(file("b.nrrd"), "NRRD0004\ntype: uchar\n\n");
    session_->open({file("b.nrrd").string()});
    frame();
    EXPECT_EQ(text(), "scan = volume(\"" + file("a.nrrd").string() + "\")") << "it stays";
}

TEST_F(Sessions, UndoAndRedo) {
    start();
    type("+y");
    EXPECT_TRUE(state_.shown.document.can_undo);
    give(ui::Command::Undo);
    EXPECT_EQ(text(), "x = 1");
    EXPECT_FALSE(state_.shown.document.can_undo);
    EXPECT_FALSE(state_.shown.document.unsaved);
    give(ui::Command::Redo);
    EXPECT_EQ(text(), "x = 1+y");
    EXPECT_TRUE(state_.shown.document.unsaved);
}

TEST_F(Sessions, ReloadTheFieldUnderEditAfterUndo) {
    start();
    type("+y");
    state_.input.typing_row = 1;
    give(ui::Command::Undo);
    EXPECT_EQ(state_.wishes.reload, 1);
}

TEST_F(Sessions, SaveUnderANameAndAgain) {
    start();
    EXPECT_EQ(session_->title(), "x = 1");
    type("+y");
    EXPECT_EQ(session_->title(), "* x = 1+y");
    give(ui::Command::Save);
    choose(file("a.zeroset.json"));
    EXPECT_EQ(session_->title(), "a");
    EXPECT_EQ(document_from(content(file("a.zeroset.json")))->document, state_.edited.document);
    type("+z");
    EXPECT_EQ(session_->title(), "* a");
    give(ui::Command::Save);
    EXPECT_FALSE(state_.pages.dialogs.file) << "it has a name";
    EXPECT_EQ(document_from(content(file("a.zeroset.json")))->document, state_.edited.document);
    EXPECT_EQ(state_.shown.document.recent, (std::vector{file("a.zeroset.json").string()}));
}

TEST_F(Sessions, SayWhyAFileCannotBeWritten) {
    start();
    give(ui::Command::SaveAs);
    choose(file("missing") / "a.zeroset.json");
    ASSERT_TRUE(state_.pages.dialogs.question);
    EXPECT_NE(state_.pages.dialogs.question->text.find("does not exist"), std::string::npos);
    answer(0);
    EXPECT_EQ(session_->title(), "x = 1");
}

TEST_F(Sessions, AskBeforeWorkIsLost) {
    start();
    give(ui::Command::New);
    EXPECT_EQ(text(), "") << "nothing was changed, nothing is asked";
    type("y = 2");
    give(ui::Command::New);
    EXPECT_EQ(text(), "y = 2");
    answer(2);  // cancel
    EXPECT_EQ(text(), "y = 2");
    give(ui::Command::New);
    answer(1);  // don't save
    EXPECT_EQ(text(), "");
    EXPECT_FALSE(state_.shown.document.can_undo);
}

TEST_F(Sessions, BeginNewDocumentsWithTheAxesThatWereOnLast) {
    start();
    give(ui::Command::New);
    EXPECT_TRUE(state_.edited.document.axes && state_.edited.document.grid);
    state_.edited.layout.grid = false;
    give(ui::Command::New);
    EXPECT_TRUE(state_.edited.document.axes && !state_.edited.document.grid);
    EXPECT_EQ(session_->title(), "Untitled") << "nothing was changed by that";
}

TEST_F(Sessions, AskNothingWhereNothingIsToBeSaved) {
    write(file("other.zeroset.json"), text_of(with_text("other = 1")));
    start({.path = {}, .note = {}, .read_only = true});
    type("+y", Session::autosave_s + 1.0);
    EXPECT_EQ(session_->title().find('*'), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "state"));
    session_->open({file("other.zeroset.json").string()});
    EXPECT_EQ(text(), "x = 1+y") << "files that are dropped are left alone";
    session_->close();
    EXPECT_TRUE(session_->closed());
}

TEST_F(Sessions, SaveFirstWhenThatIsTheAnswer) {
    start();
    type("+y");
    give(ui::Command::Quit);
    answer(0);
    choose({});  // cancels the file choice
    EXPECT_FALSE(session_->closed());
    give(ui::Command::Quit);
    answer(0);
    choose(file("b.zeroset.json"));
    EXPECT_TRUE(session_->closed());
    EXPECT_EQ(document_from(content(file("b.zeroset.json")))->document.statements[0].text,
              "x = 1+y");
}

TEST_F(Sessions, DoNotAskForTheCameraAlone) {
    start();
    state_.edited.document.camera = default_camera(state_.edited.document.clip);
    frame();
    EXPECT_TRUE(state_.shown.document.can_undo);
    give(ui::Command::Quit);
    EXPECT_TRUE(session_->closed());
}

TEST_F(Sessions, AskForSavedViews) {
    start();
    add_view(state_.edited.document.views, Camera{{0, -3, 0}, {0, 0, 0}, {0, 0, 1}, 1.0});
    frame();
    EXPECT_TRUE(state_.shown.document.unsaved);
    give(ui::Command::Undo);
    EXPECT_TRUE(state_.edited.document.views.empty());
}

TEST_F(Sessions, OpenAFile) {
    Document document = with_text("y = 3");
    document.w.value = 0.5;
    ASSERT_TRUE(save_document(file("c.zeroset.json"), document));
    start();
    session_->open({file("c.zeroset.json").string()});
    frame();
    EXPECT_EQ(text(), "y = 3");
    EXPECT_EQ(state_.edited.document.w.value, 0.5);
    EXPECT_EQ(session_->title(), "c");
    EXPECT_FALSE(state_.shown.document.can_undo);
}

TEST_F(Sessions, SaveTheBackgroundThatALightWindowShows) {
    for (const auto theme : {ui::Theme::Dark, ui::Theme::Light}) {
        state_.edited.theme = theme;
        start();
        give(ui::Command::SaveAs);
        choose(file("b.zeroset.json"));
        const auto loaded = load_document(file("b.zeroset.json"));
        ASSERT_TRUE(loaded);
        const bool light = theme == ui::Theme::Light;
        EXPECT_EQ(loaded->shown_on,
                  light ? std::optional(ui::picture_background(theme)) : std::nullopt);
        EXPECT_FALSE(loaded->document.light.background) << "the window has its own";
    }
}

TEST_F(Sessions, LeaveADamagedFileAndTheDocumentAlone) {
    for (const char* damage : {"{\"zeroset\": 1, \"statements\": 7}", "nonsense",
                               "{\"zeroset\": 99, \"statements\": []}"}) {
        write(file("d.zeroset.json"), damage);
        start();
        session_->open({file("d.zeroset.json").string()});
        frame();
        ASSERT_TRUE(state_.pages.dialogs.question) << damage;
        EXPECT_TRUE(state_.pages.dialogs.question->text.starts_with("I cannot open '"));
        EXPECT_EQ(text(), "x = 1");
        EXPECT_EQ(content(file("d.zeroset.json")), damage);
        answer(0);
    }
}

TEST_F(Sessions, NameWhatInAFileIsNotUnderstood) {
    write(file("e.zeroset.json"), R"({"zeroset": 1, "fog": 2, "statements": [{"text": "y"}]})");
    start();
    session_->open({file("e.zeroset.json").string()});
    frame();
    EXPECT_EQ(text(), "y");
    ASSERT_TRUE(state_.pages.dialogs.question);
    EXPECT_NE(state_.pages.dialogs.question->text.find("fog"), std::string::npos);
}

TEST_F(Sessions, ShowWhatWasPickedAsAStepWithoutAFile) {
    start({file("f.zeroset.json").string(), "", true});
    session_->show(with_text("z = 1"));
    frame();
    EXPECT_EQ(text(), "z = 1");
    EXPECT_FALSE(state_.shown.document.unsaved);
    give(ui::Command::Undo);
    EXPECT_EQ(text(), "x = 1");
    give(ui::Command::Save);
    EXPECT_TRUE(state_.pages.dialogs.file) << "the file is not overwritten by what was picked";
}

TEST_F(Sessions, TextsOfOthersMayNameFilesBesideThem) {
    write(file("balls.xyz"), "0 0 0 1\n");
    const std::string balls = "blobs(\"balls.xyz\") = 1";
    write(file("mixed.txt"), "x^2 + y^2 + z^2 = 1\n" + balls + "\n");
    start();
    state_.wishes.open_path = file("mixed.txt").string();
    frame();
    ASSERT_EQ(state_.edited.document.statements.size(), 2U);
    EXPECT_EQ(state_.edited.document.statements[1].text, balls) << "it is no remark";
    EXPECT_TRUE(read_program(balls, state_.edited.document.files.get()));
}

TEST_F(Sessions, UndoGoesBackToWhatTheDocumentMayRead) {
    write(file("balls.xyz"), "0 0 0 1\n");
    write(file("a.zeroset.json"), text_of(with_text("blobs(\"balls.xyz\") = 1")));
    start();
    state_.wishes.open_path = file("a.zeroset.json").string();
    frame();
    const auto files = state_.edited.document.files;
    ASSERT_NE(files, nullptr);
    session_->show(with_text("x = 1"));
    frame();
    EXPECT_NE(state_.edited.document.files, files);
    give(ui::Command::Undo);
    EXPECT_EQ(state_.edited.document.files, files);
}

TEST_F(Sessions, AskBeforeVolumesOutsideOfTheFolderAreRead) {
    const std::string text = "s = volume(\"../elsewhere/v.nrrd\"); s(x,y,z) = 1";
    const auto reason = [&] {
        return read_program(text, state_.edited.document.files.get()).error().reason;
    };
    fs::create_directories(file("elsewhere"));
    fs::create_directories(file("document"));
    write(file("elsewhere/v.nrrd"), "no volume");
    write(file("document/d.zeroset.json"), text_of(with_text("x = 1")));
    const SessionOptions options;
    start(options);
    const auto open = [&] {
        state_.wishes.open_path = file("document/d.zeroset.json").string();
        frame();
    };
    open();
    EXPECT_TRUE(reason().contains("lies outside the document's folder")) << reason();
    frame();
    ASSERT_TRUE(state_.pages.dialogs.question);
    EXPECT_TRUE(state_.pages.dialogs.question->text.contains(file("elsewhere/v.nrrd").string()));
    answer(1);
    EXPECT_TRUE(reason().contains("lies outside the document's folder")) << reason();
    frame();
    EXPECT_FALSE(state_.pages.dialogs.question) << "it was asked already";

    open();
    (void)reason();
    frame();
    const std::uint64_t before = options.files->version();
    answer(0);
    EXPECT_EQ(options.files->version(), before + 1) << "rows are read again";
    EXPECT_FALSE(reason().contains("lies outside")) << reason();
}

TEST_F(Sessions, AFolderIsLookedThroughAndLosesNothing) {
    std::optional<Collection> browsed;
    SessionOptions options;
    options.browse = [&browsed](Collection collection) { browsed = std::move(collection); };
    start(options);
    ASSERT_TRUE(save_document(file("a.zeroset.json"), with_text("y = 7")));
    type("2");
    session_->open({folder_.path().string()});
    EXPECT_FALSE(state_.pages.dialogs.question) << "nothing would be lost";
    ASSERT_TRUE(browsed);
    EXPECT_EQ(browsed->items.at(0).path, file("a.zeroset.json"));
    EXPECT_EQ(text(), "x = 12");
    give(ui::Command::OpenFolder);
    browsed.reset();
    choose(folder_.path() / "nowhere");
    EXPECT_FALSE(browsed);
    ASSERT_TRUE(state_.pages.dialogs.question);
    EXPECT_TRUE(state_.pages.dialogs.question->text.contains("nowhere"));
}

}  // namespace
}  // namespace zeroset::test::session_test
