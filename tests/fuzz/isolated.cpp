#include "tests/fuzz/isolated.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace zeroset::test {

struct Isolated::Shared {
    std::size_t text_size = 0;
    std::array<char, 1U << 20U> text{};
    std::size_t reason_size = 0;
    std::array<char, 4096> reason{};
};

namespace {

constexpr int complained = 99;  ///< exit status of a child that has a complaint

template <std::size_t capacity>
void write_to(std::array<char, capacity>& to, std::size_t& size, std::string_view from) {
    size = std::min(from.size(), capacity);
    std::memcpy(to.data(), from.data(), size);
}

std::string how_it_ended(int status) {
    if (!WIFSIGNALED(status))
        return "the process ended with " + std::to_string(WEXITSTATUS(status));
    const int signal = WTERMSIG(status);
    return signal == SIGALRM ? "it takes too long" : "signal " + std::to_string(signal);
}

}  // namespace

Isolated::Isolated(Target target, std::size_t timeout_s) : target_(target), timeout_s_(timeout_s) {
    void* const memory =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    shared_ = new (memory) Shared;
}

Isolated::~Isolated() { munmap(shared_, sizeof(Shared)); }

std::optional<Failure> Isolated::failure_of(const std::string& text) const {
    return first_failure(
        [&](bool tried) { return tried ? std::optional<std::string>() : std::optional(text); });
}

std::optional<Failure> Isolated::first_failure(
    const std::function<std::optional<std::string>(bool)>& next) const {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) std::abort();
    if (child == 0) {
        auto text = next(false);
        for (; text; text = next(true)) {
            write_to(shared_->text, shared_->text_size, *text);
            alarm(static_cast<unsigned>(timeout_s_));
            const auto complaint = target_(*text);
            if (!complaint) continue;
            write_to(shared_->reason, shared_->reason_size, *complaint);
            std::_Exit(complained);
        }
        std::fflush(nullptr);
        std::_Exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::nullopt;
    const bool has_reason = WIFEXITED(status) && WEXITSTATUS(status) == complained;
    return Failure{{shared_->text.data(), shared_->text_size},
                   has_reason ? std::string(shared_->reason.data(), shared_->reason_size)
                              : how_it_ended(status)};
}

}  // namespace zeroset::test
