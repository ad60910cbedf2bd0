#include "app/platform/folders.hpp"

#include <cstdlib>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// Path in an environment variable; nothing unless it is absolute, as the specification demands.
std::optional<fs::path> folder_in(const char* variable) {
    const char* text = std::getenv(variable);
    if (text == nullptr || *text != '/') return std::nullopt;
    return fs::path(text);
}

std::optional<fs::path> program_folder(const char* variable, const char* below_home) {
    if (const auto folder = folder_in(variable)) return *folder / "zeroset";
    if (const auto home = folder_in("HOME")) return *home / below_home / "zeroset";
    return std::nullopt;
}

}  // namespace

std::optional<fs::path> state_folder() { return program_folder("XDG_STATE_HOME", ".local/state"); }

std::optional<fs::path> cache_folder() { return program_folder("XDG_CACHE_HOME", ".cache"); }

std::optional<fs::path> config_folder() { return program_folder("XDG_CONFIG_HOME", ".config"); }

}  // namespace zeroset
