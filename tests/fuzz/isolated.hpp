#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::test {

struct Failure {
    std::string text;
    std::string reason;  ///< a complaint, or how the process ended
};

/// Tries texts in a child process, whose crash is a failure of the text it was at.
class Isolated {
public:
    using Target = std::optional<std::string> (*)(std::string_view);

    /// `timeout_s`: a text that takes longer fails; 0: no limit.
    Isolated(Target target, std::size_t timeout_s);
    ~Isolated();
    Isolated(const Isolated&) = delete;
    Isolated& operator=(const Isolated&) = delete;

    [[nodiscard]] std::optional<Failure> failure_of(const std::string& text) const;

    /// Gets texts from `next` in the child until it has no more or one fails. `next` is told
    /// whether the text before was tried; it runs in the child.
    [[nodiscard]] std::optional<Failure> first_failure(
        const std::function<std::optional<std::string>(bool)>& next) const;

private:
    struct Shared;

    Target target_;
    std::size_t timeout_s_;
    Shared* shared_;  ///< with the child
};

}  // namespace zeroset::test
