#include "app/cli/commands.hpp"
#include "app/cli/film_options.hpp"
#include "app/cli/options/option_reader.hpp"
#include "app/cli/options/view_options.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/report.hpp"
#include "engine/base/clock.hpp"
#include "pipeline/fit_view.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/plans/film.hpp"
#include "pipeline/plans/film_files.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// The meaning of the options, checked before any work.
struct FilmJob {
    InputDocument input;
    TraceSettings settings;
    Size size{};
    FilmPlan plan;
    FrameRange range;
    FrameRangeChoice frame_range;
    FilmTarget target;
    double budget_s = default_budget_s;
};

double aspect_of(const FilmJob& job) {
    return static_cast<double>(job.size.width) / job.size.height;
}

OrInputError<FilmJob> job_of(const FilmCommand& command) {
    FilmJob job;
    OptionReader reader;
    reader.take(job.size, read_size("--size", command.size));
    reader.take(job.settings, read_trace_settings(command.trace));
    reader.take(job.budget_s, read_budget(command.budget));
    if (reader.error()) return std::unexpected(*reader.error());
    auto input = read_document_with_rows(command.equation, command.view);
    if (!input) return std::unexpected(input.error());
    job.input = std::move(*input);
    reader.check(take_look(command.trace, job.input.document));
    reader.check(check_jumps(job.input.document, job.settings));
    fit_camera(command.view, job.input.stored, aspect_of(job), job.input.document);
    reader.take(job.plan, read_film_plan(command, job.input));
    reader.take(job.range, read_frame_range(command, job.plan));
    reader.take(job.frame_range, read_frame_range_choice(command));
    reader.take(job.target, read_film_target(command, job.size, job.plan));
    return reader.finish(std::move(job));
}

/// Everything that the film's thread works with; it may outlive everything else.
struct Filming {
    FilmCommand command;
    FilmJob job;
    Progress progress;
    std::atomic<bool> cancel = false;
    std::optional<InputError> wrong;
    std::string error;  ///< of drawing or writing, or empty
    std::string note;   ///< on --fit, or empty
    Json stats;
};

Json stats_of(const Filming& filming, const FilmWork& work, const FrameFiles& files, double ms) {
    const FilmJob& job = filming.job;
    return {{"width", job.size.width},
            {"height", job.size.height},
            {"frames", job.range.last - job.range.first + 1},
            {"drawn", work.drawn},
            {"frames_per_second",
             {{"numerator", job.plan.rate.frames}, {"denominator", job.plan.rate.seconds}}},
            {"drawing_ms", work.drawing_ms},
            {"frame_ranges",
             {{"frames", work.frame_ranges.frames},
              {"searches", work.frame_ranges.searches},
              {"boxes", work.frame_ranges.ranges},
              {"search_ms", work.frame_ranges.search_ms},
              {"length", work.frame_ranges.length}}},
            {"evaluations", work.counters.form + work.counters.range + work.counters.value},
            {"writing_ms", files.writing_ms()},
            {"waiting_ms", work.waiting_ms},
            {"elapsed_ms", ms},
            {"undecided_by_budget", work.counters.cut_pixels}};
}

/// Makes the code and, if that is wanted, fits the view.
std::expected<PreparedDocument, InputError> prepare_film(Filming& filming) {
    FilmJob& job = filming.job;
    Document& document = job.input.document;
    auto prepared = prepare(document, std::move(*job.input.rows), Preparation::Compiled);
    if (!prepared) return prepared;
    const PictureRequest request = picture_request(prepared->formula, prepared->colors, document,
                                                   job.settings, {job.size.width, job.size.height});
    const std::string& tracer = job.settings.tracer;
    if (const auto refusal = tracer_refusal(tracer, "--tracer " + tracer, request))
        return std::unexpected(InputError{.reason = *refusal});
    const ViewText& view = filming.command.view;
    const TimeLimit limit{.cancel = &filming.cancel,
                          .until = until_after(Clock::now(), job.budget_s)};
    if (!view.fit && job.plan.sweeps.empty() && job.plan.path.empty() &&
        has_free_view(job.input, view)) {
        const std::string note =
            fit_by_itself(document, request, aspect_of(job), own_fitting_limit(limit));
        if (!note.empty() && !view.quiet) std::cerr << fitted_note(note);
    }
    if (!view.fit) return prepared;
    filming.progress.enter(Progress::Stage::Fitting);
    filming.note = fit_view(document, request, aspect_of(job), !view.box, limit);
    // A turn finds the distance from which all of it is seen by itself.
    if (job.plan.turn) document.camera.reset();
    return prepared;
}

void make_film(Filming& filming) {
    const auto start = Clock::now();
    const FilmJob& job = filming.job;
    auto prepared = prepare_film(filming);
    if (!prepared) {
        filming.wrong = prepared.error();
        return;
    }
    const PictureOptions& options = job.target.picture_options;
    const bool pictures = job.target.names.has_value();
    const Film film{.prepared = std::move(*prepared),
                    .script = FilmScript(job.plan, job.input.document, aspect_of(job)),
                    .settings = job.settings,
                    .size = {.width = job.size.width, .height = job.size.height},
                    .first = job.range.first,
                    .last = job.range.last,
                    .frame_range = job.frame_range,
                    .legend = !filming.command.no_legend,
                    .transparent = job.target.transparent(),
                    .keeps_light = pictures && needs_light(options),
                    .keeps_normals = pictures && needs_normals(options),
                    .frame_budget_s = job.budget_s};
    FrameFiles files(job.target);
    auto done = files.begin();
    FilmWork work;
    if (done) {
        filming.progress.enter(Progress::Stage::Filming,
                               static_cast<std::uint64_t>(film.last - film.first + 1));
        FilmWatch watch{.cancel = &filming.cancel,
                        .on_frame = [&](int) { filming.progress.add(1); }};
        if (filming.command.resume) {
            watch.has_frame = [&](int number, const Document& document) {
                return files.has(number, document);
            };
        }
        const auto take = [&](const FilmFrame& frame) {
            const Framebuffer& painted = frame.picture.painted;
            filming.progress.show(painted, 0, painted.height);
            return files.take(frame);
        };
        const auto drawn = draw_film(film, take, watch);
        if (drawn) work = *drawn;
        if (!drawn) filming.error = drawn.error();
        if (drawn) done = files.finish();
    }
    if (!done) filming.error = done.error().message;
    filming.stats = stats_of(filming, work, files, ms_since(start));
}

int finish(const Filming& filming) {
    if (filming.wrong) return report(*filming.wrong);
    if (!filming.note.empty()) std::cerr << "zeroset: --fit: " << filming.note << '\n';
    if (!filming.error.empty()) return report_run_time(filming.error);
    const auto cut = filming.stats["undecided_by_budget"].get<std::uint64_t>();
    if (cut > 0) {
        std::cerr << "zeroset: " << cut
                  << " pixels of the film are left undecided; --budget SECONDS gives more\n";
    }
    if (!filming.command.stats) return exit_ok;
    const auto written = write_text(*filming.command.stats, filming.stats.dump(2) + "\n");
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace

int run_film(const FilmCommand& command) {
    auto job = job_of(command);
    if (!job) return report(job.error());
    if (const auto message = first_unwritable({command.stats})) return report_run_time(*message);
    const auto filming = std::make_shared<Filming>();
    filming->command = command;
    filming->job = std::move(*job);
    finish_until(TimeLimit::never, filming->progress, [filming] { make_film(*filming); });
    return finish(*filming);
}

}  // namespace zeroset
