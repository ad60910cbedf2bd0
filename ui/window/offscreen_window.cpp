#include "ui/window/offscreen_window.hpp"

#include "engine/image/framebuffer.hpp"
#include "ui/model/theme.hpp"
#include "ui/window/gl.hpp"
#include "ui/window/gui_context.hpp"
#include "ui/window/window.hpp"

#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <glm/ext/vector_float2.hpp>
#include <glm/ext/vector_int2.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <expected>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr float frame_s = 1.0F / 60.0F;

int scaled(int length, float scale) {
    return static_cast<int>(std::lround(static_cast<float>(length) * scale));
}

}  // namespace

OffscreenWindow::OffscreenWindow(std::unique_ptr<OffscreenContext> context,
                                 std::unique_ptr<GuiContext> gui, glm::ivec2 size_px, float scale)
    : context_(std::move(context)), gui_(std::move(gui)), size_px_(size_px), scale_(scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigInputTextCursorBlink = false;                  // pictures must not depend on time
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;  // no outline of the focused item
    io.KeyMap[ImGuiKey_Tab] = GLFW_KEY_TAB;
    io.KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
    io.KeyMap[ImGuiKey_Escape] = GLFW_KEY_ESCAPE;
    io.KeyMap[ImGuiKey_Space] = GLFW_KEY_SPACE;
    io.KeyMap[ImGuiKey_Home] = GLFW_KEY_HOME;
    io.KeyMap[ImGuiKey_End] = GLFW_KEY_END;
    io.KeyMap[ImGuiKey_LeftArrow] = GLFW_KEY_LEFT;
    io.KeyMap[ImGuiKey_RightArrow] = GLFW_KEY_RIGHT;
    io.KeyMap[ImGuiKey_PageUp] = GLFW_KEY_PAGE_UP;
    io.KeyMap[ImGuiKey_PageDown] = GLFW_KEY_PAGE_DOWN;
    io.KeyMap[ImGuiKey_UpArrow] = GLFW_KEY_UP;
    io.KeyMap[ImGuiKey_DownArrow] = GLFW_KEY_DOWN;
    io.KeyMap[ImGuiKey_Backspace] = GLFW_KEY_BACKSPACE;
    io.KeyMap[ImGuiKey_Delete] = GLFW_KEY_DELETE;
    io.KeyMap[ImGuiKey_A] = GLFW_KEY_A;
    io.KeyMap[ImGuiKey_V] = GLFW_KEY_V;
}

void OffscreenWindow::wait(std::optional<double> at_most_s) {
    std::unique_lock lock(mutex_);
    const auto is_woken = [this] { return changed_; };
    if (frames_due_ == 0 && at_most_s) {
        woken_.wait_for(lock, std::chrono::duration<double>(*at_most_s), is_woken);
    } else if (frames_due_ == 0) {
        woken_.wait(lock, is_woken);
    }
    frames_due_ = std::exchange(changed_, false) ? frames_to_settle : std::max(frames_due_, 1);
    --frames_due_;
}

void OffscreenWindow::wake() {
    {
        const std::scoped_lock lock(mutex_);
        changed_ = true;
    }
    woken_.notify_one();
}

void OffscreenWindow::begin_frame(Theme theme) {
    const float scale = GuiContext::scale_of_letters(scale_, letters_, size_px_.x, size_px_.y);
    gui_->begin_frame(theme, scale, 1.0F);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(size_px_.x), static_cast<float>(size_px_.y));
    io.DeltaTime = frame_s;
    gui_->begin_panels();
}

void OffscreenWindow::end_frame() { GuiContext::end_frame(); }

WindowSize OffscreenWindow::size() const {
    return {.width = scaled(size_px_.x, 1.0F / scale_),
            .height = scaled(size_px_.y, 1.0F / scale_)};
}

void OffscreenWindow::point(glm::vec2 at, bool pressed) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(at.x, at.y);
    io.MouseDown[ImGuiMouseButton_Left] = pressed;
}

void OffscreenWindow::press_right(bool pressed) {
    ImGui::GetIO().MouseDown[ImGuiMouseButton_Right] = pressed;
}

void OffscreenWindow::key(int key, bool pressed) { ImGui::GetIO().KeysDown[key] = pressed; }

void OffscreenWindow::hold_ctrl(bool pressed) { ImGui::GetIO().KeyCtrl = pressed; }

void OffscreenWindow::turn_wheel(float notches) { ImGui::GetIO().MouseWheel += notches; }

void OffscreenWindow::hold_shift(bool pressed) { ImGui::GetIO().KeyShift = pressed; }

void OffscreenWindow::hold_alt(bool pressed) { ImGui::GetIO().KeyAlt = pressed; }

void OffscreenWindow::type(std::string_view text) {
    ImGui::GetIO().AddInputCharactersUTF8(std::string(text).c_str());
}

Framebuffer OffscreenWindow::pixels() const {
    Framebuffer frame(size_px_.x, size_px_.y);
    GuiContext::rasterize(frame.width, frame.height);
    gl().pixel_store(GL_PACK_ALIGNMENT, 4);
    gl().read_pixels(0, 0, frame.width, frame.height, GL_RGBA, GL_UNSIGNED_BYTE,
                     frame.color.data());
    // OpenGL stores rows from bottom to top.
    for (int top = 0, bottom = frame.height - 1; top < bottom; ++top, --bottom) {
        auto* const row = frame.color.data() + frame.index(0, top);
        std::swap_ranges(row, row + frame.width, frame.color.data() + frame.index(0, bottom));
    }
    return frame;
}

OffscreenWindowOr make_offscreen_window(const OffscreenOptions& options,
                                        OffscreenContextOr (*make_context)(glm::ivec2 size_px)) {
    const glm::ivec2 size_px(scaled(options.width, options.scale),
                             scaled(options.height, options.scale));
    auto context = make_context(size_px);
    if (!context) return std::unexpected(context.error());
    if (const auto found = stand_in_for_libgl(); !found) return std::unexpected(found.error());
    auto gui = std::make_unique<GuiContext>((*context)->loader());
    if (!gui->ready()) return std::unexpected("its OpenGL cannot be used");
    return std::make_unique<OffscreenWindow>(std::move(*context), std::move(gui), size_px,
                                             options.scale);
}

OffscreenWindowOr make_offscreen_window(const OffscreenOptions& options) {
    auto window = make_offscreen_window(options, make_egl_context);
    if (window) return window;
    auto fallback = make_offscreen_window(options, make_osmesa_context);
    if (fallback) return fallback;
    return std::unexpected("no OpenGL 3.3 without a display (EGL: " + window.error() +
                           "; OSMesa: " + fallback.error() + ")");
}

}  // namespace zeroset::ui
