#include "app/desktop/volume_permission.hpp"

#include "engine/base/translation.hpp"

namespace zeroset {

std::optional<std::string> VolumePermission::question() {
    if (!waiting_.empty()) return std::nullopt;
    std::string names;
    for (const std::filesystem::path& file : files_->take_refused()) {
        if (!asked_.insert(file).second) continue;
        waiting_.push_back(file);
        names += (names.empty() ? "" : "\n") + file.string();
    }
    if (waiting_.empty()) return std::nullopt;
    return filled(tr("The document wants to read what lies outside its folder:\n\n{0}"), {names});
}

void VolumePermission::answer(bool allow) {
    for (const std::filesystem::path& file : waiting_) {
        if (allow) files_->allow(file);
    }
    waiting_.clear();
}

void VolumePermission::forget() {
    files_->take_refused();
    asked_.clear();
    waiting_.clear();
}

}  // namespace zeroset
