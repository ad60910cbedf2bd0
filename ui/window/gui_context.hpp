#pragma once

#include "ui/model/theme.hpp"
#include "ui/window/gl.hpp"
#include "ui/window/navigation.hpp"

namespace zeroset::ui {

/// The Dear ImGui context with its OpenGL renderer, our fonts and our theme. An OpenGL 3.3 context
/// must be current during its whole life. At most one exists at a time, on the window's thread.
class GuiContext {
public:
    /// `loader` belongs to the current OpenGL context.
    explicit GuiContext(GlLoader loader);
    ~GuiContext();
    GuiContext(const GuiContext&) = delete;
    GuiContext& operator=(const GuiContext&) = delete;

    /// False if OpenGL's functions could not be loaded; the object must not be used then.
    [[nodiscard]] bool ready() const { return ready_; }

    /// Begins a frame; rebuilds fonts and style when an argument changed.
    ///   content_scale     framebuffer pixels per design unit
    ///   pixels_per_point  framebuffer pixels per unit of the window's coordinates
    void begin_frame(Theme theme, float content_scale, float pixels_per_point);
    /// Gives the frame's input to the panels, which may be drawn then.
    void begin_panels();
    /// Ends the frame: what it draws is known now, until the next begins.
    static void end_frame();
    /// Draws the frame that ended last into the current framebuffer.
    static void rasterize(int width_px, int height_px);

    /// The content scale for letters of this size, as far as the least window fits into this one:
    /// never less than `content_scale`, unless letters are to be smaller.
    [[nodiscard]] static float scale_of_letters(float content_scale, float letters, int width_px,
                                                int height_px);

    /// True while a text field has the keyboard.
    [[nodiscard]] static bool wants_text();

private:
    struct Style {
        Theme theme = Theme::Dark;
        float content_scale = 0.0F;
        float pixels_per_point = 0.0F;
        bool operator==(const Style&) const = default;
    };
    Style style_;
    Navigation navigation_;
    bool ready_ = false;
};

}  // namespace zeroset::ui
