#pragma once

#include <GL/gl.h>

#include <expected>
#include <string>

namespace zeroset::ui {

using GlFunction = void (*)();
/// Returns an OpenGL function of the current context; nullptr if the context lacks it.
using GlLoader = GlFunction (*)(const char* name);

/// The OpenGL functions that this program calls. Nothing is linked against an OpenGL library: every
/// kind of context brings its own.
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
    /// glGetGraphicsResetStatus; nullptr if the driver does not offer it.
    GLenum (*reset_status)() = nullptr;
};

/// Functions of the context for which load_gl() was last called.
const Gl& gl();

/// True if the driver reports that the current context is lost.
bool is_context_lost();

/// Lets Dear ImGui's renderer ask the loaders of contexts from now on, in place of libGL
/// (gl_module.hpp). For contexts off screen, before the first GuiContext of the process; the error
/// says what is missing.
std::expected<void, std::string> stand_in_for_libgl();

/// Fills gl(), and tells Dear ImGui's renderer after stand_in_for_libgl(). Returns false if a
/// function is missing. Called by GuiContext.
bool load_gl(GlLoader loader);

}  // namespace zeroset::ui
