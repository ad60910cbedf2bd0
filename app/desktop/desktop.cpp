#include "app/desktop/desktop.hpp"

#include "document/colors.hpp"
#include "document/play.hpp"
#include "engine/base/language.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/language/help.hpp"
#include "engine/render/render_request.hpp"
#include "engine/render/tracers.hpp"
#include "pipeline/fit_view.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/formula_job.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/periodic_axes.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "pipeline/volume_document.hpp"
#include "pipeline/volume_source.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/screen.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/typing_popup.hpp"
#include "ui/window/window.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Time between steps of a playing slider that moves no picture.
constexpr double slider_frame_s = 1.0 / 60.0;
/// Full pictures quicker than this are waited for before a playing slider moves on.
constexpr double quick_ms = 30.0;
/// Longest step of a playing slider, after a frame that took long.
constexpr double longest_step_s = 0.25;
/// Time for which news stays.
constexpr double news_s = 8.0;
/// Time between two looks at what is being saved.
constexpr double export_shown_s = 0.1;

bool plays_film(const ui::ExportPage& page) {
    return page.open && page.plays && page.wish.kind == ExportKind::Film;
}

Language wanted_language(const ui::UiState& state, Language of_desktop) {
    return state.edited.layout.language.value_or(of_desktop);
}

/// Sets the language of all texts and the decimal mark of numbers.
void take_language(ui::UiState& state, Language wanted) {
    set_language(wanted, decimal_mark_of(wanted, locale_variables()));
    state.shown.export_formats.clear();
}

/// Fills the table of formats once the page of exports needs it: that loads FFmpeg.
void take_formats(ui::UiState& state) {
    if (!state.pages.exports.open || !state.shown.export_formats.empty()) return;
    const auto formats = export_formats();
    state.shown.export_formats.assign(formats.begin(), formats.end());
}

ui::UiState first_state(const DesktopOptions& options) {
    ui::UiState state;
    state.edited.document = options.document;
    state.edited.theme = options.theme;
    state.edited.follows_desktop = options.follows_desktop;
    state.edited.layout = options.layout;
    take_language(state, wanted_language(state, options.desktop_language));
    state.edited.read_only = options.read_only;
    state.edited.full_screen = options.read_only;
    state.edited.layout.presents = options.read_only;
    state.edited.layout.clip_open =
        state.edited.layout.clip_open || !state.edited.document.region.is_whole();
    if (options.takes_keyboard && !options.collection) {
        state.wishes.focus = ui::RowFocus{.row = state.edited.document.statements.front().id,
                                          .caret = ui::RowFocus::Caret::All};
    }
    state.wishes.frame_surfaces = options.fit;
    state.edited.inspection.tracer = options.settings.tracer;
    for (const Tracer& tracer : tracers())
        state.shown.tracers.push_back({.name = std::string(tracer.name),
                                       .about = std::string(tracer.about),
                                       .finds_jumps = tracer.finds_jumps});
    state.shown.language_help = language_help();
    for (const GalleryItem& item : gallery())
        state.shown.gallery.push_back({.title = item.title,
                                       .equation = item.equation,
                                       .about = item.about,
                                       .group = item.group,
                                       .source = item.source});
    state.edited.tour_seen = options.tour_seen;
    if (options.tour) ui::action_named("Tour of the window").run(state);
    for (const ui::Action* const action : options.actions)
        action->run(state);
    return state;
}

}  // namespace

Desktop::Desktop(ui::Window& window, const DesktopOptions& options)
    : window_(window),
      state_(first_state(options)),
      files_(options.files),
      gallery_files_(volume_source({}, files_)),
      session_(state_, {.path = options.path,
                        .note = options.note,
                        .keeps_files = options.keeps_files,
                        .read_only = options.read_only,
                        .files = files_,
                        .browse =
                            [this](Collection collection) {
                                cards_.browse(std::move(collection), state_);
                            }}),
      desktop_language_(options.desktop_language),
      settings_(options.settings),
      fits_box_(options.fits_box),
      frames_box_(options.frames_box),
      fits_itself_(options.fits_itself),
      latency_(options.latency_log.empty() ? nullptr
                                           : std::make_unique<LatencyLog>(options.latency_log)),
      cards_(options.keeps_files, [this] { window_.wake(); }),
      look_cards_(options.keeps_files ? ThumbnailJob::Priority::Low : ThumbnailJob::Priority::Usual,
                  [this] { window_.wake(); }),
      view_cards_(options.keeps_files ? ThumbnailJob::Priority::Low : ThumbnailJob::Priority::Usual,
                  [this] { window_.wake(); }),
      feed_([this] { window_.wake(); },
            [this] {
                if (latency_ != nullptr) latency_->picture_ready();
                window_.wake();
            }),
      comparison_([this] { window_.wake(); }),
      exports_([this] { window_.wake(); }) {
    if (options.collection) cards_.browse(*options.collection, state_);
    const std::vector<std::string>& recent = state_.shown.document.recent;
    if (options.opens_last && !recent.empty()) state_.wishes.open_path = recent.front();
    if (!options.on_desktop) return;
    portal_.emplace([this] { window_.wake(); }, window_.portal_name());
    watch_.emplace(files_, [this] { window_.wake(); });
}

Preferences Desktop::preferences() const {
    const auto chosen =
        state_.edited.follows_desktop ? std::nullopt : std::optional(state_.edited.theme);
    return {.layout = state_.edited.layout,
            .theme = chosen,
            .last_theme = state_.edited.theme,
            .window = window_.size(),
            .tour_seen = state_.edited.tour_seen};
}

double Desktop::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Desktop::draw_frame() {
    const ui::WindowEvents events = window_.take_events();
    if (latency_ != nullptr && events.input) latency_->input(*events.input);
    if (events.close) session_.close();
    session_.open(events.dropped);
    state_.input.pinch = events.pinch;
    const Language wanted = wanted_language(state_, desktop_language_);
    if (wanted != language()) take_language(state_, wanted);
    take_formats(state_);
    const std::uint64_t before = feed_.newest();
    take_formula();
    feed_.take_double();
    take_frame();
    comparison_.show(state_);
    histograms_.show(state_.shown.reading);
    cards_.show(state_);
    look_cards_.show(state_);
    view_cards_.show(state_);
    exports_.show(state_);
    show_points();
    follow_waiting();
    if (portal_) portal_->follow(state_.edited, state_.pages.dialogs);
    play();
    window_.set_letters(ui::shown_letters(state_.edited.layout));
    state_.edited.full_screen = window_.set_full_screen(state_.edited.full_screen);
    window_.hold_keys(ui::awaits_keyboard(state_.wishes, state_.pages));
    window_.begin_frame(state_.edited.theme);
    ui::draw_screen(state_, texture_);
    cards_.follow(state_);
    look_cards_.follow(state_, feed_.on_screen());
    view_cards_.follow(state_, feed_.on_screen());
    // Jobs get the edits before the frame waits for the screen.
    follow_edits();
    follow_waiting();
    if (latency_ != nullptr) log_submission(before);
    const LatencyLog::InOpenGl drawing(latency_.get());
    window_.end_frame();
}

/// Tells the log what an event led to: a picture, a picture to come once the formula is read and
/// compiled, or nothing.
void Desktop::log_submission(std::uint64_t before) {
    if (feed_.newest() != before) {
        latency_->submitted(feed_.newest());
    } else if (!feed_.reads()) {
        latency_->nothing_submitted();
    }
    latency_->about_to_swap();
}

bool Desktop::settled() const {
    const bool frames =
        feed_.formula() != nullptr && (state_.wishes.frame_surfaces || own_fit_due_s_);
    return feed_.has_read(state_.edited.document) && feed_.drawn() &&
           state_.edited.document.camera && !state_.input.move && !frames && !search_.runs() &&
           !snap_.runs() && comparison_.settled() && cards_.settled() && look_cards_.settled() &&
           view_cards_.settled() && exports_.settled() && histograms_.settled();
}

std::optional<double> Desktop::due_s() const {
    if (state_.input.move || plays_film(state_.pages.exports)) return 0.0;
    std::optional<double> due = session_.due_s(now_s());
    const auto due_in = [&due](std::optional<double> s) {
        if (s) due = std::min(due.value_or(*s), *s);
    };
    if (search_.runs()) due_in(ExtentSearch::poll_s);
    if (own_fit_due_s_ && !feed_.tracing()) due_in(std::max(*own_fit_due_s_ - now_s(), 0.0));
    if (snap_.runs()) due_in(MarkerSnap::poll_s);
    if (!histograms_.settled()) due_in(Histograms::poll_s);
    if (exports_.moves()) due_in(export_shown_s);
    due_in(wait_notice_.due_s(now_s()));
    due_in(old_rows_.due_s(now_s()));
    const ui::StatusTexts& status = state_.shown.status;
    if (!status.done.empty() || !status.framed.empty())
        due_in(std::max(told_s_ + news_s - now_s(), 0.0));
    due_in(inspector_.due_s(now_s()));
    if (!state_.edited.playing.empty() && !waits_for_picture())
        due_in(std::max(played_s_ + slider_frame_s - now_s(), 0.0));
    return due;
}

void Desktop::take_formula() {
    const std::optional<FormulaResult> result = feed_.take_reading();
    if (!result) return;
    ui::ReadingFacts& reading = state_.shown.reading;
    // An expression that is still empty is no error.
    const bool typed = !trimmed(result->choice.expression).empty();
    reading.color_error = typed && result->color_error ? result->color_error->reason : "";
    const bool contours_typed = !trimmed(result->choice.lines.expression).empty();
    reading.contour_error =
        contours_typed && result->contour_error ? result->contour_error->reason : "";
    reading.reports = result->reading.reports;
    reading.surface_rows = result->reading.surface_rows;
    if (result->formula) {
        show(*result);
        submit_picture();
    } else {
        state_.shown.status.note = result->formula.error().reason;
    }
}

void Desktop::show(const FormulaResult& result) {
    ui::ReadingFacts& reading = state_.shown.reading;
    reading.parameters = result.reading.program->parameters;
    reading.uses_w = feed_.formula()->uses_w();
    reading.calls_w_t = result.reading.program->calls_w_t;
    reading.thick_rows.clear();
    for (const ThickSurface& thick : feed_.formula()->thick)
        reading.thick_rows.push_back(feed_.formula()->surface_rows[thick.surface]);
    histograms_.follow(*result.reading.program);
    state_.shown.picture.of_pi = periodic_axes(*result.reading.program);
    state_.shown.status.note = note_on_code(*feed_.formula());
    session_.amend([&](Document& document) {
        choose_colors(document, result.reading.surface_rows);
        take_asked_box(*result.reading.program, document);
        for (const auto& [name, volume] : histograms_.wanted())
            document.parameters.try_emplace(name, isovalue_slider(*volume));
    });
    plan_own_fit();
    std::erase_if(state_.edited.playing, [&reading](const auto& entry) {
        const std::string& name = entry.first;
        return name == ui::w_name
                   ? !reading.uses_w
                   : std::ranges::find(reading.parameters, name) == reading.parameters.end();
    });
}

/// Whether the clip box was chosen by the surfaces.
bool Desktop::has_own_box(const Document& document) const {
    return own_box_ && own_box_->row == document.statements.front().id &&
           own_box_->box == document.clip;
}

/// Makes the clip box that of a plotting command, unless the person has chosen another one.
void Desktop::take_asked_box(const Program& program, Document& document) {
    const std::optional<Box> asked = asked_box(program);
    if (asked == asked_box_) return;
    const bool is_free =
        document.clip == Box() || document.clip == asked_box_ || has_own_box(document);
    asked_box_ = asked;
    if (!is_free) return;
    own_box_.reset();
    document.clip = asked.value_or(Box());
    document.camera.reset();
}

/// True while the picture of the last step of a playing slider is still to come.
bool Desktop::waits_for_picture() const {
    const bool quick = state_.shown.figures.frame_ms < quick_ms;
    return feed_.tracing() && (quick || !feed_.shows_newest());
}

void Desktop::play() {
    const double now = now_s();
    const double elapsed = std::min(now - played_s_, longest_step_s);
    if (!state_.edited.playing.empty() && waits_for_picture()) return;
    played_s_ = now;
    for (auto& [name, playing] : state_.edited.playing) {
        Slider slider = ui::slider_named(state_.edited.document, name);
        advance(slider, playing, elapsed);
        ui::set_slider(state_.edited.document, name, slider);
    }
    session_.played();
}

void Desktop::follow_edits() {
    show_gallery_item();
    inspector_.follow(state_, feed_.on_screen(), now_s());
    snap_marker();
    session_.follow(now_s());
    read_rows();
    follow_news();
    find_view();
    find_surfaces();
    submit_picture();
    comparison_.follow(state_, feed_.on_screen());
    follow_exports();
    window_.set_title(session_.title() + " - Zeroset");
}

void Desktop::read_rows() {
    const Document& document = state_.edited.document;
    const auto is_wrong = [](const auto& entry) { return entry.second.error.has_value(); };
    const bool wrong = std::ranges::any_of(state_.shown.reading.reports, is_wrong);
    old_rows_.follow(sheet_of(document), wrong, now_s());
    feed_.read(document, old_rows_.stay(now_s()));
}

void Desktop::show_gallery_item() {
    const auto picked = std::exchange(state_.wishes.gallery_item, std::nullopt);
    if (!picked) return;
    if (*picked < gallery().size()) {
        const std::string before = state_.shown.document.name;
        session_.show(taken_over(gallery()[*picked], state_.edited.document, gallery_files_));
        tell_done(filled(tr("Ctrl+Z brings back: {0}"), {before}));
        frames_box_ = true;
    } else {
        state_.wishes.open_path = state_.shown.gallery[*picked].path;
    }
    window_.wake();
}

std::optional<ExportSubject> Desktop::export_subject() const {
    const auto wanted = wanted_picture();
    if (!wanted || !feed_.has_read(state_.edited.document)) return std::nullopt;
    ExportSubject subject{.document = state_.edited.document,
                          .formula = wanted->formula,
                          .colors = wanted->colors,
                          .settings = settings_,
                          .whole_box = shows_whole_box()};
    subject.settings.tracer = state_.edited.inspection.tracer;
    // The usual background of pictures is dark: not what a light window shows.
    if (state_.edited.theme == ui::Theme::Light && !subject.document.light.background)
        subject.document.light.background = ui::picture_background(ui::Theme::Light);
    return subject;
}

void Desktop::follow_exports() {
    exports_.follow(state_, export_subject());
    const auto outcome = exports_.take();
    if (!outcome) return;
    if (!*outcome) return session_.tell(outcome->error());
    const std::filesystem::path saved(exports_.saved_path());
    if (saved.empty()) return tell_done(**outcome);
    tell_done(filled(tr("{0}, in {1}"), {**outcome, saved.parent_path().string()}), saved.string());
}

void Desktop::tell_done(std::string text, std::string saved) {
    state_.shown.status.done = std::move(text);
    state_.shown.status.saved = std::move(saved);
    told_s_ = now_s();
}

void Desktop::follow_news() {
    ui::StatusTexts& status = state_.shown.status;
    if (const auto file = std::exchange(state_.wishes.show_file, std::nullopt); file && portal_)
        portal_->show(*file);
    if (now_s() < told_s_ + news_s) return;
    status.done.clear();
    status.framed.clear();
    status.saved.clear();
}

}  // namespace zeroset
