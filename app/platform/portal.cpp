#include "app/platform/portal.hpp"

#include "app/platform/portal_bus.hpp"
#include "engine/base/translation.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cctype>
#include <charconv>
#include <mutex>
#include <thread>
#include <utility>

namespace zeroset {

/// The portal's thread, and the state that it shares with the UI thread under `mutex_`.
class Portal::Thread {
public:
    explicit Thread(std::function<void()> on_news)
        : on_news_(std::move(on_news)),
          wake_(::eventfd(0, EFD_CLOEXEC)),
          thread_([this] { run(); }) {}
    ~Thread() {
        command([this] { stop_ = true; });
        thread_.join();
        ::close(wake_);
    }
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    void ask(const FileRequest& request) {
        command([&] {
            asked_ = request;
            style_ = text_style();
            given_up_ = false;
            answer_.reset();
        });
    }
    void give_up() {
        command([this] {
            asked_.reset();
            given_up_ = true;
            answer_.reset();
        });
    }
    void show(const std::string& path) {
        command([&] { shown_ = path; });
    }
    std::optional<ColorWish> take_wish() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(wish_, std::nullopt);
    }
    std::optional<FileAnswer> take_answer() {
        const std::scoped_lock lock(mutex_);
        // A newer request is still to be sent; an answer to an older one is not for it.
        if (asked_) return std::nullopt;
        return std::exchange(answer_, std::nullopt);
    }

private:
    template <class Change>
    void command(const Change& change) {
        {
            const std::scoped_lock lock(mutex_);
            change();
        }
        const std::uint64_t one = 1;
        (void)!::write(wake_, &one, sizeof one);
    }
    template <class Change>
    void tell(const Change& change) {
        {
            const std::scoped_lock lock(mutex_);
            change();
        }
        on_news_();
    }
    void run();
    /// Carries out what the UI thread asked for; false when the thread must end.
    bool follow(PortalBus& bus);

    std::function<void()> on_news_;
    int wake_;
    std::mutex mutex_;
    bool stop_ = false;
    bool given_up_ = false;
    std::optional<FileRequest> asked_;
    std::optional<std::string> shown_;  ///< a file whose folder is to be shown
    TextStyle style_;                   ///< of who asks
    std::optional<ColorWish> wish_;
    std::optional<FileAnswer> answer_;
    std::thread thread_;
};

void Portal::Thread::run() {
    PortalBus bus(
        {.on_wish = [this](ColorWish wish) { tell([&] { wish_ = wish; }); },
         .on_answer = [this](FileAnswer answer) { tell([&] { answer_ = std::move(answer); }); }});
    while (follow(bus)) {
        bus.process();
        bus.wait(wake_);
        bus.process();
    }
}

bool Portal::Thread::follow(PortalBus& bus) {
    std::optional<FileRequest> asked;
    std::optional<std::string> shown;
    bool given_up = false;
    {
        const std::scoped_lock lock(mutex_);
        if (stop_) return false;
        asked = std::exchange(asked_, std::nullopt);
        shown = std::exchange(shown_, std::nullopt);
        set_language(style_);
        given_up = std::exchange(given_up_, false);
    }
    if (given_up) bus.give_up();
    if (asked) bus.ask(*asked);
    if (shown) bus.show(*shown);
    return true;
}

Portal::Portal(std::function<void()> on_news)
    : thread_(std::make_unique<Thread>(std::move(on_news))) {}

Portal::~Portal() = default;

std::optional<ColorWish> Portal::take_wish() { return thread_->take_wish(); }

void Portal::ask(const FileRequest& request) { thread_->ask(request); }

void Portal::give_up() { thread_->give_up(); }

std::optional<FileAnswer> Portal::take_answer() { return thread_->take_answer(); }

void Portal::show(const std::string& path) { thread_->show(path); }

std::string uri_of_path(const std::string& path) {
    constexpr std::string_view plain = "-_.~/";
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string uri = "file://";
    for (const char letter : path) {
        const auto byte = static_cast<unsigned char>(letter);
        if ((byte < 0x80U && std::isalnum(byte) != 0) || plain.contains(letter)) {
            uri += letter;
        } else {
            uri += '%';
            uri += digits[byte / 16U];
            uri += digits[byte % 16U];
        }
    }
    return uri;
}

std::optional<std::string> path_of_uri(const std::string& uri) {
    constexpr std::string_view prefix = "file://";
    if (!uri.starts_with(prefix)) return std::nullopt;
    // A host may stand before the path; it is taken to be this one.
    const std::size_t begin = uri.find('/', prefix.size());
    if (begin == std::string::npos) return std::nullopt;
    std::string path;
    for (std::size_t i = begin; i < uri.size(); ++i) {
        int byte = uri[i];
        if (uri[i] == '%') {
            const char* const digits = uri.data() + i + 1;
            if (i + 2 >= uri.size()) return std::nullopt;
            const auto [end, error] = std::from_chars(digits, digits + 2, byte, 16);
            if (error != std::errc() || end != digits + 2 || byte == 0) return std::nullopt;
            i += 2;
        }
        path += static_cast<char>(byte);
    }
    return path;
}

}  // namespace zeroset
