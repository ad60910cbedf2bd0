#include "ui/window/gl.hpp"
#include "ui/window/offscreen_window.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <EGL/eglplatform.h>
#include <dlfcn.h>
#include <glm/ext/vector_int2.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <expected>
#include <memory>
#include <string>
#include <type_traits>

namespace zeroset::ui {
namespace {

/// The functions of EGL 1.5 that are used. The library is opened on first use, so that the program
/// starts without it. Neither it nor the display, one per process, is ever closed: drivers leave
/// threads and memory behind on closing.
struct Egl {
    decltype(&eglGetPlatformDisplay) get_platform_display = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bind_api = nullptr;
    decltype(&eglChooseConfig) choose_config = nullptr;
    decltype(&eglCreateContext) create_context = nullptr;
    decltype(&eglDestroyContext) destroy_context = nullptr;
    decltype(&eglCreatePbufferSurface) create_surface = nullptr;
    decltype(&eglDestroySurface) destroy_surface = nullptr;
    decltype(&eglMakeCurrent) make_current = nullptr;
    decltype(&eglGetError) get_error = nullptr;
    decltype(&eglGetProcAddress) get_proc_address = nullptr;

    /// Opens the library; the environment variable ZEROSET_EGL names another file. False if there
    /// is none.
    bool load();
};

bool Egl::load() {
    const char* const other = std::getenv("ZEROSET_EGL");
    const char* const file = other == nullptr ? "libEGL.so.1" : other;
    void* const library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) return false;
    const auto find = [library](const char* name, auto& function) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
        return function != nullptr;
    };
    return find("eglGetPlatformDisplay", get_platform_display) &&
           find("eglInitialize", initialize) && find("eglBindAPI", bind_api) &&
           find("eglChooseConfig", choose_config) && find("eglCreateContext", create_context) &&
           find("eglDestroyContext", destroy_context) &&
           find("eglCreatePbufferSurface", create_surface) &&
           find("eglDestroySurface", destroy_surface) && find("eglMakeCurrent", make_current) &&
           find("eglGetError", get_error) && find("eglGetProcAddress", get_proc_address);
}

class EglContext final : public OffscreenContext {
public:
    explicit EglContext(const Egl& egl) : egl_(egl) {}
    ~EglContext() override;
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// Creates the context and makes it current; false at the first step that fails.
    bool open(glm::ivec2 size_px);
    [[nodiscard]] GlLoader loader() const override { return egl_.get_proc_address; }

private:
    bool open_display();

    Egl egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
};

EglContext::~EglContext() {
    if (display_ == EGL_NO_DISPLAY) return;
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) egl_.destroy_context(display_, context_);
    if (surface_ != EGL_NO_SURFACE) egl_.destroy_surface(display_, surface_);
}

bool EglContext::open_display() {
    EGLDisplay display =
        egl_.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || egl_.initialize(display, nullptr, nullptr) == EGL_FALSE) {
        return false;
    }
    display_ = display;
    return true;
}

bool EglContext::open(glm::ivec2 size_px) {
    if (!open_display() || egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE) return false;
    constexpr std::array<EGLint, 11> wishes{EGL_SURFACE_TYPE,
                                            EGL_PBUFFER_BIT,
                                            EGL_RENDERABLE_TYPE,
                                            EGL_OPENGL_BIT,
                                            EGL_RED_SIZE,
                                            8,
                                            EGL_GREEN_SIZE,
                                            8,
                                            EGL_BLUE_SIZE,
                                            8,
                                            EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (egl_.choose_config(display_, wishes.data(), &config, 1, &found) == EGL_FALSE ||
        found == 0) {
        return false;
    }
    const std::array<EGLint, 5> size{EGL_WIDTH, size_px.x, EGL_HEIGHT, size_px.y, EGL_NONE};
    surface_ = egl_.create_surface(display_, config, size.data());
    if (surface_ == EGL_NO_SURFACE) return false;
    constexpr std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                            3,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            3,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
    context_ = egl_.create_context(display_, config, EGL_NO_CONTEXT, version.data());
    return context_ != EGL_NO_CONTEXT &&
           egl_.make_current(display_, surface_, surface_, context_) == EGL_TRUE;
}

std::string hexadecimal(EGLint code) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%04X", static_cast<unsigned int>(code));
    return text.data();
}

}  // namespace

OffscreenContextOr make_egl_context(glm::ivec2 size_px) {
    Egl egl;
    if (!egl.load()) return std::unexpected("no libEGL.so.1 of version 1.5");
    auto context = std::make_unique<EglContext>(egl);
    if (!context->open(size_px)) {
        return std::unexpected("no surfaceless context, error " + hexadecimal(egl.get_error()));
    }
    return context;
}

}  // namespace zeroset::ui
