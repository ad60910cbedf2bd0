#pragma once

#include "app/desktop/autosave.hpp"
#include "app/desktop/export_target.hpp"
#include "app/desktop/recent_files.hpp"
#include "app/desktop/volume_permission.hpp"
#include "document/document.hpp"
#include "document/history.hpp"
#include "document/json/collection.hpp"
#include "pipeline/file_access.hpp"
#include "ui/model/ui_state.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

struct SessionOptions {
    std::string path;         ///< of the document's file; empty: it has none
    std::string note;         ///< the first message about the document, or empty
    bool keeps_files = true;  ///< keeps a list of recent files, and the document against a crash
    bool read_only = false;   ///< the document is not to be saved, nor another one opened
    /// By which its documents read files.
    std::shared_ptr<FileAccess> files = std::make_shared<FileAccess>();
    /// Shows the documents of a folder, or of a file with several, to choose from. Without it the
    /// first one of a file is opened, and no folder.
    std::function<void(Collection)> browse = {};
};

/// The document of a window over time: undo, its file, questions before work is lost. Fulfils the
/// wishes that the panels leave in the state. The window's thread only.
class Session {
public:
    static constexpr double autosave_s = 3.0;

    /// `state` holds the document and must outlive the session.
    Session(ui::UiState& state, const SessionOptions& options);

    /// To be called after each frame of the panels. `now_s`: any clock that does not go back.
    void follow(double now_s);
    /// Changes the document without a step of undo, for changes that no person made.
    void amend(const std::function<void(Document&)>& change);
    /// Accepts the changes of playing sliders as part of the document, without a step of undo.
    void played();
    /// Replaces the document as a step that can be undone; the new document has no file, but may
    /// name files (Document::files).
    void show(Document document);
    /// Opens the first of the files or folders that were dropped on the window.
    void open(const std::vector<std::string>& paths);
    /// Shows a message that must be read, unless a question is open.
    void tell(const std::string& text);
    /// Closes the window; asks first if that would lose work.
    void close() { attempt({.intent = Intent::Quit, .path = {}}); }
    [[nodiscard]] bool closed() const { return closed_; }
    /// Ends as after a crash: the document is left to be restored.
    void abandon();

    /// Seconds until follow() must be called even if no event comes; nothing: not at all.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;
    /// "* name", or without the star if all is saved.
    [[nodiscard]] std::string title() const;

private:
    /// Action to take once no work would be lost by it.
    enum class Intent { New, ChooseFile, ChooseFolder, OpenPath, Quit };
    struct Action {
        Intent intent;
        std::string path;
    };
    /// The subject of the question on the screen.
    enum class Subject { Nothing, LoseWork, Restore, Volumes, Message };

    void follow_command();
    void follow_question();
    void follow_file_choice();
    void keep(double now_s);
    void attempt(Action action);
    void perform(const Action& action);
    /// Takes the place of the document, without a step back; `path`: of its file, or empty.
    void begin(Document document, const std::string& path);
    /// Begins an empty document, whose texts may name any file.
    void begin_new();
    void load(const std::string& path);
    /// Shows the documents of a folder, or of a file with several, to choose from, or says why
    /// there are none; false where the path is something else.
    bool browse(const std::string& path);
    /// Begins a document that shows the volume.
    void load_volume(const std::string& path);
    /// Opens the dialog in which a file or a folder is chosen.
    void choose_file_to_open(ui::FileChoice::Purpose purpose);
    void save();
    /// Opens the dialog that asks for the name of a new file.
    void choose_file_for(ui::FileChoice choice, const std::string& usual_name);
    void save_as();
    /// Asks for the name of the file that the export page wishes.
    void choose_export();
    [[nodiscard]] std::string export_folder() const;
    void write(const std::string& path);
    void undo(bool back);
    /// Copies the selected marker's coordinates, or else the document.
    void copy() const;
    void paste();
    void copy_camera() const;
    /// Looks from where the text of a camera says, or says what is wrong with it.
    void paste_camera(const std::string& text);
    void ask(Subject what, std::string text, std::vector<std::string> answers);
    void say(const std::string& text) { ask(Subject::Message, text, {"OK"}); }
    /// Says what the window failed to do: "cannot open 'a.json': it is too large", for example.
    void say_failure(const std::string& predicate);
    /// Asks about volumes outside of the document's folder.
    void ask_for_volumes();
    void answer_restore(std::size_t answer);
    void answer_lose_work(std::size_t answer);
    void refresh();
    /// The document that is open.
    [[nodiscard]] Document& current() const { return state_.edited.document; }
    [[nodiscard]] bool unsaved() const { return !read_only_ && !same_work(saved_, current()); }

    ui::UiState& state_;
    std::shared_ptr<FileAccess> files_;
    bool read_only_;
    std::function<void(Collection)> browse_;
    History history_;
    Document saved_;    ///< the document as in its file, or as it began
    std::string path_;  ///< of the document's file; empty: none
    RecentFiles recent_;
    Autosave autosave_;
    std::optional<LostSession> lost_;
    std::optional<Action> waiting_;  ///< the action that waits for the answer about the work
    Subject asked_ = Subject::Nothing;
    Document kept_;  ///< the document as autosave kept it, or as `saved_` where nothing is kept
    double kept_s_ = 0.0;
    bool closed_ = false;
    std::string export_folder_;  ///< chosen last for what is saved; empty: none yet
    ExportTarget export_target_;
    VolumePermission volumes_;
};

}  // namespace zeroset
