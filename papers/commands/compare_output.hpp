#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace zeroset {

/// The output of a comparison: lines while it is measured, and in the end all of it as JSON, where
/// a file for that is typed.
class CompareOutput {
public:
    /// `json`: the file; "-" for JSON alone, on stdout.
    explicit CompareOutput(std::optional<std::string> json);

    /// Why the file cannot be written; nothing: it can.
    [[nodiscard]] std::optional<std::string> unwritable() const;
    void print(const std::string& text) const;
    /// Writes the file; returns the exit code.
    [[nodiscard]] int finish(const nlohmann::ordered_json& all) const;

private:
    std::optional<std::string> json_;
};

}  // namespace zeroset
