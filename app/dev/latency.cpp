#include "app/cli/report.hpp"
#include "app/cli/window_command.hpp"
#include "app/desktop/desktop.hpp"
#include "app/dev/dev_commands.hpp"
#include "app/platform/process.hpp"
#include "engine/export/file.hpp"
#include "engine/volume/files/mapped_file.hpp"

namespace zeroset {

int run_latency(const LatencyCommand& command) {
    auto options =
        read_desktop_options(command.equation, command.view, command.trace, TextErrors::Refused);
    if (!options) return report(options.error());
    if (const auto writable = check_writable(command.output); !writable)
        return report_run_time(writable.error().message);
    options->latency_log = command.output;
    on_lost_pages(fill_lost_pages);
    const auto ran = run_desktop(*options);
    return ran ? exit_ok : report_run_time(ran.error());
}

}  // namespace zeroset
