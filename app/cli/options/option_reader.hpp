#pragma once

#include "pipeline/input_error.hpp"

#include <optional>
#include <utility>

namespace zeroset {

/// Reads options one after another, and keeps the first error: those behind it change nothing.
class OptionReader {
public:
    /// Sets the target to what was read.
    template <class Target, class Value>
    void take(Target& target, OrInputError<Value> value) {
        if (!value) return check(std::move(value.error()));
        if (!error_) target = static_cast<Target>(*std::move(value));
    }
    /// Takes the error of a check, if there is one.
    void check(std::optional<InputError> error) {
        if (!error_) error_ = std::move(error);
    }
    [[nodiscard]] const std::optional<InputError>& error() const { return error_; }
    /// Ends the reading: its result, or the error.
    template <class Result>
    OrInputError<Result> finish(Result result) {
        if (error_) return std::unexpected(*std::move(error_));
        return result;
    }

private:
    std::optional<InputError> error_;
};

}  // namespace zeroset
