#include "app/cli/report.hpp"

#include "pipeline/input_error.hpp"

#include <iostream>

namespace zeroset {

int report(const InputError& error) {
    std::cerr << describe(error);
    return exit_wrong_input;
}

int report_run_time(const std::string& message) {
    std::cerr << "error: " << message << "\n";
    return exit_run_time;
}

}  // namespace zeroset
