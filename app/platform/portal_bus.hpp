#pragma once

#include "app/platform/portal.hpp"

#include <systemd/sd-bus.h>

#include <functional>
#include <memory>
#include <string>

namespace zeroset {

/// The talk with the portal, for one thread. The handlers are called from process().
class PortalBus {
public:
    struct Handlers {
        std::function<void(ColorWish)> on_wish;
        std::function<void(FileAnswer)> on_answer;
    };

    /// Opens the session's bus and asks for the wish; see is_open().
    explicit PortalBus(Handlers handlers);

    [[nodiscard]] bool is_open() const { return bus_ != nullptr; }
    /// Handles what has come.
    void process();
    /// Sleeps until something comes or `wake_fd` can be read, and reads that.
    void wait(int wake_fd) const;

    void ask(const FileRequest& request);
    void give_up();

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
    Slot response_;        ///< waits for the dialog's end
    Slot asked_;           ///< waits for its beginning
    std::string request_;  ///< the object that stands for the dialog; empty: there is none
    unsigned count_ = 0;   ///< of dialogs so far
};

}  // namespace zeroset
