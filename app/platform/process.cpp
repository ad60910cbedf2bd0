#include "app/platform/process.hpp"

#include "engine/export/file.hpp"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <thread>

namespace zeroset {

void end_process(int exit_code) {
    std::cout.flush();
    std::cerr.flush();
    std::fflush(nullptr);
    std::_Exit(exit_code);
}

void end_process_after(std::chrono::milliseconds time, int exit_code) {
    std::thread([time, exit_code] {
        std::this_thread::sleep_for(time);
        end_process(exit_code);
    }).detach();
}

void end_on_signals(void (*last_words)()) {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now{};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler != SIG_IGN) sigaddset(&signals, signal);
    }
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    // A thread rather than a signal handler: it may wait until a file is renamed.
    std::thread([signals, last_words] {
        int signal = 0;
        while (::sigwait(&signals, &signal) != 0) {
        }
        abandon_files();
        last_words();
        std::_Exit(EXIT_FAILURE);
    }).detach();
}

namespace {

using LostPageHandler = bool (*)(const void* address);

LostPageHandler& lost_page_handler() {
    static constinit LostPageHandler handler = nullptr;
    return handler;
}

void handle_lost_page(int signal, siginfo_t* info, void* /*context*/) {
    if (info->si_code == BUS_ADRERR && lost_page_handler()(info->si_addr)) return;
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

}  // namespace

void on_lost_pages(bool (*handle)(const void* address)) {
    lost_page_handler() = handle;
    struct sigaction action{};
    action.sa_sigaction = handle_lost_page;
    action.sa_flags = SA_SIGINFO;
    ::sigaction(SIGBUS, &action, nullptr);
}

void end_on_lost_page() {
    static constinit std::atomic_flag ends;
    while (ends.test_and_set())
        ::pause();  // another thread ends the process
    abandon_files();
    constexpr std::string_view text =
        "error: a file of samples has become shorter while it was read; try again once it is "
        "written\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    std::_Exit(EXIT_FAILURE);
}

}  // namespace zeroset
