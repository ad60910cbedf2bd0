#include "ui/window/gl.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GL/gl.h>
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <glm/ext/vector_int2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <type_traits>
#include <vector>

namespace zeroset::ui {
namespace {

/// The functions of OSMesa that are used, opened at run time like EGL's. RTLD_LOCAL separates its
/// OpenGL functions from those of libGL with the same names.
struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
    decltype(&OSMesaDestroyContext) destroy_context = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetProcAddress) get_proc_address = nullptr;

    /// Opens the library; false if there is none.
    bool load();
};

bool OsMesa::load() {
    void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) return false;
    const auto find = [library](const char* name, auto& function) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
        return function != nullptr;
    };
    return find("OSMesaCreateContextAttribs", create_context) &&
           find("OSMesaDestroyContext", destroy_context) &&
           find("OSMesaMakeCurrent", make_current) &&
           find("OSMesaGetProcAddress", get_proc_address);
}

class OsMesaContext final : public OffscreenContext {
public:
    explicit OsMesaContext(const OsMesa& osmesa) : osmesa_(osmesa) {}
    ~OsMesaContext() override {
        if (context_ == nullptr) return;
        osmesa_.make_current(nullptr, nullptr, 0, 0, 0);
        osmesa_.destroy_context(context_);
    }
    OsMesaContext(const OsMesaContext&) = delete;
    OsMesaContext& operator=(const OsMesaContext&) = delete;

    bool open(glm::ivec2 size_px);
    [[nodiscard]] GlLoader loader() const override { return osmesa_.get_proc_address; }

private:
    OsMesa osmesa_;
    OSMesaContext context_ = nullptr;
    std::vector<std::uint32_t> pixels_;
};

bool OsMesaContext::open(glm::ivec2 size_px) {
    constexpr std::array<int, 9> wishes{OSMESA_FORMAT,
                                        OSMESA_RGBA,
                                        OSMESA_PROFILE,
                                        OSMESA_CORE_PROFILE,
                                        OSMESA_CONTEXT_MAJOR_VERSION,
                                        3,
                                        OSMESA_CONTEXT_MINOR_VERSION,
                                        3,
                                        0};
    context_ = osmesa_.create_context(wishes.data(), nullptr);
    if (context_ == nullptr) return false;
    pixels_.resize(static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y));
    return osmesa_.make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, size_px.x, size_px.y) ==
           GL_TRUE;
}

}  // namespace

OffscreenContextOr make_osmesa_context(glm::ivec2 size_px) {
    OsMesa osmesa;
    if (!osmesa.load()) return std::unexpected("no libOSMesa.so.8");
    auto context = std::make_unique<OsMesaContext>(osmesa);
    if (!context->open(size_px)) return std::unexpected("it makes no context of this size");
    return context;
}

}  // namespace zeroset::ui
