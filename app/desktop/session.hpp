#pragma once

#include "app/desktop/autosave.hpp"
#include "app/desktop/recent_files.hpp"
#include "document/document.hpp"
#include "document/history.hpp"
#include "ui/model/ui_state.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

struct SessionOptions {
    std::string path;         ///< the document's file; empty: it has none
    std::string note;         ///< what is to be said of it at first; or empty
    bool keeps_files = true;  ///< a list of recent files, and the document against a crash
};

/// The document of a window over time: undo, its file, the questions before work is lost. Acts on
/// the wishes that the panels leave in the state. The window's thread only.
class Session {
public:
    static constexpr double autosave_s = 3.0;

    /// `state` has the document, and outlives the session.
    Session(ui::UiState& state, const SessionOptions& options);

    /// After each frame of the panels. `now_s`: any clock that does not go back.
    void follow(double now_s);
    /// Changes the document by what no person did: no step of undo.
    void amend(const std::function<void(Document&)>& change);
    /// Sliders have played: no step of undo, but the document is another.
    void played();
    /// In place of the document, as a step that can be undone; it has no file.
    void show(Document document);
    /// Files dropped on the window.
    void open(const std::vector<std::string>& paths);
    /// The window is to close; asks if that would lose work.
    void close() { attempt({Intent::Quit, {}}); }
    [[nodiscard]] bool closed() const { return closed_; }
    /// Ends as after a crash: the document is left to be restored.
    void abandon();

    /// Seconds until it wants to be called though nothing happens.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;
    /// "* name", or without the star when all is saved.
    [[nodiscard]] std::string title() const;

private:
    /// What is to be done once it costs no work.
    enum class Intent { New, ChooseFile, OpenPath, Quit };
    struct Action {
        Intent intent;
        std::string path;
    };
    /// What the question on the screen is about.
    enum class Asked { Nothing, LoseWork, Restore, Message };

    void follow_command();
    void follow_question();
    void follow_file_choice();
    void keep(double now_s);
    void attempt(Action action);
    void perform(const Action& action);
    void begin(Document document, const std::string& path);
    void load(const std::string& path);
    void save();
    void save_as();
    void write(const std::string& path);
    void undo(bool back);
    /// The selected marker's coordinates, or the document.
    void copy();
    void paste();
    void ask(Asked what, std::string text, std::vector<std::string> answers);
    void say(const std::string& text) { ask(Asked::Message, text, {"OK"}); }
    void answer_restore(std::size_t answer);
    void answer_lose_work(std::size_t answer);
    void refresh();
    [[nodiscard]] bool unsaved() const { return !same_work(saved_, state_.document); }

    ui::UiState& state_;
    History history_;
    Document saved_;    ///< as in the file, or as it began
    std::string path_;  ///< of the file; empty: none
    RecentFiles recent_;
    Autosave autosave_;
    std::optional<LostSession> lost_;
    std::optional<Action> waiting_;  ///< for the answer about the work
    Asked asked_ = Asked::Nothing;
    Document kept_;  ///< by autosave, or as saved where it keeps nothing
    double kept_s_ = 0.0;
    bool closed_ = false;
};

}  // namespace zeroset
