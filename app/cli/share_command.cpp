#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "document/json/share_text.hpp"

#include <iostream>

namespace zeroset {

int run_share(const ShareCommand& command) {
    auto input = read_document_with_rows(command.equation, command.view);
    if (!input) return report(input.error());
    if (const auto wrong = take_look(command.trace, input->document)) return report(*wrong);
    std::cout << share_text(input->document) << '\n';
    return exit_ok;
}

}  // namespace zeroset
