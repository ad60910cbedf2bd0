#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::test {

struct Failure {
    std::string text;
    std::string reason;  ///< the complaint, or how the process ended
};

/// Tries texts in a child process; if that crashes, the text being tried has failed.
class Isolated {
public:
    using Target = std::optional<std::string> (*)(std::string_view);

    /// `timeout_s`: a text that takes longer fails; 0: no limit.
    Isolated(Target target, std::size_t timeout_s);
    ~Isolated();
    Isolated(const Isolated&) = delete;
    Isolated& operator=(const Isolated&) = delete;

    [[nodiscard]] std::optional<Failure> failure_of(const std::string& text) const;

    /// Tries texts from `next` in the child until there are no more or one fails. The argument of
    /// `next`, which runs in the child, says whether a text has been tried before.
    [[nodiscard]] std::optional<Failure> first_failure(
        const std::function<std::optional<std::string>(bool)>& next) const;

private:
    struct Shared;

    Target target_;
    std::size_t timeout_s_;
    Shared* shared_;  ///< shared with the child
};

}  // namespace zeroset::test
