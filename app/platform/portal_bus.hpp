#pragma once

#include "app/platform/portal.hpp"

#include <systemd/sd-bus.h>

#include <functional>
#include <memory>
#include <string>

namespace zeroset {

/// The D-Bus connection to the portal; used by one thread. Handlers are called from process().
class PortalBus {
public:
    struct Handlers {
        std::function<void(ColorWish)> on_wish;
        std::function<void(FileAnswer)> on_answer;
    };

    /// Opens the session bus and asks for the theme wish; is_open() tells whether there is a bus.
    explicit PortalBus(Handlers handlers);

    [[nodiscard]] bool is_open() const { return bus_ != nullptr; }
    /// Handles all messages that have arrived.
    void process();
    /// Sleeps until a message arrives or `wake_fd` becomes readable, and reads the latter.
    void wait(int wake_fd) const;

    void ask(const FileRequest& request);
    void give_up();
    /// Has the manager of files show this file; nothing where there is none.
    void show(const std::string& path) const;

private:
    struct CloseBus {
        void operator()(sd_bus* bus) const { sd_bus_close_unref(bus); }
    };
    struct FreeSlot {
        void operator()(sd_bus_slot* slot) const { sd_bus_slot_unref(slot); }
    };
    using Slot = std::unique_ptr<sd_bus_slot, FreeSlot>;

    static int on_setting(sd_bus_message* message, void* self, sd_bus_error* error);
    static int on_setting_read(sd_bus_message* message, void* self, sd_bus_error* error);
    static int on_response(sd_bus_message* message, void* self, sd_bus_error* error);
    static int on_asked(sd_bus_message* message, void* self, sd_bus_error* error);
    void listen_to_settings();
    bool send(const FileRequest& request);
    void answer(FileAnswer answer);

    Handlers handlers_;
    std::unique_ptr<sd_bus, CloseBus> bus_;
    Slot response_;        ///< subscription to the dialog's response
    Slot asked_;           ///< pending call that opens the dialog
    std::string request_;  ///< D-Bus path of the open dialog's request; empty: no dialog
    unsigned count_ = 0;   ///< number of dialogs opened so far
};

}  // namespace zeroset
