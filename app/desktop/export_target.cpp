#include "app/desktop/export_target.hpp"

#include <cstddef>
#include <filesystem>
#include <system_error>

namespace zeroset {
namespace {

/// A link that leads nowhere is there, too.
bool is_there(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::symlink_status(path, error).type() !=
           std::filesystem::file_type::not_found;
}

}  // namespace

std::string unused_file(const std::string& folder, const std::string& name,
                        const std::string& ending) {
    constexpr int most = 10'000;
    for (int number = 1; number < most; ++number) {
        const std::string suffix = number == 1 ? "" : "-" + std::to_string(number);
        const std::filesystem::path path = std::filesystem::path(folder) / (name + suffix + ending);
        if (!is_there(path)) return path.string();
    }
    return {};
}

void ExportTarget::follow(ui::UiState& state, const std::string& folder, const std::string& name) {
    const ui::ExportPage& page = state.pages.exports;
    const std::string& ending = page.endings.at(static_cast<std::size_t>(page.wish.kind));
    std::string& target = state.shown.export_target;
    const bool saving = !state.shown.export_progress.name.empty();
    // Numbered pictures are many files: their name is asked for.
    Proposal now;
    if (page.open && ending.starts_with('.') && !saving)
        now = {.folder = folder, .name = name, .ending = ending};
    // Another program may have made a file of that name since.
    if (now == last_ && (target.empty() || !is_there(target))) return;
    last_ = now;
    const bool wished = !target.empty() && state.wishes.export_path == target;
    target = now.ending.empty() ? "" : unused_file(now.folder, now.name, now.ending);
    if (wished && !target.empty()) state.wishes.export_path = target;
}

}  // namespace zeroset
