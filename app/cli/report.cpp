#include "app/cli/report.hpp"

#include "engine/base/text.hpp"
#include "engine/export/file.hpp"

#include <cstdio>
#include <iostream>

namespace zeroset {

int report(const InputError& error) {
    std::cerr << describe(error);
    return exit_wrong_input;
}

int report_run_time(const std::string& message) {
    std::cerr << "error: " << printable(message) << "\n";
    return exit_run_time;
}

void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
}

std::optional<std::string> first_unwritable(
    std::initializer_list<std::optional<std::string>> paths) {
    for (const std::optional<std::string>& path : paths) {
        if (!path || *path == "-") continue;
        if (auto writable = check_writable(*path); !writable) return writable.error().message;
    }
    return std::nullopt;
}

}  // namespace zeroset
