#pragma once

#include <chrono>

namespace zeroset {

/// Ends the process whatever its threads are doing; output printed so far is flushed.
[[noreturn]] void end_process(int exit_code);

/// Ends the process after `time` unless it has ended by itself: working threads cannot always be
/// waited for.
void end_process_after(std::chrono::milliseconds time, int exit_code);

/// Makes SIGINT, SIGTERM and SIGHUP, unless they are ignored, end the process at once with exit
/// code 1, after calling `last_words` on a thread of its own; files are complete or untouched. Must
/// be called before any other thread is created.
void end_on_signals(void (*last_words)());

/// Lets `handle` decide where a mapped file has lost the page of an address, as another program
/// made the file shorter (SIGBUS): once it returns true the page is read again, else the process
/// ends by the signal. It runs in the handler of the signal.
void on_lost_pages(bool (*handle)(const void* address));

/// For on_lost_pages of a subcommand: says that a file has become shorter and ends the process with
/// exit code 1; files are complete or untouched.
[[noreturn]] void end_on_lost_page();

}  // namespace zeroset
