#include "ui/window/pinch.hpp"

#include "engine/base/owned.hpp"

#include <sys/socket.h>
#include <xcb/xcb.h>
#include <xcb/xinput.h>

#include <mutex>
#include <thread>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr double one = 65536.0;  ///< of 16.16 fixed point

/// Asks for the pinches of all pointers over the window; false where the server does not know them.
bool select_pinches(xcb_connection_t* display, xcb_window_t window) {
    const auto version = owned(xcb_input_xi_query_version_reply(
        display, xcb_input_xi_query_version(display, 2, 4), nullptr));
    if (version == nullptr || std::pair(version->major_version, version->minor_version) <
                                  std::pair(std::uint16_t{2}, std::uint16_t{4}))
        return false;
    const struct {
        xcb_input_event_mask_t head;
        std::uint32_t events;
    } mask{.head = {.deviceid = XCB_INPUT_DEVICE_ALL_MASTER, .mask_len = 1},
           .events = (1U << XCB_INPUT_GESTURE_PINCH_BEGIN) |
                     (1U << XCB_INPUT_GESTURE_PINCH_UPDATE) | (1U << XCB_INPUT_GESTURE_PINCH_END)};
    const auto error = owned(xcb_request_check(
        display, xcb_input_xi_select_events_checked(display, window, 1, &mask.head)));
    return error == nullptr;
}

}  // namespace

double PinchSteps::follow(const PinchEvent& event) {
    if (event.begins) last_ = 1.0;
    if (event.spread <= 0) return 1.0;
    const double now = event.spread / one;
    return now / std::exchange(last_, now);
}

class PinchListener::Connection {
public:
    Connection(std::uint32_t window, std::function<void()> wake);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    [[nodiscard]] bool listens() const { return thread_.joinable(); }
    double take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(spread_, 1.0);
    }

private:
    void run();
    void follow(const xcb_ge_generic_event_t& event);

    xcb_connection_t* display_;
    std::function<void()> wake_;
    std::uint8_t input_opcode_ = 0;
    PinchSteps steps_;  ///< the thread's
    std::mutex mutex_;
    double spread_ = 1.0;  ///< since take(); guarded by mutex_
    std::thread thread_;
};

PinchListener::Connection::Connection(std::uint32_t window, std::function<void()> wake)
    : display_(xcb_connect(nullptr, nullptr)), wake_(std::move(wake)) {
    if (xcb_connection_has_error(display_) != 0) return;
    const xcb_query_extension_reply_t* const input =
        xcb_get_extension_data(display_, &xcb_input_id);
    if (input == nullptr || input->present == 0 || !select_pinches(display_, window)) return;
    input_opcode_ = input->major_opcode;
    thread_ = std::thread([this] { run(); });
}

PinchListener::Connection::~Connection() {
    if (thread_.joinable()) {
        // The thread waits for the server; it wakes as if the server were gone.
        shutdown(xcb_get_file_descriptor(display_), SHUT_RDWR);
        thread_.join();
    }
    xcb_disconnect(display_);
}

void PinchListener::Connection::run() {
    while (const auto event = owned(xcb_wait_for_event(display_))) {
        if ((event->response_type & 0x7FU) == XCB_GE_GENERIC)
            follow(*reinterpret_cast<const xcb_ge_generic_event_t*>(event.get()));
    }
}

void PinchListener::Connection::follow(const xcb_ge_generic_event_t& event) {
    if (event.extension != input_opcode_ || event.event_type < XCB_INPUT_GESTURE_PINCH_BEGIN ||
        event.event_type > XCB_INPUT_GESTURE_PINCH_END)
        return;
    const auto& pinch = reinterpret_cast<const xcb_input_gesture_pinch_update_event_t&>(event);
    const double step = steps_.follow(
        {.begins = event.event_type == XCB_INPUT_GESTURE_PINCH_BEGIN, .spread = pinch.scale});
    if (step == 1.0) return;
    {
        const std::scoped_lock lock(mutex_);
        spread_ *= step;
    }
    wake_();
}

PinchListener::PinchListener(std::uint32_t window, std::function<void()> wake)
    : connection_(std::make_unique<Connection>(window, std::move(wake))) {}

PinchListener::~PinchListener() = default;

bool PinchListener::listens() const { return connection_->listens(); }

double PinchListener::take() { return connection_->take(); }

}  // namespace zeroset::ui
