#pragma once

#include "engine/image/framebuffer.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/gl.hpp"
#include "ui/window/gui_context.hpp"
#include "ui/window/window.hpp"

#include <glm/ext/vector_float2.hpp>
#include <glm/ext/vector_int2.hpp>

#include <condition_variable>
#include <expected>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::ui {

/// An OpenGL 3.3 core context that draws into memory; current on the thread that made it.
class OffscreenContext {
public:
    OffscreenContext() = default;
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    [[nodiscard]] virtual GlLoader loader() const = 0;
};

/// The context, or in a few words why there is none.
using OffscreenContextOr = std::expected<std::unique_ptr<OffscreenContext>, std::string>;
/// On the graphics card or Mesa's software renderer. Needs libEGL when it is called.
OffscreenContextOr make_egl_context(glm::ivec2 size_px);
/// On Mesa's software renderer. Needs libOSMesa when it is called.
OffscreenContextOr make_osmesa_context(glm::ivec2 size_px);

struct OffscreenOptions {
    int width = 1280;  ///< at scale 1
    int height = 800;
    float scale = 1.0F;  ///< pixels per design unit
};

/// A window that is not seen: what is drawn on it is read back.
class OffscreenWindow final : public Window {
public:
    /// `gui` belongs to `context`.
    OffscreenWindow(std::unique_ptr<OffscreenContext> context, std::unique_ptr<GuiContext> gui,
                    glm::ivec2 size_px, float scale);

    /// Sleeps while there was no wake() and all is laid out.
    void wait(std::optional<double> at_most_s) override;
    void wake() override;
    void begin_frame(Theme theme) override;
    void end_frame() override;
    [[nodiscard]] bool is_lost() const override { return false; }
    WindowEvents take_events() override { return {}; }
    void hold_keys(bool /*hold*/) override {}
    [[nodiscard]] WindowSize size() const override;
    [[nodiscard]] std::string portal_name() const override { return {}; }
    void set_title(const std::string& /*title*/) override {}

    /// The pointer's place in pixels, and whether its left button is down, from the next frame on.
    static void point(glm::vec2 at, bool pressed);
    /// The same for the right button.
    static void press_right(bool pressed);
    /// Turns the wheel before the next frame; notches, away from the hand above 0.
    static void turn_wheel(float notches);
    /// A key, in GLFW's numbers, is down from the next frame on, or up again.
    static void key(int key, bool pressed);
    static void hold_ctrl(bool pressed);
    static void hold_shift(bool pressed);
    static void hold_alt(bool pressed);
    /// Pixels per design unit from the next frame on.
    void set_scale(float scale) { scale_ = scale; }
    /// UTF-8 typed before the next frame.
    static void type(std::string_view text);
    /// The colours of the last frame; nothing else of the Framebuffer is set.
    [[nodiscard]] Framebuffer pixels() const;

private:
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<GuiContext> gui_;
    glm::ivec2 size_px_;
    float scale_;
    std::mutex mutex_;
    std::condition_variable woken_;
    bool changed_ = true;
    int frames_due_ = 0;
};

using OffscreenWindowOr = std::expected<std::unique_ptr<OffscreenWindow>, std::string>;
OffscreenWindowOr make_offscreen_window(const OffscreenOptions& options,
                                        OffscreenContextOr (*make_context)(glm::ivec2 size_px));
/// With EGL, else with OSMesa; or one line that says what both miss.
OffscreenWindowOr make_offscreen_window(const OffscreenOptions& options);

}  // namespace zeroset::ui
