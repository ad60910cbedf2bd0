#pragma once

#include <filesystem>
#include <optional>

namespace zeroset {

// The program's folders by the XDG Base Directory Specification; nothing without a home. They need
// not exist.

/// Folder of state that outlives a session: recent files, the document for recovery after a crash.
/// $XDG_STATE_HOME/zeroset, by default ~/.local/state/zeroset.
std::optional<std::filesystem::path> state_folder();

/// Folder of files that can be recreated. $XDG_CACHE_HOME/zeroset, by default ~/.cache/zeroset.
std::optional<std::filesystem::path> cache_folder();

/// Folder of the user's settings. $XDG_CONFIG_HOME/zeroset, by default ~/.config/zeroset.
std::optional<std::filesystem::path> config_folder();

}  // namespace zeroset
