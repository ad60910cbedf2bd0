#include "app/desktop/volume_permission.hpp"

#include "engine/base/translation.hpp"
#include "pipeline/volume_source.hpp"

namespace zeroset {

std::optional<std::string> VolumePermission::question() {
    if (!waiting_.empty()) return std::nullopt;
    std::string names;
    for (const std::filesystem::path& file : take_refused_volumes()) {
        if (!asked_.insert(file).second) continue;
        waiting_.push_back(file);
        names += (names.empty() ? "" : "\n") + file.string();
    }
    if (waiting_.empty()) return std::nullopt;
    return filled(tr("The document wants to read what lies outside its folder:\n\n{0}"), {names});
}

void VolumePermission::answer(bool allow) {
    for (const std::filesystem::path& file : waiting_) {
        if (allow) allow_volume(file);
    }
    waiting_.clear();
}

void VolumePermission::forget() {
    take_refused_volumes();
    asked_.clear();
    waiting_.clear();
}

}  // namespace zeroset
