#pragma once

#include "document/sheet.hpp"
#include "pipeline/color_formulas.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/input_error.hpp"

#include <chrono>
#include <condition_variable>
#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace zeroset {

struct FormulaResult {
    Sheet sheet;
    SheetReading reading;
    std::expected<std::shared_ptr<const Formula>, InputError> formula;  ///< of reading.text
    ColorChoice choice = {};  ///< of what the colours tell
    /// For the formula; where there is an error, the last that could be made, or plain ones.
    std::shared_ptr<const ColorFormulas> colors = {};
    std::optional<InputError> color_error = {};
};

/// Reads and compiles the newest sheet in the background. Members may be called from the UI thread
/// and never wait for a compilation; sheets overtaken by a newer one are dropped. A formula
/// that is new arrives twice: interpreted, and again when its machine code is ready.
class FormulaJob {
public:
    /// `on_result` is called from the job's threads after each result.
    explicit FormulaJob(std::function<void()> on_result);
    ~FormulaJob();
    FormulaJob(const FormulaJob&) = delete;
    FormulaJob& operator=(const FormulaJob&) = delete;

    /// `region`: where the formula will be looked at. Of `choice`, its map and range do not matter.
    void submit(Sheet sheet, const Box& region, const ColorChoice& choice = {});
    /// The newest result not yet taken, or nothing.
    std::optional<FormulaResult> take();
    /// The result taken last is on the screen: its machine code is made from here on.
    void drawn();
    /// Makes code in double for a formula, unless it is overtaken by another.
    void submit_double(std::shared_ptr<const Formula> formula);
    /// The newest formula with code in double not yet taken, or nullptr.
    std::shared_ptr<const Formula> take_double();

private:
    using Clock = std::chrono::steady_clock;

    struct Request {
        Sheet sheet;
        Box region;
        ColorChoice choice = {};
    };

    void prepare_sheets();
    void compile_more();
    void publish_double(const Formula& formula);
    void publish(FormulaResult result);

    std::function<void()> on_result_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Request> pending_;
    std::optional<FormulaResult> interpreted_;  ///< its formula waits for its machine code
    Clock::time_point compile_at_;              ///< when it has waited long enough
    std::shared_ptr<const Formula> deep_;       ///< waits for its code in double
    std::shared_ptr<const Formula> double_;     ///< has it
    std::optional<FormulaResult> finished_;
    Sheet newest_;
    ColorChoice newest_choice_;
    bool stop_ = false;
    std::thread preparing_;
    std::thread compiling_;
};

}  // namespace zeroset
