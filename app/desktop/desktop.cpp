#include "app/desktop/desktop.hpp"

#include "document/colors.hpp"
#include "document/play.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/base/text.hpp"
#include "engine/language/help.hpp"
#include "engine/render/render_job.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/formula_job.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/picture_request.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/parameter_row.hpp"
#include "ui/screen.hpp"
#include "ui/widgets/typing_popup.hpp"
#include "ui/window/texture.hpp"
#include "ui/window/window.hpp"

#include <glm/ext/vector_int2.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

/// Time between steps of a playing slider that moves no picture.
constexpr double frame_s = 1.0 / 60.0;
/// Full pictures quicker than this are waited for before a playing slider moves on.
constexpr double quick_ms = 30.0;
/// Longest step of a playing slider, after a frame that took long.
constexpr double longest_step_s = 0.25;

/// Interval at which the search for the surfaces' extent is polled.
constexpr double extent_poll_s = 0.004;

std::string note_of(CodeState code) {
    switch (code) {
        case CodeState::Machine:
        case CodeState::InterpretedFirst: return {};
        case CodeState::Interpreted: return "large: interpreted";
    }
    return {};
}

Sheet sheet_of(const Document& document) {
    Sheet sheet;
    for (const Statement& statement : document.statements)
        sheet.push_back({statement.id, statement.text});
    return sheet;
}

ui::UiState first_state(const DesktopOptions& options) {
    ui::UiState state;
    state.document = options.document;
    state.theme = options.theme;
    state.follows_desktop = options.follows_desktop;
    state.layout = options.layout;
    state.layout.clip_open = state.layout.clip_open || !state.document.region.is_whole();
    if (options.takes_keyboard) {
        state.focus = ui::RowFocus{.row = state.document.statements.front().id,
                                   .caret = ui::RowFocus::Caret::All};
    }
    state.frame_surfaces = options.fit;
    state.language_help = language_help();
    for (const GalleryItem& item : gallery())
        state.gallery.push_back({item.title, item.equation, item.about, item.group, item.source});
    for (const ui::Action* const action : options.actions)
        action->run(state);
    return state;
}

}  // namespace

Desktop::Desktop(ui::Window& window, const DesktopOptions& options)
    : window_(window),
      state_(first_state(options)),
      session_(state_,
               {.path = options.path, .note = options.note, .keeps_files = options.keeps_files}),
      settings_(options.settings),
      fits_box_(options.fits_box),
      latency_(options.latency_log.empty() ? nullptr
                                           : std::make_unique<LatencyLog>(options.latency_log)),
      cards_(options.keeps_files, [this] { window_.wake(); }),
      formulas_([this] { window_.wake(); }),
      pictures_([this] {
          if (latency_ != nullptr) latency_->picture_ready();
          window_.wake();
      }) {
    if (options.on_desktop) portal_.emplace([this] { window_.wake(); }, window_.portal_name());
}

Preferences Desktop::preferences() const {
    const auto chosen = state_.follows_desktop ? std::nullopt : std::optional(state_.theme);
    return {.layout = state_.layout,
            .theme = chosen,
            .last_theme = state_.theme,
            .window = window_.size()};
}

double Desktop::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Desktop::draw_frame() {
    const ui::WindowEvents events = window_.take_events();
    if (latency_ != nullptr && events.input) latency_->input(*events.input);
    if (events.close) session_.close();
    session_.open(events.dropped);
    const std::uint64_t before = request_;
    take_formula();
    take_double();
    take_frame();
    cards_.show(state_);
    follow_waiting();
    if (portal_) portal_->follow(state_);
    play();
    window_.hold_keys(ui::awaits_keyboard(state_));
    window_.begin_frame(state_.theme);
    ui::draw_screen(state_, texture_);
    cards_.follow(state_);
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
    const bool reads = answered_rows_ != submitted_rows_;
    if (request_ != before) {
        latency_->submitted(request_);
    } else if (!reads) {
        latency_->nothing_submitted();
    }
    latency_->about_to_swap();
}

bool Desktop::settled() const {
    const bool deepens = shown_ != nullptr && deepening_ == shown_;
    const bool drawn = shown_ == nullptr ||
                       (submitted_ && !state_.picture.tracing && !deepens && !is_preview(*shown_));
    return answered_rows_ == sheet_of(state_.document) && answered_choice_ == submitted_choice_ &&
           drawn && state_.document.camera && !state_.move &&
           !(shown_ != nullptr && state_.frame_surfaces) && !extent_.valid() && cards_.settled();
}

std::optional<double> Desktop::due_s() const {
    if (state_.move) return 0.0;
    std::optional<double> due = session_.due_s(now_s());
    if (extent_.valid()) due = std::min(due.value_or(extent_poll_s), extent_poll_s);
    if (const auto change = waiting_.due_s(now_s())) due = std::min(due.value_or(*change), *change);
    if (const auto click = pointing_.due_s(now_s())) due = std::min(due.value_or(*click), *click);
    if (!state_.playing.empty() && !waits_for_picture()) {
        const double next = std::max(played_s_ + frame_s - now_s(), 0.0);
        due = std::min(due.value_or(next), next);
    }
    return due;
}

void Desktop::take_formula() {
    const std::optional<FormulaResult> result = formulas_.take();
    if (!result) return;
    answered_rows_ = result->sheet;
    answered_choice_ = result->choice;
    // An expression that is still empty is no error.
    const bool typed = !trimmed(result->choice.expression).empty();
    state_.color_error = typed && result->color_error ? result->color_error->reason : "";
    state_.reports = result->reading.reports;
    state_.surface_rows = result->reading.surface_rows;
    if (result->formula) {
        show(*result);
        submit_picture();
    } else {
        state_.note = result->formula.error().reason;
    }
}

/// Takes the shown formula with code in double beside that in float; nothing else changes.
void Desktop::take_double() {
    std::shared_ptr<const Formula> formula = formulas_.take_double();
    if (formula == nullptr || deepening_ != shown_) return;
    deepening_.reset();
    shown_ = std::move(formula);
}

void Desktop::show(const FormulaResult& result) {
    const std::shared_ptr<const Formula>& formula = *result.formula;
    // For the same text, the shown formula may have more code already.
    const bool same = shown_ != nullptr && shown_->text == formula->text &&
                      shown_->surface_rows == formula->surface_rows &&
                      (shown_->code == formula->code || formula->code != CodeState::Machine);
    if (!same) shown_ = formula;
    colors_ = result.colors;
    state_.parameters = result.reading.program->parameters;
    state_.uses_w = shown_->uses_w();
    state_.note = note_of(shown_->code);
    session_.amend(
        [&result](Document& document) { choose_colors(document, result.reading.surface_rows); });
    std::erase_if(state_.playing, [this](const auto& entry) {
        const std::string& name = entry.first;
        return name == ui::w_name
                   ? !state_.uses_w
                   : std::ranges::find(state_.parameters, name) == state_.parameters.end();
    });
}

void Desktop::take_frame() {
    std::optional<RenderResult> result = pictures_.take();
    if (result) {
        state_.shown = {.frame = result->frame, .camera = result->camera};
        if (latency_ != nullptr) {
            latency_->taken(result->request, result->frame->width, result->frame->height,
                            result->complete);
        }
        show_legend(*result);
        upload_frame();
        const bool full = result->complete;
        pictured_request_ = result->request;
        if (pictured_request_ == request_) {
            pictured_text_ = submitted_->formula->text;
            formulas_.drawn();
        }
        pictured_fully_ = full;
        if (full) {
            figures_text_ = pictured_text_;
            const bool newest = result->request == request_;
            state_.picture = {.tracing = !newest,
                              .width_px = result->frame->width,
                              .height_px = result->frame->height,
                              .frame_ms = result->frame_ms,
                              .counts = result->counts,
                              .precision = result->precision};
        }
    } else if (state_.shown.frame != nullptr &&
               (state_.theme != uploaded_theme_ ||
                state_.document.mark_undecided != uploaded_marks_)) {
        upload_frame();
    }
}

void Desktop::show_legend(const RenderResult& result) {
    state_.legend.reset();
    if (result.coloring.by == ColorBy::Plain) return;
    state_.legend = legend_of(result.coloring, colors_->expression);
}

const PictureRequest* Desktop::behind_picture() const {
    if (!submitted_ || pictured_request_ != request_) return nullptr;
    return &*submitted_;
}

void Desktop::upload_frame() {
    const LatencyLog::InOpenGl uploading(latency_.get());
    const bool marks = state_.document.mark_undecided;
    const auto tint = marks ? std::optional(ui::undecided_tint(state_.theme)) : std::nullopt;
    texture_.upload(*state_.shown.frame, ui::behind_picture(state_.theme), tint);
    uploaded_theme_ = state_.theme;
    uploaded_marks_ = marks;
}

/// True while the picture of the last step of a playing slider is still to come.
bool Desktop::waits_for_picture() const {
    if (!state_.picture.tracing) return false;
    const bool quick = state_.picture.frame_ms < quick_ms;
    return pictured_request_ != request_ || (quick && !pictured_fully_);
}

void Desktop::play() {
    const double now = now_s();
    const double elapsed = std::min(now - played_s_, longest_step_s);
    if (!state_.playing.empty() && waits_for_picture()) return;
    played_s_ = now;
    for (auto& [name, playing] : state_.playing) {
        Slider slider = ui::slider_named(state_, name);
        advance(slider, playing, elapsed);
        ui::set_slider(state_, name, slider);
    }
    session_.played();
}

void Desktop::follow_edits() {
    show_gallery_item();
    pointing_.follow(state_, behind_picture(), now_s());
    session_.follow(now_s());
    submit_rows();
    find_view();
    find_surfaces();
    submit_picture();
    window_.set_title(session_.title() + " - Zeroset");
}

void Desktop::show_gallery_item() {
    const auto picked = std::exchange(state_.surface, std::nullopt);
    if (!picked) return;
    Document document = read_document(gallery()[*picked]).document;
    keep_settings(document, state_.document);
    document.coloring = state_.document.coloring;
    document.coloring.range.reset();
    session_.show(std::move(document));
    window_.wake();
}

void Desktop::submit_rows() {
    Sheet sheet = sheet_of(state_.document);
    // Only what needs a formula is taken from the colouring.
    ColorChoice choice;
    choice.by = state_.document.coloring.by;
    if (choice.by == ColorBy::Expression) choice.expression = state_.document.coloring.expression;
    if (sheet == submitted_rows_ && choice == submitted_choice_) return;
    submitted_rows_ = sheet;
    submitted_choice_ = choice;
    formulas_.submit(std::move(sheet), state_.document.clip, choice);
}

std::optional<PictureRequest> Desktop::wanted_picture() const {
    const glm::ivec2 size = state_.viewport_px;
    const Document& document = state_.document;
    if (shown_ == nullptr || colors_ == nullptr || !document.camera || size.x <= 0 || size.y <= 0) {
        return std::nullopt;
    }
    TraceSettings settings = settings_;
    settings.stop = document.stop;
    return picture_request(shown_, colors_, document, settings, size);
}

void Desktop::submit_picture() {
    std::optional<PictureRequest> wanted = wanted_picture();
    if (!wanted || submitted_ == wanted) return;
    if (!has_code_for(*wanted)) {
        // The last picture stays until the code in this precision is ready.
        if (deepening_ != shown_) formulas_.submit_double(shown_);
        deepening_ = shown_;
        return;
    }
    RenderRequest request = render_request(*wanted);
    request.preview = is_preview(*shown_);
    request.again = submitted_ && differs_in_code_only(*submitted_, *wanted);
    request_ = pictures_.submit(std::move(request));
    state_.picture.tracing = true;
    submitted_ = std::move(wanted);
    window_.wake();
}

}  // namespace zeroset
