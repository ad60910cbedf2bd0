#include "document/views.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>

namespace zeroset {

const SavedView* find_view(const std::vector<SavedView>& views, std::string_view name) {
    const auto found = std::ranges::find(views, name, &SavedView::name);
    return found == views.end() ? nullptr : &*found;
}

const char* name_defect(std::string_view name) {
    if (trimmed(name).empty()) return tr("it is empty");
    if (name != trimmed(name)) return tr("it has blanks at its ends");
    if (name.size() > longest_view_name) return tr("it is longer than 100 bytes");
    const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < 0x20U; };
    return std::ranges::any_of(name, is_control) ? tr("it is more than a line") : nullptr;
}

std::string add_view(std::vector<SavedView>& views, const Camera& camera) {
    if (views.size() >= most_views) return {};
    for (std::size_t number = 1;; ++number) {
        std::string name = filled(tr("View {0}"), {std::to_string(number)});
        if (find_view(views, name) != nullptr) continue;
        views.push_back({.name = name, .camera = camera});
        return name;
    }
}

bool rename_view(std::vector<SavedView>& views, std::size_t index, std::string_view name) {
    const std::string wanted(trimmed(name));
    if (name_defect(wanted) != nullptr || find_view(views, wanted) != nullptr) return false;
    views[index].name = wanted;
    return true;
}

std::string view_names(const std::vector<SavedView>& views) {
    std::string names;
    for (const SavedView& view : views)
        names += (names.empty() ? "" : ", ") + view.name;
    return names;
}

}  // namespace zeroset
