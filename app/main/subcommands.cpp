#include "app/main/subcommands.hpp"

#include "app/cli/progress.hpp"
#include "app/cli/report.hpp"
#include "app/platform/process.hpp"
#include "engine/volume/files/mapped_file.hpp"
#include "jit/compile.hpp"

#include <iostream>
#include <string>

namespace zeroset {
namespace {

/// A subcommand draws no pages that are lost.
bool end_if_lost(const void* address) noexcept {
    if (is_mapped(address)) end_on_lost_page();
    return false;
}

/// Puts a space before arguments such as "-x^2+y", which are equations: CLI11 takes words with a
/// leading space for values, and the readers of values drop the space.
std::vector<std::string> protected_arguments(int argc, char** argv) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    for (std::string& argument : arguments) {
        const bool dash = argument.size() > 1 && argument[0] == '-' && argument[1] != '-';
        const bool flag = argument == "-h" || argument.starts_with("-o");
        if (dash && !flag) argument.insert(0, 1, ' ');
    }
    return {arguments.rbegin(), arguments.rend()};
}

}  // namespace

std::optional<int> parse(CLI::App& app, int argc, char** argv, void (*complete_help)(CLI::App&)) {
    try {
        app.parse(protected_arguments(argc, argv));
    } catch (const CLI::CallForVersion& answer) {
        return app.exit(answer);
    } catch (const CLI::Success& answer) {  // --help
        complete_help(app);
        return app.exit(answer);
    } catch (const CLI::ParseError& error) {
        return report({.reason = std::string(error.what()) + " (" + app.get_name() +
                                 " --help lists what there is)"});
    }
    return std::nullopt;
}

int run_typed(const std::vector<Subcommand>& subcommands) {
    end_on_signals(clear_progress);
    on_lost_pages(end_if_lost);
    for (const auto& [app, run] : subcommands) {
        if (!*app) continue;
        const int result = run();
        const auto missing = jit::missing_code();
        const bool is_written = result == exit_ok || result == exit_inexact;
        if (missing && is_written) std::cerr << "note: " << *missing << '\n';
        return result;
    }
    return exit_ok;
}

}  // namespace zeroset
