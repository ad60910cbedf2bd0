#include "ui/window/gl_module.hpp"

namespace zeroset::ui {
namespace {

GlLoader current_loader = nullptr;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace
}  // namespace zeroset::ui

// The names are prescribed: by gl_module_function, and by what asks libGL.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
[[gnu::visibility("default")]] void zeroset_set_gl_loader(zeroset::ui::GlLoader loader);
[[gnu::visibility("default")]] zeroset::ui::GlFunction glXGetProcAddressARB(
    const unsigned char* name);

void zeroset_set_gl_loader(zeroset::ui::GlLoader loader) { zeroset::ui::current_loader = loader; }

zeroset::ui::GlFunction glXGetProcAddressARB(const unsigned char* name) {
    return zeroset::ui::current_loader(reinterpret_cast<const char*>(name));
}
}
// NOLINTEND(readability-identifier-naming)
