#pragma once

#include <chrono>

namespace zeroset {

/// Ends the process whatever its threads are at, with all that was printed.
[[noreturn]] void end_process(int exit_code);

/// Ends the process after that long, if it has not ended by itself: threads at work cannot always
/// be waited for.
void end_process_after(std::chrono::milliseconds time, int exit_code);

/// From now on SIGINT, SIGTERM and SIGHUP, unless they are ignored, end the process at once with
/// exit code 1, after `last_words` from a thread of its own: files are whole or untouched. To be
/// called before there is another thread.
void end_on_signals(void (*last_words)());

}  // namespace zeroset
