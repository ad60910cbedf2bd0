#pragma once

#include "document/sheet.hpp"
#include "engine/base/translation.hpp"
#include "pipeline/color_formulas.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/input_error.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
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
    std::expected<std::shared_ptr<const Formula>, InputError> formula;  ///< made from reading.text
    ColorChoice choice = {};                                            ///< what the colours show
    /// Colours for the formula. After an error the last ones that could be made, or plain ones.
    std::shared_ptr<const ColorFormulas> colors = {};
    std::optional<InputError> color_error = {};
    std::optional<InputError> contour_error = {};  ///< of the expression of the contour lines
    std::uint64_t number = 0;                      ///< of the call of FormulaJob::submit
};

/// Reads and compiles the newest sheet in the background. The UI thread may call all members; none
/// waits for a compilation. A sheet is dropped when a newer one overtakes it. A new formula arrives
/// twice: interpreted, and again when its machine code is ready.
class FormulaJob {
public:
    /// Calls `on_result` from the job's threads after each result.
    explicit FormulaJob(std::function<void()> on_result);
    ~FormulaJob();
    FormulaJob(const FormulaJob&) = delete;
    FormulaJob& operator=(const FormulaJob&) = delete;

    /// Replaces the sheet to prepare. `place`: where the formula will be looked at. Map and range
    /// of `choice` do not matter. `files`: of the document. `draws_old`: see SheetReader::read.
    void submit(Sheet sheet, const FormulaPlace& place, const ColorChoice& choice = {},
                std::shared_ptr<const FieldSource> files = nullptr, bool draws_old = true);
    /// Returns the newest result not yet taken, if any.
    std::optional<FormulaResult> take();
    /// Says that the result taken last is on the screen, so that compiling its machine code may
    /// begin at once.
    void drawn();
    /// Makes code in double for a formula, unless another formula overtakes it.
    void submit_double(std::shared_ptr<const Formula> formula);
    /// Returns the newest formula with code in double that was not yet taken, or nullptr.
    std::shared_ptr<const Formula> take_double();

private:
    using Clock = std::chrono::steady_clock;

    struct Request {
        std::uint64_t number = 0;
        Sheet sheet;
        FormulaPlace place = {};
        ColorChoice choice = {};
        std::shared_ptr<const FieldSource> files = nullptr;
        bool draws_old = true;
    };

    void prepare_sheets();
    void compile_more();
    void publish_double(const Formula& formula);
    void publish(FormulaResult result);

    std::function<void()> on_result_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Request> pending_;
    std::optional<FormulaResult> interpreted_;  ///< the result whose formula waits for machine code
    Clock::time_point compile_at_;              ///< when compiling `interpreted_` begins
    TextStyle style_;                           ///< of who submits
    std::shared_ptr<const Formula> deep_;       ///< the formula that waits for code in double
    std::shared_ptr<const Formula> double_;     ///< the formula whose code in double is ready
    std::optional<FormulaResult> finished_;
    std::uint64_t newest_ = 0;  ///< number of the newest call of submit
    bool stop_ = false;
    std::thread preparing_;
    std::thread compiling_;
};

}  // namespace zeroset
