#pragma once

#include <GL/gl.h>

namespace zeroset::ui {

using GlFunction = void (*)();
/// Finds a function of OpenGL for the current context; nullptr where it has none.
using GlLoader = GlFunction (*)(const char* name);

/// The functions of OpenGL that we call. Nothing is linked against an OpenGL library: every kind of
/// context brings its own.
struct Gl {
    decltype(&glBindTexture) bind_texture = nullptr;
    decltype(&glClear) clear = nullptr;
    decltype(&glClearColor) clear_color = nullptr;
    decltype(&glDeleteTextures) delete_textures = nullptr;
    decltype(&glGenTextures) gen_textures = nullptr;
    decltype(&glPixelStorei) pixel_store = nullptr;
    decltype(&glReadPixels) read_pixels = nullptr;
    decltype(&glTexImage2D) tex_image = nullptr;
    decltype(&glTexParameteri) tex_parameter = nullptr;
    decltype(&glTexSubImage2D) tex_sub_image = nullptr;
    decltype(&glViewport) viewport = nullptr;
    /// glGetGraphicsResetStatus; nullptr where the driver does not tell.
    GLenum (*reset_status)() = nullptr;
};

/// Those of the context that load_gl() was last called for.
const Gl& gl();

/// Whether the driver says that the current context is lost.
bool is_context_lost();

/// Fills gl(), and lets Dear ImGui's renderer take its functions from the same loader. False where
/// a function is missing. GuiContext calls it.
bool load_gl(GlLoader loader);

}  // namespace zeroset::ui
