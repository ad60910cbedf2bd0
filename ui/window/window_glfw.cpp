#include "ui/model/theme.hpp"
#include "ui/window/full_screen.hpp"
#include "ui/window/gl.hpp"
#include "ui/window/glfw_handle.hpp"
#include "ui/window/gui_context.hpp"
#include "ui/window/input_queue.hpp"
#include "ui/window/pinch.hpp"
#include "ui/window/window.hpp"

#include <GLFW/glfw3.h>
#include <glm/ext/vector_double2.hpp>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace zeroset::ui {
namespace {

constexpr double cursor_blink_s = 0.5;
constexpr int mouse_buttons = 5;  ///< as many as Dear ImGui knows

class GlfwWindow final : public Window {
public:
    GlfwWindow(std::unique_ptr<GlfwLibrary> library, WindowHandle handle,
               std::unique_ptr<GuiContext> gui, const WindowSize& size);
    ~GlfwWindow() override { ImGui_ImplGlfw_Shutdown(); }
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    void wait(std::optional<double> at_most_s) override;
    void wake() override;
    void begin_frame(Theme theme) override;
    void end_frame() override;
    [[nodiscard]] bool is_lost() const override { return lost_; }
    WindowEvents take_events() override;
    void hold_keys(bool hold) override { holds_keys_ = hold; }
    [[nodiscard]] WindowSize size() const override;
    [[nodiscard]] std::string portal_name() const override;
    void set_letters(float size) override { letters_ = size; }
    bool set_full_screen(bool on) override;
    void set_title(const std::string& title) override;

private:
    static GlfwWindow& of(GLFWwindow* handle) {
        GlfwWindow& window = *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(handle));
        window.changed_ = true;
        return window;
    }
    /// Returns the window; records the event if it is the first input since take_events().
    static GlfwWindow& of(GLFWwindow* handle, InputEvent::Kind kind) {
        GlfwWindow& window = of(handle);
        if (!window.events_.input) {
            window.events_.input = InputEvent{.kind = kind, .at = std::chrono::steady_clock::now()};
        }
        return window;
    }
    static void on_key(GLFWwindow* handle, int key, int scancode, int action, int mods);
    static void on_character(GLFWwindow* handle, unsigned int character);
    void install_callbacks();
    void feed_input();
    void feed(const QueuedEvent& event);
    void place_mouse() const;
    void limit_size();
    [[nodiscard]] float content_scale() const;

    std::unique_ptr<GlfwLibrary> library_;
    WindowHandle handle_;
    WindowSize restored_;  ///< the last size that was not maximized, nor the full screen's
    FullScreen full_screen_;
    float letters_ = 1.0F;
    std::unique_ptr<GuiContext> gui_;
    InputQueue queue_;
    std::optional<glm::dvec2> pointer_;       ///< as of the queue; nothing: to be asked for
    std::array<bool, mouse_buttons> held_{};  ///< the buttons that are down, as of the queue
    std::string title_;
    WindowEvents events_;
    bool holds_keys_ = false;
    bool lost_ = false;
    float limited_scale_ = 0.0F;  ///< content scale for which the least size was last set
    std::atomic<bool> changed_{true};
    int frames_due_ = 0;
    std::unique_ptr<PinchListener> pinches_;  ///< nullptr: not on X11; it wakes the window
};

GlfwWindow::GlfwWindow(std::unique_ptr<GlfwLibrary> library, WindowHandle handle,
                       std::unique_ptr<GuiContext> gui, const WindowSize& size)
    : library_(std::move(library)),
      handle_(std::move(handle)),
      restored_(size),
      gui_(std::move(gui)) {
    glfwSwapInterval(1);
    ImGui_ImplGlfw_InitForOpenGL(handle_.get(), false);
    glfwSetWindowUserPointer(handle_.get(), this);
    install_callbacks();
    if (const auto id = x11_window(handle_.get()); id != 0)
        pinches_ = std::make_unique<PinchListener>(id, [this] { wake(); });
}

/// Sets the least size, which is the same in design units on every screen.
void GlfwWindow::limit_size() {
    const float scale = content_scale();
    if (scale == limited_scale_) return;
    limited_scale_ = scale;
    const auto scaled = [scale](int length) {
        return static_cast<int>(static_cast<float>(length) * scale);
    };
    glfwSetWindowSizeLimits(handle_.get(), scaled(min_width), scaled(min_height), GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
}

void GlfwWindow::install_callbacks() {
    GLFWwindow* handle = handle_.get();
    glfwSetKeyCallback(handle, on_key);
    glfwSetCharCallback(handle, on_character);
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* window, int button, int action, int) {
        if (button >= mouse_buttons) return;
        of(window, InputEvent::Kind::Button)
            .queue_.push(MouseButton{.button = button, .pressed = action == GLFW_PRESS});
    });
    glfwSetScrollCallback(handle, [](GLFWwindow* window, double x, double y) {
        of(window, InputEvent::Kind::Wheel).queue_.push(MouseWheel{.by = {x, y}});
    });
    glfwSetCursorEnterCallback(handle, [](GLFWwindow* window, int entered) {
        of(window).queue_.push(MouseMove{});
        ImGui_ImplGlfw_CursorEnterCallback(window, entered);
    });
    glfwSetWindowFocusCallback(handle, [](GLFWwindow* window, int focused) {
        of(window);
        ImGui_ImplGlfw_WindowFocusCallback(window, focused);
    });
    glfwSetCursorPosCallback(handle, [](GLFWwindow* window, double x, double y) {
        of(window, InputEvent::Kind::Move).queue_.push(MouseMove{.at = glm::dvec2(x, y)});
    });
    glfwSetWindowCloseCallback(handle, [](GLFWwindow* window) {
        glfwSetWindowShouldClose(window, GLFW_FALSE);
        of(window).events_.close = true;
    });
    glfwSetDropCallback(handle, [](GLFWwindow* window, int count, const char** paths) {
        of(window).events_.dropped.assign(paths, paths + count);
    });
    glfwSetWindowRefreshCallback(handle, [](GLFWwindow* window) { of(window); });
    glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* window, int, int) { of(window); });
    glfwSetWindowContentScaleCallback(handle, [](GLFWwindow* window, float, float) { of(window); });
}

/// Numbers the keys of letters, of + and of - by what they type, not by their position: keyboard
/// layouts differ.
int key_of(int key, int scancode) {
    const char* const name = glfwGetKeyName(key, scancode);
    const bool letter = name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0';
    const bool sign = name != nullptr && (name[0] == '+' || name[0] == '-') && name[1] == '\0';
    return letter ? GLFW_KEY_A + (name[0] - 'a') : sign ? name[0] : key;
}

void GlfwWindow::on_key(GLFWwindow* handle, int key, int scancode, int action, int mods) {
    of(handle, InputEvent::Kind::Key)
        .queue_.push(KeyEvent{.key = key_of(key, scancode),
                              .scancode = scancode,
                              .action = action,
                              .mods = mods,
                              .character = 0});
}

void GlfwWindow::on_character(GLFWwindow* handle, unsigned int character) {
    of(handle, InputEvent::Kind::Key)
        .queue_.push(
            KeyEvent{.key = 0, .scancode = 0, .action = 0, .mods = 0, .character = character});
}

void GlfwWindow::feed(const QueuedEvent& event) {
    if (const auto* const key = std::get_if<KeyEvent>(&event)) {
        if (key->character != 0) {
            ImGui_ImplGlfw_CharCallback(handle_.get(), key->character);
        } else {
            ImGui_ImplGlfw_KeyCallback(handle_.get(), key->key, key->scancode, key->action,
                                       key->mods);
        }
    } else if (const auto* const move = std::get_if<MouseMove>(&event)) {
        pointer_ = move->at;
    } else if (const auto* const mouse = std::get_if<MouseButton>(&event)) {
        held_.at(static_cast<std::size_t>(mouse->button)) = mouse->pressed;
    } else if (const auto* const wheel = std::get_if<MouseWheel>(&event)) {
        ImGui_ImplGlfw_ScrollCallback(handle_.get(), wheel->by.x, wheel->by.y);
    }
}

void GlfwWindow::feed_input() {
    for (const QueuedEvent& event : queue_.take_frame(holds_keys_))
        feed(event);
    if (!queue_.empty()) frames_due_ = frames_to_settle;
}

/// Puts the pointer and its buttons where the queue has them: ImGui's backend has asked for both as
/// they are now.
void GlfwWindow::place_mouse() const {
    ImGuiIO& io = ImGui::GetIO();
    if (pointer_ && ImGui::IsMousePosValid(&io.MousePos))
        io.MousePos = ImVec2(static_cast<float>(pointer_->x), static_cast<float>(pointer_->y));
    std::ranges::copy(held_, static_cast<bool*>(io.MouseDown));
}

void GlfwWindow::wait(std::optional<double> at_most_s) {
    if (GuiContext::wants_text()) {
        at_most_s = std::min(at_most_s.value_or(cursor_blink_s), cursor_blink_s);
    }
    if (frames_due_ > 0 || changed_ || (at_most_s && *at_most_s <= 0.0)) {
        glfwPollEvents();
    } else if (at_most_s) {
        glfwWaitEventsTimeout(*at_most_s);
    } else {
        glfwWaitEvents();
    }
    if (changed_.exchange(false)) {
        frames_due_ = frames_to_settle;
    } else {
        frames_due_ = std::max(frames_due_, 1);
    }
    --frames_due_;
}

WindowEvents GlfwWindow::take_events() {
    WindowEvents events = std::exchange(events_, {});
    if (pinches_ == nullptr) return events;
    events.pinch = pinches_->take();
    if (events.pinch != 1.0 && !events.input)
        events.input =
            InputEvent{.kind = InputEvent::Kind::Wheel, .at = std::chrono::steady_clock::now()};
    return events;
}

void GlfwWindow::wake() {
    changed_ = true;
    glfwPostEmptyEvent();
}

float GlfwWindow::content_scale() const {
    float scale = 1.0F;
    glfwGetWindowContentScale(handle_.get(), &scale, nullptr);
    return scale_override().value_or(std::clamp(scale, 1.0F, max_scale));
}

WindowSize GlfwWindow::size() const {
    WindowSize size = restored_;
    if (full_screen_.is_on()) return size;
    size.maximized = glfwGetWindowAttrib(handle_.get(), GLFW_MAXIMIZED) == GLFW_TRUE;
    if (size.maximized) return size;
    glfwGetWindowSize(handle_.get(), &size.width, &size.height);
    const auto at_scale_1 = [scale = content_scale()](int length) {
        return static_cast<int>(std::lround(static_cast<float>(length) / scale));
    };
    return {.width = at_scale_1(size.width), .height = at_scale_1(size.height), .maximized = false};
}

bool GlfwWindow::set_full_screen(bool on) {
    if (on == full_screen_.is_on()) return on;
    GLFWwindow* const handle = handle_.get();
    changed_ = true;
    if (on) {
        restored_ = size();
        full_screen_.enter(handle);
    } else {
        full_screen_.leave(handle);
        if (restored_.maximized) glfwMaximizeWindow(handle);
    }
    return full_screen_.is_on();
}

void GlfwWindow::begin_frame(Theme theme) {
    restored_ = size();
    limit_size();
    int width_px = 0;
    int height_px = 0;
    int width_points = 0;
    int ignored = 0;
    glfwGetFramebufferSize(handle_.get(), &width_px, &height_px);
    glfwGetWindowSize(handle_.get(), &width_points, &ignored);
    const bool visible = width_px > 0 && width_points > 0;
    const float pixels_per_point =
        visible ? static_cast<float>(width_px) / static_cast<float>(width_points) : 1.0F;

    feed_input();
    const float scale =
        GuiContext::scale_of_letters(content_scale(), letters_, width_px, height_px);
    gui_->begin_frame(theme, scale, pixels_per_point);
    ImGui_ImplGlfw_NewFrame();
    place_mouse();
    gui_->begin_panels();
}

void GlfwWindow::end_frame() {
    int width_px = 0;
    int height_px = 0;
    glfwGetFramebufferSize(handle_.get(), &width_px, &height_px);
    GuiContext::end_frame();
    GuiContext::rasterize(width_px, height_px);
    glfwSwapBuffers(handle_.get());
    lost_ = is_context_lost();
}

/// Returns the X11 id. A Wayland surface would have to be exported through xdg-foreign, by requests
/// that GLFW does not make.
std::string GlfwWindow::portal_name() const {
    const std::uint32_t id = x11_window(handle_.get());
    if (id == 0) return {};
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), id, 16).ptr;
    return "x11:" + std::string(digits.data(), end);
}

void GlfwWindow::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(handle_.get(), title.c_str());
}

}  // namespace

std::expected<std::unique_ptr<Window>, std::string> make_glfw_window(const WindowOptions& options) {
    auto library = std::make_unique<GlfwLibrary>();
    if (!*library) return std::unexpected("no display: " + glfw_reason());
    WindowHandle handle = open_window(options);
    if (handle == nullptr) return std::unexpected("no OpenGL 3.3: " + glfw_reason());
    glfwMakeContextCurrent(handle.get());
    auto gui = std::make_unique<GuiContext>(glfwGetProcAddress);
    if (!gui->ready()) return std::unexpected("no OpenGL 3.3: libGL.so.1 cannot be used");
    return std::make_unique<GlfwWindow>(std::move(library), std::move(handle), std::move(gui),
                                        options.size);
}

}  // namespace zeroset::ui
