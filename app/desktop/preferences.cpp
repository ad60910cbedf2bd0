#include "app/desktop/preferences.hpp"

#include "engine/export/file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace zeroset {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* file_name = "window.json";
constexpr float widest_em = 200.0F;
constexpr int largest_side = 32768;

/// The layout's switches, with their names in the file.
constexpr std::array<std::pair<const char*, bool ui::Layout::*>, 17> switches{
    {{"folded", &ui::Layout::folded},
     {"view_open", &ui::Layout::view_open},
     {"camera_open", &ui::Layout::camera_open},
     {"look_open", &ui::Layout::look_open},
     {"light_open", &ui::Layout::light_open},
     {"markers_open", &ui::Layout::markers_open},
     {"space_open", &ui::Layout::space_open},
     {"clip_open", &ui::Layout::clip_open},
     {"details_open", &ui::Layout::details_open},
     {"advanced_open", &ui::Layout::advanced_open},
     {"edges_open", &ui::Layout::edges_open},
     {"handles", &ui::Layout::handles},
     {"axes", &ui::Layout::axes},
     {"clip_box", &ui::Layout::clip_box},
     {"grid", &ui::Layout::grid},
     {"smooth_edges", &ui::Layout::smooth_edges},
     {"begins_with_last", &ui::Layout::begins_with_last}}};

/// The enum's value of which the file has the name, as `named` reads it.
template <class Enum>
std::optional<Enum> enum_in(const json& file, const char* name,
                            std::optional<Enum> (*named)(std::string_view)) {
    const json value = file.value(name, json());
    return value.is_string() ? named(value.get<std::string>()) : std::nullopt;
}

bool flag_in(const json& file, const char* name, bool usual) {
    const json value = file.value(name, json());
    return value.is_boolean() ? value.get<bool>() : usual;
}

double number_in(const json& file, const char* name, double lo, double hi, double usual) {
    const json value = file.value(name, json());
    if (!value.is_number()) return usual;
    const double number = value.get<double>();
    return number >= lo && number <= hi ? number : usual;
}

json read(const fs::path& path) {
    std::ifstream file(path);
    json read = json::parse(file, nullptr, false);
    if (!read.is_object()) read = json::object();
    return read;
}

}  // namespace

Preferences load_preferences(const fs::path& folder) {
    const json file = read(folder / file_name);
    Preferences result;
    ui::Layout& layout = result.layout;
    layout.panel_em = static_cast<float>(
        number_in(file, "panel_em", 1.0, widest_em, static_cast<double>(layout.panel_em)));
    layout.letters =
        static_cast<float>(number_in(file, "letters", static_cast<double>(ui::letter_sizes.front()),
                                     static_cast<double>(ui::letter_sizes.back()), 1.0));
    for (const auto& [name, flag] : switches)
        layout.*flag = flag_in(file, name, layout.*flag);
    layout.wheel = enum_in(file, "wheel", ui::wheel_use_named).value_or(layout.wheel);
    layout.language = enum_in(file, "language", language_named);
    result.theme = enum_in(file, "theme", ui::theme_named);
    result.last_theme = enum_in(file, "last_theme", ui::theme_named).value_or(result.last_theme);
    ui::WindowSize& window = result.window;
    window.width =
        static_cast<int>(number_in(file, "width", ui::min_width, largest_side, window.width));
    window.height =
        static_cast<int>(number_in(file, "height", ui::min_height, largest_side, window.height));
    window.maximized = flag_in(file, "maximized", window.maximized);
    // Who has a file knows the window.
    result.tour_seen = flag_in(file, "tour_seen", !file.empty());
    return result;
}

void save_preferences(const fs::path& folder, const Preferences& preferences) {
    const ui::WindowSize& window = preferences.window;
    nlohmann::ordered_json file{
        {"theme", preferences.theme ? name_of(*preferences.theme) : "desktop"},
        {"last_theme", name_of(preferences.last_theme)},
        {"width", window.width},
        {"height", window.height},
        {"maximized", window.maximized},
        {"tour_seen", preferences.tour_seen},
        {"panel_em", preferences.layout.panel_em},
        {"letters", preferences.layout.letters},
        {"wheel", name_of(preferences.layout.wheel)},
        {"language",
         preferences.layout.language ? name_of(*preferences.layout.language) : "desktop"}};
    for (const auto& [name, flag] : switches)
        file[name] = preferences.layout.*flag;
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    (void)write_text((folder / file_name).string(), file.dump(2) + "\n");
}

void PreferencesFile::follow(const Preferences& now, double now_s) {
    if (now != newest_) {
        if (newest_ == saved_) first_s_ = now_s;
        newest_ = now;
        last_s_ = now_s;
    }
    if (now_s >= due_at_s()) finish();
}

double PreferencesFile::due_at_s() const {
    return std::min(last_s_ + rest_s, first_s_ + longest_s);
}

std::optional<double> PreferencesFile::due_s(double now_s) const {
    if (newest_ == saved_) return std::nullopt;
    return std::max(due_at_s() - now_s, 0.0);
}

void PreferencesFile::finish() {
    if (newest_ == saved_) return;
    if (folder_) save_preferences(*folder_, newest_);
    saved_ = newest_;
}

}  // namespace zeroset
