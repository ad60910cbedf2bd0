#include "app/platform/portal_bus.hpp"

#include "engine/base/translation.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

constexpr const char* portal = "org.freedesktop.portal.Desktop";
constexpr const char* portal_path = "/org/freedesktop/portal/desktop";
constexpr const char* settings = "org.freedesktop.portal.Settings";
constexpr const char* appearance = "org.freedesktop.appearance";
constexpr const char* color_scheme = "color-scheme";

struct FreeMessage {
    void operator()(sd_bus_message* message) const { sd_bus_message_unref(message); }
};
using Message = std::unique_ptr<sd_bus_message, FreeMessage>;

/// Reads the number in a variant; some portals wrap it in a second variant.
std::optional<ColorWish> read_wish(sd_bus_message* message) {
    while (sd_bus_message_enter_container(message, 'v', "v") > 0) {
    }
    std::uint32_t number = 0;
    if (sd_bus_message_read(message, "v", "u", &number) <= 0) return std::nullopt;
    switch (number) {
        case 1: return ColorWish::Dark;
        case 2: return ColorWish::Light;
        default: return ColorWish::None;
    }
}

/// Returns the first URI in the results of a response.
std::string read_first_uri(sd_bus_message* message) {
    std::string uri;
    if (sd_bus_message_enter_container(message, 'a', "{sv}") <= 0) return uri;
    while (sd_bus_message_enter_container(message, 'e', "sv") > 0) {
        const char* key = nullptr;
        sd_bus_message_read(message, "s", &key);
        const bool is_uris = key != nullptr && std::string(key) == "uris";
        if (is_uris && sd_bus_message_enter_container(message, 'v', "as") > 0) {
            sd_bus_message_enter_container(message, 'a', "s");
            const char* first = nullptr;
            if (sd_bus_message_read(message, "s", &first) > 0) uri = first;
            return uri;
        }
        sd_bus_message_skip(message, "v");
        sd_bus_message_exit_container(message);
    }
    return uri;
}

/// Appends {key: <text>}.
void append_text(sd_bus_message* message, const char* key, const std::string& text) {
    sd_bus_message_append(message, "{sv}", key, "s", text.c_str());
}

/// Appends the filters: one for documents, and one for all that is offered.
void append_filters(sd_bus_message* made, const FileRequest& request) {
    sd_bus_message_open_container(made, 'e', "sv");
    sd_bus_message_append(made, "s", "filters");
    sd_bus_message_open_container(made, 'v', "a(sa(us))");
    sd_bus_message_open_container(made, 'a', "(sa(us))");
    const std::string documents = "*" + request.ending;
    if (!request.other_endings.empty()) {
        sd_bus_message_open_container(made, 'r', "sa(us)");
        sd_bus_message_append(made, "s", tr("All that can be opened"));
        sd_bus_message_open_container(made, 'a', "(us)");
        sd_bus_message_append(made, "(us)", 0U, documents.c_str());
        for (const std::string& ending : request.other_endings)
            sd_bus_message_append(made, "(us)", 0U, ("*" + ending).c_str());
        sd_bus_message_close_container(made);
        sd_bus_message_close_container(made);
    }
    sd_bus_message_append(made, "(sa(us))", tr("Zeroset documents"), 1, 0U, documents.c_str());
    for (int i = 0; i < 3; ++i)
        sd_bus_message_close_container(made);
}

/// Appends {key: <path as bytes that end with 0>}.
void append_path(sd_bus_message* message, const char* key, const std::string& path) {
    sd_bus_message_open_container(message, 'e', "sv");
    sd_bus_message_append(message, "s", key);
    sd_bus_message_open_container(message, 'v', "ay");
    sd_bus_message_append_array(message, 'y', path.c_str(), path.size() + 1);
    sd_bus_message_close_container(message);
    sd_bus_message_close_container(message);
}

/// Milliseconds from now until sd-bus's deadline (CLOCK_MONOTONIC); at least 0, at most one hour,
/// -1: no deadline.
int milliseconds_until(std::uint64_t deadline_us) {
    if (deadline_us == UINT64_MAX) return -1;
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    const std::uint64_t now_us = static_cast<std::uint64_t>(now.tv_sec) * 1'000'000U +
                                 static_cast<std::uint64_t>(now.tv_nsec) / 1000U;
    if (deadline_us <= now_us) return 0;
    constexpr std::uint64_t longest_ms = 3'600'000;
    return static_cast<int>(std::min((deadline_us - now_us) / 1000U + 1U, longest_ms));
}

}  // namespace

PortalBus::PortalBus(Handlers handlers) : handlers_(std::move(handlers)) {
    sd_bus* bus = nullptr;
    if (sd_bus_open_user(&bus) < 0) return;
    bus_.reset(bus);
    listen_to_settings();
}

void PortalBus::listen_to_settings() {
    sd_bus_match_signal_async(bus_.get(), nullptr, portal, portal_path, settings, "SettingChanged",
                              on_setting, nullptr, this);
    sd_bus_call_method_async(bus_.get(), nullptr, portal, portal_path, settings, "Read",
                             on_setting_read, this, "ss", appearance, color_scheme);
}

void PortalBus::process() {
    int more = 1;
    while (bus_ != nullptr && more > 0)
        more = sd_bus_process(bus_.get(), nullptr);
    if (more >= 0) return;
    // A lost bus takes the dialog with it.
    response_.reset();
    asked_.reset();
    bus_.reset();
    if (!request_.empty()) answer({});
}

void PortalBus::wait(int wake_fd) const {
    std::array<pollfd, 2> places{
        {{.fd = wake_fd, .events = POLLIN, .revents = 0}, {.fd = -1, .events = 0, .revents = 0}}};
    int timeout_ms = -1;
    if (bus_ != nullptr) {
        const int events = sd_bus_get_events(bus_.get());
        places[1] = {.fd = sd_bus_get_fd(bus_.get()),
                     .events = static_cast<short>(std::max(events, 0)),
                     .revents = 0};
        std::uint64_t deadline_us = UINT64_MAX;
        if (sd_bus_get_timeout(bus_.get(), &deadline_us) >= 0) {
            timeout_ms = milliseconds_until(deadline_us);
        }
    }
    if (::poll(places.data(), places.size(), timeout_ms) <= 0) return;
    std::uint64_t count = 0;
    if ((places[0].revents & POLLIN) != 0) (void)!::read(wake_fd, &count, sizeof count);
}

void PortalBus::ask(const FileRequest& request) {
    give_up();
    if (bus_ == nullptr || !send(request)) answer({});
}

bool PortalBus::send(const FileRequest& request) {
    const char* unique = nullptr;
    if (sd_bus_get_unique_name(bus_.get(), &unique) < 0) return false;
    std::string sender = std::string(unique).substr(1);
    std::ranges::replace(sender, '.', '_');
    const std::string token = "zeroset" + std::to_string(++count_);
    request_ = std::string(portal_path) + "/request/" + sender + "/" + token;

    sd_bus_slot* slot = nullptr;
    sd_bus_match_signal_async(bus_.get(), &slot, portal, request_.c_str(),
                              "org.freedesktop.portal.Request", "Response", on_response, nullptr,
                              this);
    response_.reset(slot);
    sd_bus_message* made = nullptr;
    if (sd_bus_message_new_method_call(bus_.get(), &made, portal, portal_path,
                                       "org.freedesktop.portal.FileChooser",
                                       request.saves ? "SaveFile" : "OpenFile") < 0) {
        return false;
    }
    const Message message(made);
    sd_bus_message_append(made, "ss", request.parent.c_str(), request.title.c_str());
    sd_bus_message_open_container(made, 'a', "{sv}");
    append_text(made, "handle_token", token);
    append_path(made, "current_folder", request.folder);
    if (request.saves) append_text(made, "current_name", request.name);
    if (request.opens_folder) {
        sd_bus_message_append(made, "{sv}", "directory", "b", 1);
    } else {
        append_filters(made, request);
    }
    sd_bus_message_close_container(made);
    slot = nullptr;
    if (sd_bus_call_async(bus_.get(), &slot, made, on_asked, this, 0) < 0) return false;
    asked_.reset(slot);
    return true;
}

void PortalBus::give_up() {
    if (bus_ != nullptr && !request_.empty()) {
        sd_bus_call_method_async(bus_.get(), nullptr, portal, request_.c_str(),
                                 "org.freedesktop.portal.Request", "Close", nullptr, nullptr,
                                 nullptr);
    }
    response_.reset();
    asked_.reset();
    request_.clear();
}

void PortalBus::show(const std::string& path) const {
    constexpr const char* manager = "org.freedesktop.FileManager1";
    if (bus_ == nullptr) return;
    sd_bus_call_method_async(bus_.get(), nullptr, manager, "/org/freedesktop/FileManager1", manager,
                             "ShowItems", nullptr, nullptr, "ass", 1, uri_of_path(path).c_str(),
                             "");
}

void PortalBus::answer(FileAnswer answer) {
    request_.clear();
    handlers_.on_answer(std::move(answer));
}

int PortalBus::on_setting(sd_bus_message* message, void* self, sd_bus_error* /*error*/) {
    const char* group = nullptr;
    const char* key = nullptr;
    if (sd_bus_message_read(message, "ss", &group, &key) <= 0) return 0;
    if (std::string(group) != appearance || std::string(key) != color_scheme) return 0;
    const std::optional<ColorWish> wish = read_wish(message);
    if (wish) static_cast<PortalBus*>(self)->handlers_.on_wish(*wish);
    return 0;
}

int PortalBus::on_setting_read(sd_bus_message* message, void* self, sd_bus_error* /*error*/) {
    if (sd_bus_message_is_method_error(message, nullptr) > 0) return 0;
    const std::optional<ColorWish> wish = read_wish(message);
    if (wish) static_cast<PortalBus*>(self)->handlers_.on_wish(*wish);
    return 0;
}

/// Handles the return of the call that opens the dialog; an error means that there is no dialog.
int PortalBus::on_asked(sd_bus_message* message, void* self, sd_bus_error* /*error*/) {
    auto& bus = *static_cast<PortalBus*>(self);
    if (sd_bus_message_is_method_error(message, nullptr) > 0 && !bus.request_.empty()) {
        bus.answer({});
    }
    return 0;
}

int PortalBus::on_response(sd_bus_message* message, void* self, sd_bus_error* /*error*/) {
    auto& bus = *static_cast<PortalBus*>(self);
    std::uint32_t how = 0;
    if (sd_bus_message_read(message, "u", &how) <= 0 || bus.request_.empty()) return 0;
    const std::string uri = how == 0 ? read_first_uri(message) : std::string();
    bus.answer({.asked = true, .path = path_of_uri(uri).value_or("")});
    return 0;
}

}  // namespace zeroset
