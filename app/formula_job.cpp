#include "app/formula_job.hpp"

#include <utility>

namespace zeroset {

FormulaJob::FormulaJob(std::function<void()> on_result)
    : on_result_(std::move(on_result)), thread_([this] { run(); }) {}

FormulaJob::~FormulaJob() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void FormulaJob::submit(std::string text) {
    {
        const std::scoped_lock lock(mutex_);
        pending_ = std::move(text);
    }
    wake_.notify_one();
}

std::optional<FormulaResult> FormulaJob::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, std::nullopt);
}

void FormulaJob::run() {
    for (;;) {
        std::string text;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return stop_ || pending_.has_value(); });
            if (stop_) return;
            text = std::move(*std::exchange(pending_, std::nullopt));
        }
        auto formula = compile_formula(text);
        FormulaResult result{std::move(text), std::unexpected(InputError{})};
        if (formula) {
            result.formula = std::make_shared<const Formula>(std::move(*formula));
        } else {
            result.formula = std::unexpected(std::move(formula.error()));
        }
        {
            const std::scoped_lock lock(mutex_);
            if (!pending_) finished_ = std::move(result);
        }
        on_result_();
    }
}

}  // namespace zeroset
