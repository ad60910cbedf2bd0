#pragma once

#include "document/sheet.hpp"

#include <optional>

namespace zeroset {

/// Tells for how long what a row drew is drawn while the row is wrong: long enough to type on.
class OldRows {
public:
    static constexpr double stay_s = 1.0;

    /// To be called in each frame. `wrong`: a row has an error. `now_s`: any clock that does not go
    /// back.
    void follow(const Sheet& sheet, bool wrong, double now_s);

    /// True while what wrong rows drew before is drawn.
    [[nodiscard]] bool stay(double now_s) const;
    /// Seconds until that changes even if no event comes; nothing: it will not.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;

private:
    Sheet sheet_;
    std::optional<double> since_s_;  ///< the sheet is as it is, and wrong
};

}  // namespace zeroset
