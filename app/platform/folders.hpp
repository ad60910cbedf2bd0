#pragma once

#include <filesystem>
#include <optional>

namespace zeroset {

// The program's folders as the XDG Base Directory Specification has them; nothing without a home.
// They need not exist.

/// What outlives a session: recent files, the document against a crash. $XDG_STATE_HOME/zeroset, by
/// default ~/.local/state/zeroset.
std::optional<std::filesystem::path> state_folder();

/// What can be made anew. $XDG_CACHE_HOME/zeroset, by default ~/.cache/zeroset.
std::optional<std::filesystem::path> cache_folder();

/// What the user has chosen. $XDG_CONFIG_HOME/zeroset, by default ~/.config/zeroset.
std::optional<std::filesystem::path> config_folder();

}  // namespace zeroset
