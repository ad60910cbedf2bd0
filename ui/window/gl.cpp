#include "ui/window/gl.hpp"

#include <string_view>

namespace zeroset::ui {
namespace {

// Loader and functions of the current OpenGL context; only one is used at a time. Globals, because
// Dear ImGui's renderer has one global table of functions, too.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
GlLoader current_loader = nullptr;
Gl current;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

template <class Function>
bool find(const char* name, Function& function) {
    function = reinterpret_cast<Function>(current_loader(name));
    return function != nullptr;
}

}  // namespace

const Gl& gl() { return current; }

bool is_context_lost() {
    return current.reset_status != nullptr && current.reset_status() != GL_NO_ERROR;
}

bool load_gl(GlLoader loader) {
    current_loader = loader;
    if (!find("glGetGraphicsResetStatus", current.reset_status)) {
        find("glGetGraphicsResetStatusARB", current.reset_status);
    }
    return find("glBindTexture", current.bind_texture) && find("glClear", current.clear) &&
           find("glClearColor", current.clear_color) &&
           find("glDeleteTextures", current.delete_textures) &&
           find("glGenTextures", current.gen_textures) &&
           find("glPixelStorei", current.pixel_store) &&
           find("glReadPixels", current.read_pixels) && find("glTexImage2D", current.tex_image) &&
           find("glTexParameteri", current.tex_parameter) &&
           find("glTexSubImage2D", current.tex_sub_image) && find("glViewport", current.viewport);
}

}  // namespace zeroset::ui

// Dear ImGui's renderer asks libGL for OpenGL's functions, whatever the context is; libGL knows
// nothing of OSMesa's. So the linker sends the program's calls of dlsym here (--wrap=dlsym in
// CMakeLists.txt), and a request for libGL's loader gets the loader of the current context. The
// linker prescribes the names.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
void* __real_dlsym(void* library, const char* name);
void* __wrap_dlsym(void* library, const char* name);

// Not instrumented: a sanitizer calls this function before its own setup is complete.
#if __has_cpp_attribute(clang::disable_sanitizer_instrumentation)
[[clang::disable_sanitizer_instrumentation]]
#endif
void* __wrap_dlsym(void* library, const char* name) {
    if (zeroset::ui::current_loader != nullptr &&
        std::string_view(name) == "glXGetProcAddressARB") {
        return reinterpret_cast<void*>(zeroset::ui::current_loader);
    }
    return __real_dlsym(library, name);
}
}
// NOLINTEND(readability-identifier-naming)
