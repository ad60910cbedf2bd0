#include "app/desktop.hpp"

#include "app/formula.hpp"
#include "app/formula_job.hpp"
#include "app/gallery.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/trace/camera.hpp"
#include "engine/trace/render_job.hpp"
#include "engine/trace/scene.hpp"
#include "ui/screen.hpp"
#include "ui/texture.hpp"
#include "ui/ui_state.hpp"
#include "ui/window.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

/// All that the picture depends on and that the window can change.
struct Wanted {
    std::shared_ptr<const Formula> formula;
    Box clip;
    Camera camera;
    double w = 0.0;
    StopCriterion stop;
    glm::ivec2 size_px{0};
};

bool same_picture(const Wanted& a, const Wanted& b) {
    return a.formula == b.formula && a.clip.lo == b.clip.lo && a.clip.hi == b.clip.hi &&
           a.camera == b.camera && (a.w == b.w || !a.formula->kernel.uses_w) &&
           a.stop.rule == b.stop.rule && a.stop.value == b.stop.value && a.size_px == b.size_px;
}

/// A surface that was picked and how it is first looked at.
struct Opening {
    std::string equation;
    Box clip;
    double w = 0.0;
    std::optional<Camera> camera;
};

/// The window's content over time. Everything here belongs to the window's thread; the jobs'
/// threads only wake it.
class Desktop {
public:
    Desktop(std::unique_ptr<ui::Window> window, const DesktopOptions& options);
    int run();

private:
    void take_formula();
    void show(std::shared_ptr<const Formula> formula);
    void take_frame();
    void upload_frame();
    void follow_edits();
    void reset_view();
    void submit_picture();

    std::unique_ptr<ui::Window> window_;  // outlives the jobs that wake it and the texture
    ui::Texture texture_;
    ui::UiState state_;
    TraceSettings settings_;

    std::string submitted_text_;
    std::optional<Opening> opening_;  ///< waits for its formula
    std::optional<Camera> home_;      ///< what Reset view goes back to, if it is not the default
    std::shared_ptr<const Formula> shown_;  ///< the last good one
    std::optional<Wanted> submitted_;
    std::uint64_t request_ = 0;
    std::shared_ptr<const Framebuffer> frame_;
    ui::Theme uploaded_theme_ = ui::Theme::Dark;

    FormulaJob formulas_;
    RenderJob pictures_;
};

Desktop::Desktop(std::unique_ptr<ui::Window> window, const DesktopOptions& options)
    : window_(std::move(window)),
      settings_(options.settings),
      opening_(Opening{options.equation, options.clip, options.w, options.camera}),
      formulas_([this] { window_->wake(); }),
      pictures_([this] { window_->wake(); }) {
    state_.equation = options.equation;
    state_.clip = options.clip;
    state_.w = options.w;
    state_.stop = options.settings.stop;
    state_.reset_view = true;
    home_ = options.camera;
    for (const GalleryItem& item : gallery()) {
        state_.gallery.push_back({item.title, item.equation, item.about});
    }
}

int Desktop::run() {
    while (window_->wait()) {
        take_formula();
        take_frame();
        window_->begin_frame(state_.theme);
        ui::draw_screen(state_, texture_);
        window_->end_frame();
        follow_edits();
    }
    return 0;
}

void Desktop::take_formula() {
    std::optional<FormulaResult> result = formulas_.take();
    if (!result) return;
    if (result->formula) {
        show(std::move(*result->formula));
    } else if (result->text == state_.equation) {
        state_.error = result->formula.error().reason;
        state_.error_column = result->formula.error().column;
    }
}

void Desktop::show(std::shared_ptr<const Formula> formula) {
    shown_ = std::move(formula);
    const bool opens = opening_ && opening_->equation == shown_->text;
    if (opens) {
        state_.clip = opening_->clip;
        state_.w = opening_->w;
        home_ = opening_->camera;
        state_.reset_view = true;
    }
    if (opens || (opening_ && opening_->equation != state_.equation)) opening_.reset();
    state_.error.clear();
    state_.error_column.reset();
    state_.reading = shown_->expr.canonical() + " = 0";
    state_.uses_w = shown_->kernel.uses_w;
    window_->set_title("Zeroset - " + shown_->text);
}

void Desktop::take_frame() {
    std::optional<RenderResult> result = pictures_.take();
    if (result) {
        frame_ = result->frame;
        upload_frame();
        if (result->coarseness == 1) {
            const bool newest = result->request == request_;
            state_.picture = {!newest, frame_->width, frame_->height, result->frame_ms,
                              result->counts};
        }
    } else if (frame_ != nullptr && state_.theme != uploaded_theme_) {
        upload_frame();
    }
}

void Desktop::upload_frame() {
    texture_.upload(*frame_, ui::behind_picture(state_.theme));
    uploaded_theme_ = state_.theme;
}

void Desktop::follow_edits() {
    if (state_.surface) {
        const GalleryItem& item = gallery()[*state_.surface];
        state_.surface.reset();
        state_.equation = item.equation;
        opening_ = Opening{item.equation, item.clip, item.w, item.camera};
        submitted_text_.clear();  // the same equation again still resets its view
        window_->wake();
    }
    if (state_.equation != submitted_text_) {
        submitted_text_ = state_.equation;
        formulas_.submit(state_.equation);
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

void Desktop::submit_picture() {
    const glm::ivec2 size = state_.viewport_px;
    if (shown_ == nullptr || state_.reset_view || size.x <= 0 || size.y <= 0) return;
    Wanted wanted{shown_, state_.clip, state_.camera, state_.w, state_.stop, size};
    if (submitted_ && same_picture(*submitted_, wanted)) return;

    RenderRequest request;
    request.scene = {shown_->kernel, wanted.clip, {}};
    request.scene.uniforms.set(0, wanted.w);
    request.camera = wanted.camera;
    request.settings = settings_;
    request.settings.stop = wanted.stop;
    request.width = size.x;
    request.height = size.y;
    request_ = pictures_.submit(std::move(request));
    state_.picture.tracing = true;
    submitted_ = std::move(wanted);
    window_->wake();
}

}  // namespace

int run_desktop(const DesktopOptions& options) {
    auto window = ui::make_glfw_window({});
    if (!window) {
        std::cerr << "zeroset: " << window.error()
                  << "; `zeroset render \"EQUATION\" -o out.png` works without a display\n";
        return 1;
    }
    return Desktop(std::move(*window), options).run();
}

}  // namespace zeroset
