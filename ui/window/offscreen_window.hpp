#pragma once

#include "engine/image/framebuffer.hpp"
#include "ui/model/theme.hpp"
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

/// An OpenGL 3.3 core context that renders into memory; current on the thread that created it.
class OffscreenContext {
public:
    OffscreenContext() = default;
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    [[nodiscard]] virtual GlLoader loader() const = 0;
};

/// A context, or the reason in a few words why there is none.
using OffscreenContextOr = std::expected<std::unique_ptr<OffscreenContext>, std::string>;
/// Creates a context by EGL, on the graphics card or Mesa's software renderer. Opens libEGL.
OffscreenContextOr make_egl_context(glm::ivec2 size_px);
/// Creates a context by OSMesa, Mesa's software renderer. Opens libOSMesa.
OffscreenContextOr make_osmesa_context(glm::ivec2 size_px);

struct OffscreenOptions {
    int width = 1280;  ///< design units
    int height = 800;
    float scale = 1.0F;  ///< pixels per design unit
};

/// An invisible window; tests and screenshots read its pixels back.
class OffscreenWindow final : public Window {
public:
    /// `gui` was created for `context`.
    OffscreenWindow(std::unique_ptr<OffscreenContext> context, std::unique_ptr<GuiContext> gui,
                    glm::ivec2 size_px, float scale);

    /// Sleeps until wake() or `at_most_s` seconds, unless the layout still has to settle.
    void wait(std::optional<double> at_most_s) override;
    void wake() override;
    void begin_frame(Theme theme) override;
    void end_frame() override;
    [[nodiscard]] bool is_lost() const override { return false; }
    WindowEvents take_events() override { return {}; }
    void hold_keys(bool /*hold*/) override {}
    [[nodiscard]] WindowSize size() const override;
    [[nodiscard]] std::string portal_name() const override { return {}; }
    void set_letters(float size) override { letters_ = size; }
    bool set_full_screen(bool on) override { return on; }
    void set_title(const std::string& /*title*/) override {}

    /// Sets the pointer's position (pixels) and the left button's state from the next frame on.
    static void point(glm::vec2 at, bool pressed);
    /// Sets the state of the right button from the next frame on.
    static void press_right(bool pressed);
    /// Turns the wheel by `notches` before the next frame; positive is away from the user.
    static void turn_wheel(float notches);
    /// Sets whether a key (GLFW's number) is down from the next frame on.
    static void key(int key, bool pressed);
    static void hold_ctrl(bool pressed);
    static void hold_shift(bool pressed);
    static void hold_alt(bool pressed);
    /// Sets the pixels per design unit from the next frame on.
    void set_scale(float scale) { scale_ = scale; }
    /// Types UTF-8 text before the next frame.
    static void type(std::string_view text);
    /// Draws the frame that ended last and returns it; only its size and colours are set. Frames
    /// whose pixels nobody asks for are never drawn: what they would show is not needed to go on.
    [[nodiscard]] Framebuffer pixels() const;

private:
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<GuiContext> gui_;
    glm::ivec2 size_px_;
    float scale_;
    float letters_ = 1.0F;
    std::mutex mutex_;
    std::condition_variable woken_;
    bool changed_ = true;
    int frames_due_ = 0;
};

using OffscreenWindowOr = std::expected<std::unique_ptr<OffscreenWindow>, std::string>;
OffscreenWindowOr make_offscreen_window(const OffscreenOptions& options,
                                        OffscreenContextOr (*make_context)(glm::ivec2 size_px));
/// Creates a window by EGL or, if that fails, by OSMesa; else returns one line with both reasons.
OffscreenWindowOr make_offscreen_window(const OffscreenOptions& options);

}  // namespace zeroset::ui
