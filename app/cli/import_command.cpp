#include "app/cli/commands.hpp"
#include "app/cli/render_files.hpp"
#include "app/cli/render_picture.hpp"
#include "app/cli/report.hpp"
#include "app/platform/process.hpp"
#include "document/import/import.hpp"
#include "document/import/import_choice.hpp"
#include "document/json/document_file.hpp"
#include "engine/base/text.hpp"
#include "pipeline/input/input_source.hpp"
#include "pipeline/prepare.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <system_error>

namespace zeroset {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The result for one document of a file.
struct Brought {
    std::string file, name, session;
    std::string failure;  ///< why nothing is drawn; empty where something is
    bool empty = false;   ///< the picture shows no pixel of a surface
    bool late = false;    ///< its picture took too long, which says nothing about the file
    std::vector<ImportNote> notes;
};

/// A name for a file, from one of a document: letters, digits and few signs.
std::string file_name_of(const std::string& name) {
    std::string result;
    for (const char letter : name) {
        const auto byte = static_cast<unsigned char>(letter);
        const bool keeps = byte >= 0x80 || std::isalnum(byte) != 0 || letter == '-' ||
                           letter == '_' || letter == '+' || letter == '.';
        if (keeps)
            result += letter;
        else if (!result.ends_with('_'))
            result += '_';
    }
    while (result.starts_with('.') || result.starts_with('_'))
        result.erase(0, 1);
    while (result.ends_with('_'))
        result.pop_back();
    return result.empty() ? "surface" : result;
}

/// Writes the documents of all files into a folder.
class Importer {
public:
    Importer(const ImportCommand& command, Size size, double budget_s)
        : command_(command), size_(size), budget_s_(budget_s) {}

    int run() {
        for (const std::string& file : command_.files) {
            if (const int failed = bring(file); failed != exit_ok) return failed;
        }
        if (command_.json) {
            const auto written = write_text(
                *command_.json,
                report_json().dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
            if (!written) return report_run_time(written.error().message);
        }
        if (command_.json != "-") print_summary();
        return refused_ > 0 || nothing_draws() ? exit_wrong_input : exit_ok;
    }

    /// Whether a thread of a picture still runs.
    [[nodiscard]] bool is_stuck() const { return stuck_; }

private:
    /// Whether no surface of any file can be drawn.
    [[nodiscard]] bool nothing_draws() const {
        return std::ranges::none_of(brought_,
                                    [](const Brought& b) { return b.failure.empty() || b.late; });
    }

    int bring(const std::string& file) {
        auto imported = load_import(file, volume_source(volumes_beside(file)));
        if (!imported) {
            ++refused_;
            std::cerr << "error: " << printable(imported.error()) << "\n";
            return exit_ok;
        }
        for (const ImportNote& note : imported->notes)
            say(file, note);
        for (ImportedDocument& document : imported->documents) {
            if (const int failed = keep(file, document); failed != exit_ok) return failed;
        }
        return exit_ok;
    }

    static void say(const std::string& file, const ImportNote& note) {
        std::cerr << printable(note_text(file, note)) << "\n";
    }

    /// A name in the folder that no other document of this run has.
    std::string free_name(const std::string& wanted) {
        std::string name = wanted;
        for (int i = 2; !taken_.insert(name).second; ++i)
            name = wanted + "_" + std::to_string(i);
        return name;
    }

    int keep(const std::string& file, ImportedDocument& imported) {
        Brought brought{.file = file,
                        .name = imported.name,
                        .session = {},
                        .failure = imported.refusal,
                        .notes = imported.notes};
        const fs::path stem = fs::path(command_.folder) / free_name(file_name_of(imported.name));
        for (const ImportNote& note : imported.notes)
            say(file + "#" + imported.name, note);
        if (brought.failure.empty() && !command_.no_pictures) {
            if (const int failed = draw(imported, stem, brought); failed != exit_ok) return failed;
        }
        if (!brought.failure.empty())
            std::cerr << printable(file + "#" + imported.name +
                                   ": nothing is drawn: " + brought.failure)
                      << "\n";
        brought.session = stem.string() + document_ending;
        const auto written = save_document(brought.session, imported.document);
        if (!written) return report_run_time(written.error().message);
        brought_.push_back(std::move(brought));
        return exit_ok;
    }

    /// Draws the document beside its session; fits its view where the file told none.
    int draw(ImportedDocument& imported, const fs::path& stem, Brought& brought) {
        ReadDocument read = read_document(imported.document);
        if (!read.rows) {
            brought.failure = read.rows.error().reason;
            return exit_ok;
        }
        RenderPlan plan;
        plan.document = std::move(read.document);
        plan.rows = std::move(*read.rows);
        plan.settings.stop = plan.document.stop;
        plan.size = size_;
        plan.fits = plan.fits_box = !imported.tells_box;
        plan.budget_s = budget_s_;
        RenderCommand as_typed;
        as_typed.output = stem.string() + ".png";
        const auto options = read_picture_options(as_typed, size_);
        if (!options) return report(options.error());
        plan.picture = *options;
        const RenderOutcome outcome = render_picture(plan, std::chrono::steady_clock::now());
        const RenderedPicture& made = *outcome.picture;
        if (outcome.stuck) {
            // Its thread goes on; the process ends without waiting for it.
            stuck_ = brought.late = true;
            brought.failure = "its picture takes much longer than the budget";
            return exit_ok;
        }
        if (made.error) {
            brought.failure = made.error->reason;
            return exit_ok;
        }
        if (!made.in_time && made.frame.color.empty()) {
            brought.failure = budget_note(made);
            brought.late = true;
            return exit_ok;
        }
        imported.document = made.plan.document;
        return write_picture(outcome.picture, as_typed, brought);
    }

    static int write_picture(const std::shared_ptr<const RenderedPicture>& made,
                             const RenderCommand& as_typed, Brought& brought) {
        RenderFiles files(as_typed);
        const auto added = add_whole(as_typed, made, files);
        if (!added) return report_run_time(added.error());
        const auto written = files.finish();
        if (!written) return report_run_time(written.error().message);
        brought.empty = std::ranges::all_of(
            made->frame.surface, [](std::uint8_t surface) { return surface == no_surface; });
        return exit_ok;
    }

    [[nodiscard]] Json report_json() const {
        Json documents = Json::array();
        for (const Brought& brought : brought_) {
            Json notes = Json::array();
            for (const ImportNote& note : brought.notes)
                notes.push_back(
                    {{"line", note.line}, {"entry", note.entry}, {"reason", note.reason}});
            documents.push_back({{"file", brought.file},
                                 {"name", brought.name},
                                 {"session", brought.session},
                                 {"failure", brought.failure},
                                 {"empty", brought.empty},
                                 {"notes", std::move(notes)}});
        }
        return documents;
    }

    void print_summary() const {
        const auto drawn = std::ranges::count_if(
            brought_, [](const Brought& b) { return b.failure.empty() && !b.empty; });
        const auto empty = std::ranges::count_if(brought_, &Brought::empty);
        std::size_t notes = 0;
        for (const Brought& brought : brought_)
            notes += brought.notes.size();
        std::cout << command_.files.size() << " files, " << refused_ << " refused; "
                  << brought_.size() << " sessions, " << drawn << " draw, " << empty
                  << " draw an empty picture; " << notes << " notes\n";
    }

    const ImportCommand& command_;
    Size size_;
    double budget_s_;
    std::size_t refused_ = 0;
    bool stuck_ = false;
    std::set<std::string> taken_;
    std::vector<Brought> brought_;
};

}  // namespace

int run_import(const ImportCommand& command) {
    const auto size = read_size("--size", command.size);
    if (!size) return report(size.error());
    const auto budget = read_budget(command.budget);
    if (!budget) return report(budget.error());
    std::error_code error;
    fs::create_directories(command.folder, error);
    if (error || !fs::is_directory(command.folder, error))
        return report_run_time("cannot make the folder '" + command.folder + "'");
    Importer importer(command, *size, *budget);
    const int code = importer.run();
    if (importer.is_stuck()) {
        std::cout.flush();
        end_process(code);
    }
    return code;
}

}  // namespace zeroset
