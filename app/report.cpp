#include "app/commands.hpp"

#include <iostream>
#include <span>

namespace zeroset {

int report(const InputError& error) {
    std::cerr << describe(error);
    return exit_wrong_input;
}

int report_run_time(const std::string& message) {
    std::cerr << "error: " << message << "\n";
    return exit_run_time;
}

std::expected<void, FileError> write_text(const std::string& path, const std::string& text) {
    if (path != "-") return write_file(path, std::as_bytes(std::span(text)));
    std::cout << text << std::flush;
    if (!std::cout) return std::unexpected(FileError{"cannot write to standard output"});
    return {};
}

}  // namespace zeroset
