#include "app/platform/process.hpp"

#include "engine/export/file.hpp"

#include <pthread.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
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

}  // namespace zeroset
