#include "papers/commands/compare_output.hpp"

#include "app/cli/report.hpp"
#include "engine/export/file.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace zeroset {

CompareOutput::CompareOutput(std::optional<std::string> json) : json_(std::move(json)) {}

std::optional<std::string> CompareOutput::unwritable() const { return first_unwritable({json_}); }

void CompareOutput::print(const std::string& text) const {
    if (json_ != "-") zeroset::print(text);
}

int CompareOutput::finish(const nlohmann::ordered_json& all) const {
    if (!json_) return exit_ok;
    const auto written = write_text(*json_, all.dump(2) + "\n");
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
