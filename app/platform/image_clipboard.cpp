#include "app/platform/image_clipboard.hpp"

#include "engine/base/owned.hpp"
#include "engine/base/translation.hpp"

#include <xcb/xcb.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

namespace zeroset {
namespace {

/// Bytes of a request beside its data.
constexpr std::size_t request_head = 64;

}  // namespace

/// A connection of its own, with a window nobody sees that owns the clipboard.
class ImageClipboard::Owner {
public:
    Owner();
    ~Owner();
    Owner(const Owner&) = delete;
    Owner& operator=(const Owner&) = delete;

    [[nodiscard]] bool connected() const { return xcb_connection_has_error(display_) == 0; }
    std::expected<void, std::string> offer(std::vector<std::byte> png);

private:
    [[nodiscard]] xcb_atom_t atom(std::string_view name) const;
    void run();
    void answer(const xcb_selection_request_event_t& request);
    /// Puts what is asked for into the requestor's property; false where there is no such thing.
    bool put(const xcb_selection_request_event_t& request, xcb_atom_t property);

    xcb_connection_t* display_ = nullptr;
    xcb_window_t window_ = 0;
    xcb_atom_t clipboard_ = 0, targets_ = 0, png_type_ = 0, end_ = 0;
    std::mutex mutex_;
    std::vector<std::byte> png_;  ///< empty: nothing is offered
    std::thread thread_;
};

ImageClipboard::Owner::Owner() : display_(xcb_connect(nullptr, nullptr)) {
    if (!connected()) return;
    clipboard_ = atom("CLIPBOARD");
    targets_ = atom("TARGETS");
    png_type_ = atom("image/png");
    end_ = atom("ZEROSET_END");
    const xcb_screen_t& screen = *xcb_setup_roots_iterator(xcb_get_setup(display_)).data;
    window_ = xcb_generate_id(display_);
    xcb_create_window(display_, 0, window_, screen.root, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_ONLY,
                      XCB_COPY_FROM_PARENT, 0, nullptr);
    xcb_flush(display_);
    thread_ = std::thread([this] { run(); });
}

ImageClipboard::Owner::~Owner() {
    if (thread_.joinable()) {
        xcb_client_message_event_t end{};
        end.response_type = XCB_CLIENT_MESSAGE;
        end.format = 32;
        end.window = window_;
        end.type = end_;
        xcb_send_event(display_, 0, window_, XCB_EVENT_MASK_NO_EVENT,
                       reinterpret_cast<const char*>(&end));
        xcb_flush(display_);
        thread_.join();
    }
    xcb_disconnect(display_);
}

xcb_atom_t ImageClipboard::Owner::atom(std::string_view name) const {
    const auto cookie =
        xcb_intern_atom(display_, 0, static_cast<std::uint16_t>(name.size()), name.data());
    const auto reply = owned(xcb_intern_atom_reply(display_, cookie, nullptr));
    return reply == nullptr ? xcb_atom_t{XCB_ATOM_NONE} : reply->atom;
}

std::expected<void, std::string> ImageClipboard::Owner::offer(std::vector<std::byte> png) {
    const std::size_t most = std::size_t{xcb_get_maximum_request_length(display_)} * 4;
    if (png.size() + request_head > most)
        return std::unexpected(tr("the picture is too large for the clipboard; Ctrl+E saves it"));
    {
        const std::scoped_lock lock(mutex_);
        png_ = std::move(png);
    }
    xcb_set_selection_owner(display_, window_, clipboard_, XCB_CURRENT_TIME);
    const auto cookie = xcb_get_selection_owner(display_, clipboard_);
    const auto reply = owned(xcb_get_selection_owner_reply(display_, cookie, nullptr));
    if (reply == nullptr || reply->owner != window_)
        return std::unexpected(
            tr("the desktop did not give the clipboard; Ctrl+E saves the picture"));
    return {};
}

void ImageClipboard::Owner::run() {
    while (const auto event = owned(xcb_wait_for_event(display_))) {
        switch (event->response_type & 0x7FU) {
            case XCB_SELECTION_REQUEST:
                answer(*reinterpret_cast<const xcb_selection_request_event_t*>(event.get()));
                break;
            case XCB_SELECTION_CLEAR: {
                const std::scoped_lock lock(mutex_);
                png_.clear();
                break;
            }
            case XCB_CLIENT_MESSAGE: return;
            default: break;
        }
    }
}

bool ImageClipboard::Owner::put(const xcb_selection_request_event_t& request, xcb_atom_t property) {
    const std::scoped_lock lock(mutex_);
    if (png_.empty()) return false;
    if (request.target == targets_) {
        const std::array<xcb_atom_t, 2> offered{targets_, png_type_};
        xcb_change_property(display_, XCB_PROP_MODE_REPLACE, request.requestor, property,
                            XCB_ATOM_ATOM, 32, offered.size(), offered.data());
        return true;
    }
    if (request.target != png_type_) return false;
    xcb_change_property(display_, XCB_PROP_MODE_REPLACE, request.requestor, property, png_type_, 8,
                        static_cast<std::uint32_t>(png_.size()), png_.data());
    return true;
}

void ImageClipboard::Owner::answer(const xcb_selection_request_event_t& request) {
    // Old programs name no property.
    const xcb_atom_t property =
        request.property == XCB_ATOM_NONE ? request.target : request.property;
    xcb_selection_notify_event_t done{};
    done.response_type = XCB_SELECTION_NOTIFY;
    done.time = request.time;
    done.requestor = request.requestor;
    done.selection = request.selection;
    done.target = request.target;
    done.property = put(request, property) ? property : xcb_atom_t{XCB_ATOM_NONE};
    xcb_send_event(display_, 0, request.requestor, XCB_EVENT_MASK_NO_EVENT,
                   reinterpret_cast<const char*>(&done));
    xcb_flush(display_);
}

ImageClipboard::ImageClipboard() = default;
ImageClipboard::~ImageClipboard() = default;

std::expected<void, std::string> ImageClipboard::offer(std::vector<std::byte> png) {
    if (owner_ == nullptr || !owner_->connected()) owner_ = std::make_unique<Owner>();
    if (owner_->connected()) return owner_->offer(std::move(png));
    return std::unexpected(
        tr("pictures are copied on X11 only, and there is no X server; Ctrl+E "
           "saves the picture"));
}

}  // namespace zeroset
