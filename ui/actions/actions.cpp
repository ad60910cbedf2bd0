#include "ui/actions/actions.hpp"

#include "engine/base/translation.hpp"
#include "ui/actions/action_parts.hpp"
#include "ui/widgets/chord.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

namespace zeroset::ui {

std::span<const Action> actions() {
    static const std::vector<Action> all = [] {
        std::vector<Action> joined;
        for (const auto part :
             {picture_actions(), view_actions(), document_actions(), window_actions()})
            joined.insert(joined.end(), part.begin(), part.end());
        return joined;
    }();
    return all;
}

const Action& action_named(std::string_view name) {
    const auto found = std::ranges::find(actions(), name, &Action::name);
    assert(found != actions().end());
    return *found;
}

bool is_enabled(const Action& action, const UiState& state) {
    const bool is_for_readers =
        action.for_readers || std::string_view(action.section) == section::view;
    if (state.edited.read_only && !is_for_readers) return false;
    return action.enabled == nullptr || action.enabled(state);
}

std::string shown_keys(const Action& action) {
    const std::string keys = action.keys;
    return keys_in_language(keys.substr(0, keys.find(", ")));
}

std::string described(const Action& action) {
    const std::string keys = shown_keys(action);
    return keys.empty() ? tr(action.name) : tr(action.name) + (" (" + keys + ")");
}

}  // namespace zeroset::ui
