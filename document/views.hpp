#pragma once

#include "engine/view/camera.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// The cameras that a document keeps under names.

namespace zeroset {

struct SavedView {
    std::string name;  ///< a line of UTF-8 without blanks at its ends; unique in a document
    Camera camera;

    bool operator==(const SavedView&) const = default;
};

inline constexpr std::size_t most_views = 1000;
inline constexpr std::size_t longest_view_name = 100;  ///< bytes

/// The view of this name, or nullptr.
const SavedView* find_view(const std::vector<SavedView>& views, std::string_view name);

/// Why a view cannot be called so, as a clause: "it is empty"; or nullptr where it can, if no other
/// has the name.
const char* name_defect(std::string_view name);

/// Keeps a camera under the first free name of "View 1", "View 2", ... and returns the name; empty,
/// and no view, where there are most_views.
std::string add_view(std::vector<SavedView>& views, const Camera& camera);

/// Gives a view another name, without the blanks at its ends. False, and nothing changed, where the
/// name has a defect or is another view's.
bool rename_view(std::vector<SavedView>& views, std::size_t index, std::string_view name);

/// The names as "one, two", in order.
std::string view_names(const std::vector<SavedView>& views);

}  // namespace zeroset
