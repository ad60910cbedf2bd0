#include "app/desktop.hpp"

#include "app/commands.hpp"
#include "app/formula.hpp"
#include "app/formula_job.hpp"
#include "app/gallery.hpp"
#include "app/language.hpp"
#include "app/options.hpp"
#include "engine/trace/camera.hpp"
#include "engine/trace/palette.hpp"
#include "engine/trace/precision.hpp"
#include "engine/trace/render_job.hpp"
#include "engine/trace/scene.hpp"
#include "ui/label.hpp"
#include "ui/screen.hpp"
#include "ui/texture.hpp"
#include "ui/ui_state.hpp"
#include "ui/window.hpp"

#include <glm/ext/vector_int2.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

std::vector<ui::Reading> readings_of(const Program& program) {
    std::vector<ui::Reading> readings;
    std::size_t surface = 0;
    for (const Reading& reading : program.readings) {
        const bool drawn = reading.kind == StatementKind::Surface;
        const std::optional<std::uint32_t> color =
            drawn ? std::optional(swatch_color(surface++)) : std::nullopt;
        readings.push_back({reading.text, color});
    }
    return readings;
}

std::string note_of(CodeState code) {
    switch (code) {
        case CodeState::Machine: return {};
        case CodeState::InterpretedFirst: return "interpreted until its machine code is ready";
        case CodeState::Interpreted: return "large: interpreted";
    }
    return {};
}

}  // namespace

bool Desktop::same_picture(const Wanted& a, const Wanted& b) {
    return a.formula == b.formula && a.clip.lo == b.clip.lo && a.clip.hi == b.clip.hi &&
           a.camera == b.camera && (a.w == b.w || !a.formula->uses_w()) &&
           a.parameters == b.parameters && a.stop.rule == b.stop.rule &&
           a.stop.value == b.stop.value && a.size_px == b.size_px;
}

Desktop::Desktop(ui::Window& window, const DesktopOptions& options)
    : window_(window),
      settings_(options.settings),
      opening_(options.surface),
      home_(options.surface.camera),
      formulas_([this] { window_.wake(); }),
      pictures_([this] { window_.wake(); }) {
    state_.equation = options.surface.equation;
    state_.clip = options.surface.clip;
    state_.w = options.surface.w;
    state_.stop = options.settings.stop;
    state_.theme = options.theme;
    state_.focus_equation = options.takes_keyboard;
    state_.mark_undecided = options.mark_undecided;
    state_.reset_view = true;
    state_.language_help = language_help();
    for (const GalleryItem& item : gallery()) {
        state_.gallery.push_back({item.title, item.equation, item.about});
    }
}

void Desktop::draw_frame() {
    take_formula();
    take_double();
    take_frame();
    window_.begin_frame(state_.theme);
    ui::draw_screen(state_, texture_);
    window_.end_frame();
    follow_edits();
}

bool Desktop::settled() const {
    const bool deepens = shown_ != nullptr && deepening_ == shown_;
    const bool drawn = shown_ == nullptr || (submitted_ && !state_.picture.tracing && !deepens);
    return answered_text_ == state_.equation && drawn && !state_.reset_view;
}

void Desktop::take_formula() {
    std::optional<FormulaResult> result = formulas_.take();
    if (!result) return;
    answered_text_ = result->text;
    if (result->formula) {
        show(std::move(*result->formula));
    } else if (result->text == state_.equation) {
        const InputError& error = result->formula.error();
        state_.error = error.reason;
        state_.error_at = error.offset;
        state_.unfinished = error.unfinished;
    }
}

/// The shown formula, now with code in double, too; nothing else changes.
void Desktop::take_double() {
    std::shared_ptr<const Formula> formula = formulas_.take_double();
    if (formula == nullptr || deepening_ != shown_) return;
    deepening_.reset();
    shown_ = std::move(formula);
}

void Desktop::show(std::shared_ptr<const Formula> formula) {
    shown_ = std::move(formula);
    const bool opens = opening_ && opening_->equation == shown_->text;
    if (opens) {
        state_.clip = opening_->clip;
        state_.w = opening_->w;
        state_.w_lo = std::min(-2.0, state_.w);
        state_.w_hi = std::max(2.0, state_.w);
        home_ = opening_->camera;
        state_.reset_view = true;
    }
    show_parameters(opens ? opening_->parameters : ParameterValues{});
    if (opens || (opening_ && opening_->equation != state_.equation)) opening_.reset();
    state_.error.clear();
    state_.error_at.reset();
    state_.unfinished = false;
    state_.readings = readings_of(shown_->program);
    state_.uses_w = shown_->uses_w();
    state_.note = note_of(shown_->code);
    window_.set_title("Zeroset - " + ui::in_one_line(shown_->text));
}

/// A slider for each parameter, as it was left when the text had it last.
void Desktop::show_parameters(const ParameterValues& opened) {
    for (const ui::ParameterSlider& slider : state_.parameters)
        known_sliders_[slider.name] = slider;
    state_.parameters.clear();
    for (const std::string& name : shown_->program.parameters) {
        const auto known = known_sliders_.find(name);
        ui::ParameterSlider slider =
            known == known_sliders_.end() ? ui::ParameterSlider{name} : known->second;
        if (const auto value = opened.find(name); value != opened.end()) {
            slider.value = value->second;
            slider.lo = std::min(slider.lo, slider.value);
            slider.hi = std::max(slider.hi, slider.value);
        }
        state_.parameters.push_back(std::move(slider));
    }
}

void Desktop::take_frame() {
    std::optional<RenderResult> result = pictures_.take();
    if (result) {
        state_.shown = {result->frame, result->camera};
        upload_frame();
        if (result->complete) {
            const bool newest = result->request == request_;
            state_.picture = {!newest,          result->frame->width, result->frame->height,
                              result->frame_ms, result->counts,       result->precision};
        }
    } else if (state_.shown.frame != nullptr &&
               (state_.theme != uploaded_theme_ || state_.mark_undecided != uploaded_marks_)) {
        upload_frame();
    }
}

void Desktop::upload_frame() {
    const auto tint =
        state_.mark_undecided ? std::optional(ui::undecided_tint(state_.theme)) : std::nullopt;
    texture_.upload(*state_.shown.frame, ui::behind_picture(state_.theme), tint);
    uploaded_theme_ = state_.theme;
    uploaded_marks_ = state_.mark_undecided;
}

void Desktop::follow_edits() {
    if (state_.surface) {
        const GalleryItem& item = gallery()[*state_.surface];
        state_.surface.reset();
        state_.equation = item.equation;
        opening_ = Surface{item.equation, item.clip, item.w, item.camera, {}};
        submitted_text_.clear();  // the same equation again still resets its view
        window_.wake();
    }
    if (state_.equation != submitted_text_) {
        submitted_text_ = state_.equation;
        const bool opens = opening_ && opening_->equation == state_.equation;
        formulas_.submit(state_.equation, opens ? opening_->clip : state_.clip);
    }
    if (state_.reset_view) reset_view();
    submit_picture();
}

void Desktop::reset_view() {
    const glm::ivec2 size = state_.viewport_px;
    if (size.x <= 0 || size.y <= 0) return;
    const double aspect = static_cast<double>(size.x) / static_cast<double>(size.y);
    state_.camera = home_ ? *home_ : default_camera(state_.clip, aspect);
    state_.reset_view = false;
}

std::optional<Desktop::Wanted> Desktop::wanted_picture() const {
    const glm::ivec2 size = state_.viewport_px;
    if (shown_ == nullptr || state_.reset_view || size.x <= 0 || size.y <= 0) return std::nullopt;
    Wanted wanted{shown_, state_.clip, state_.camera, state_.w, {}, state_.stop, size};
    for (const ui::ParameterSlider& slider : state_.parameters)
        wanted.parameters[slider.name] = slider.value;
    return wanted;
}

void Desktop::submit_picture() {
    std::optional<Wanted> next = wanted_picture();
    if (!next || (submitted_ && same_picture(*submitted_, *next))) return;
    Wanted& wanted = *next;
    if (!shown_->has_code(wanted_precision(wanted.clip, ViewFrame(wanted.camera), wanted.stop))) {
        // The last picture stays until the code is there.
        if (deepening_ != shown_) formulas_.submit_double(shown_);
        deepening_ = shown_;
        return;
    }

    RenderRequest request;
    request.scene = make_scene(*shown_, wanted.clip, wanted.w, wanted.parameters);
    request.camera = wanted.camera;
    request.settings = settings_;
    request.settings.stop = wanted.stop;
    request.width = wanted.size_px.x;
    request.height = wanted.size_px.y;
    request_ = pictures_.submit(std::move(request));
    state_.picture.tracing = true;
    submitted_ = std::move(next);
    window_.wake();
}

OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace) {
    const std::string first = "@" + gallery().front().name;
    auto surface = read_surface(equation.empty() ? first : equation, view);
    if (!surface) return std::unexpected(surface.error());
    auto settings = read_trace_settings(trace);
    if (!settings) return std::unexpected(settings.error());
    const bool stop_given = trace.d_stop || trace.epsilon || trace.delta;
    constexpr double interactive_d_stop = 14.0;
    if (!stop_given) settings->stop.value = interactive_d_stop;
    DesktopOptions options;
    options.surface = std::move(*surface);
    options.settings = std::move(*settings);
    return options;
}

int run_desktop(const DesktopOptions& options) {
    auto window = ui::make_glfw_window({});
    if (!window) {
        std::cerr << "zeroset: " << window.error()
                  << "; `zeroset render \"EQUATION\" -o out.png` works without a display\n";
        return exit_run_time;
    }
    Desktop desktop(**window, options);
    while ((*window)->wait()) {
        desktop.draw_frame();
    }
    return exit_ok;
}

}  // namespace zeroset
