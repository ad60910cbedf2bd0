#include "ui/window/gl.hpp"

#include "engine/base/module.hpp"
#include "ui/window/gl_module.hpp"

namespace zeroset::ui {
namespace {

// Loader and functions of the current OpenGL context; only one is used at a time. Globals, because
// Dear ImGui's renderer has one global table of functions, too.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
GlLoader current_loader = nullptr;
Gl current;
SetGlLoader tell_renderer = nullptr;  // off screen
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

std::expected<void, std::string> stand_in_for_libgl() {
    if (tell_renderer != nullptr) return {};
    const auto function = load_module(gl_module_file, gl_module_function);
    if (!function) return std::unexpected(function.error());
    tell_renderer = reinterpret_cast<SetGlLoader>(*function);
    return {};
}

bool load_gl(GlLoader loader) {
    current_loader = loader;
    if (tell_renderer != nullptr) tell_renderer(loader);
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
