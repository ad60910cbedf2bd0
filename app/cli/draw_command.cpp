#include "app/cli/commands.hpp"
#include "app/cli/options/option_reader.hpp"
#include "app/cli/options/view_options.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/report.hpp"
#include "app/platform/process.hpp"
#include "engine/base/clock.hpp"
#include "engine/base/text.hpp"
#include "engine/draw/files/formats.hpp"
#include "engine/export/file.hpp"
#include "pipeline/drawing_scene.hpp"
#include "pipeline/plans/export_formats.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// How long to wait for a drawing beyond its budget, as LLVM cannot be interrupted.
constexpr auto drawing_patience = std::chrono::seconds(2);

/// A drawing being made. The thread that makes it shares its ownership and may outlive the command.
struct DrawJob {
    Document document;
    RowProgram rows;
    DrawingPlan plan;
    double budget_s = default_budget_s;
    bool quiet = false;  ///< no notes
    Clock::time_point start;

    Progress progress;
    std::atomic<bool> cancel = false;
    std::optional<InputError> error;
    std::string note;
    LineDrawing drawing;

    std::mutex mutex;
    std::vector<DrawnPath> so_far;  ///< paths that are drawn already
};

const DrawingFormat* format_of(const DrawCommand& command) {
    return command.output ? find_drawing_format(*command.output) : nullptr;
}

OrInputError<std::shared_ptr<DrawJob>> job_of(const DrawCommand& command) {
    auto job = std::make_shared<DrawJob>();
    if (!command.output && !command.stats)
        return wrong_input("nothing to write: give -o OUT.svg or --stats -");
    if (command.output && format_of(command) == nullptr) {
        return wrong_input("-o " + *command.output + ": " +
                           other_name(ExportKind::Drawing, *command.output));
    }
    OptionReader reader;
    reader.take(job->plan, read_drawing(command.drawing));
    reader.take(job->budget_s, read_budget(command.budget));
    if (reader.error()) return std::unexpected(*reader.error());
    job->plan.choice.fits = command.view.fit;
    job->plan.choice.fits_box = !command.view.box;
    auto input = read_document_with_rows(command.equation, command.view);
    if (!input) return std::unexpected(input.error());
    job->plan.choice.fits_itself = has_free_view(*input, command.view);
    job->quiet = command.view.quiet;
    job->document = std::move(input->document);
    reader.check(take_look(command.trace, job->document));
    if (reader.error()) return std::unexpected(*reader.error());
    const PageSize& page = job->plan.choice.page;
    fit_camera(command.view, input->stored, page.width / page.height, job->document);
    job->rows = std::move(*input->rows);
    return job;
}

void work_on(DrawJob& job) {
    const TimeLimit limit{.cancel = &job.cancel, .until = until_after(job.start, job.budget_s)};
    const auto scene = drawing_scene(job.document, job.rows, job.plan.choice, limit);
    if (!scene) {
        job.error = scene.error();
        return;
    }
    job.note = scene->note;
    job.progress.enter(Progress::Stage::Drawing);
    job.drawing = line_drawing(*scene, limit, [&job](const DrawnPath& path) {
        const std::scoped_lock lock(job.mutex);
        job.so_far.push_back(path);
    });
}

/// One line on what the drawing may lack; empty if it lacks nothing.
std::string warning_of(const DrawJob& job, const LineDrawing& drawing) {
    std::string lacks = drawing.lacks(job.plan.choice.tolerance_pt);
    if (drawing.in_time()) return lacks;
    return "the budget of " + short_number(job.budget_s) + " s is spent on " +
           name_of(job.progress.stage()) + ": " + lacks + "; --budget SECONDS gives more";
}

Json stats_of(const DrawJob& job, const LineDrawing& drawing) {
    Json kinds = Json::object();
    for (const CurveKind kind : curve_kinds()) {
        std::size_t paths = 0, loops = 0, hidden = 0, pieces = 0;
        for (const DrawnPath& path : drawing.paths) {
            if (path.kind != kind) continue;
            ++paths;
            loops += path.closed ? 1 : 0;
            hidden += path.hidden ? 1 : 0;
            pieces += path.pieces.size();
        }
        kinds[std::string(name_of(kind))] = {
            {"paths", paths}, {"closed", loops}, {"hidden", hidden}, {"pieces", pieces}};
    }
    const FindingReport& report = drawing.report;
    return {{"width_pt", drawing.size.width},
            {"height_pt", drawing.size.height},
            {"tolerance_pt", job.plan.choice.tolerance_pt},
            {"lines", kinds},
            {"cells", report.cells},
            {"cells_proved", report.regular},
            {"cells_open", report.open},
            {"cells_on_double_lines", report.singular},
            {"cells_open_pt", report.open_pt},
            {"ends_within", report.stuck},
            {"in_time", drawing.in_time()},
            {"elapsed_ms", ms_since(job.start)}};
}

std::expected<void, std::string> write_files(const DrawCommand& command, const DrawJob& job,
                                             const LineDrawing& drawing) {
    std::expected<void, FileError> written;
    if (command.output) {
        const auto bytes = format_of(command)->encode(drawing, job.plan.style);
        if (!bytes) {
            return std::unexpected("cannot write '" + *command.output + "': " + bytes.error());
        }
        written = write_text(*command.output, *bytes);
    }
    if (written && command.stats)
        written = write_text(*command.stats, stats_of(job, drawing).dump(2) + "\n");
    if (!written) return std::unexpected(written.error().message);
    return {};
}

int finish(const DrawCommand& command, const DrawJob& job, const LineDrawing& drawing) {
    const std::string warning = warning_of(job, drawing);
    if (!warning.empty()) std::cerr << "zeroset: " << warning << '\n';
    const auto written = write_files(command, job, drawing);
    return written ? exit_ok : report_run_time(written.error());
}

/// The drawing as far as a thread that is still running has made it.
LineDrawing stuck_drawing(DrawJob& job) {
    const DrawingChoice& choice = job.plan.choice;
    LineDrawing drawing{.size = choice.page,
                        .cut = choice.kinds,
                        .contour_width_pt = job.document.coloring.lines.width};
    const std::scoped_lock lock(job.mutex);
    drawing.paths = job.so_far;
    return drawing;
}

}  // namespace

int run_draw(const DrawCommand& command) {
    const auto start = Clock::now();
    const auto made = job_of(command);
    if (!made) return report(made.error());
    const std::shared_ptr<DrawJob>& job = *made;
    job->start = start;
    if (const auto message = first_unwritable({command.output, command.stats}))
        return report_run_time(*message);
    const auto last = until_after(start, job->budget_s) + drawing_patience;
    if (!finish_until(last, job->progress, [job] { work_on(*job); })) {
        job->cancel = true;
        end_process(finish(command, *job, stuck_drawing(*job)));
    }
    if (job->error) return report(*job->error);
    const bool fits = job->plan.choice.fits;
    if (!job->note.empty() && fits) std::cerr << "zeroset: --fit: " << job->note << '\n';
    if (!job->note.empty() && !fits && !job->quiet) std::cerr << fitted_note(job->note);
    return finish(command, *job, job->drawing);
}

}  // namespace zeroset
