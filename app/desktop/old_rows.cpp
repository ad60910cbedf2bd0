#include "app/desktop/old_rows.hpp"

namespace zeroset {

void OldRows::follow(const Sheet& sheet, bool wrong, double now_s) {
    if (sheet != sheet_ || !wrong) since_s_.reset();
    if (wrong && !since_s_) since_s_ = now_s;
    sheet_ = sheet;
}

bool OldRows::stay(double now_s) const { return !since_s_ || now_s < *since_s_ + stay_s; }

std::optional<double> OldRows::due_s(double now_s) const {
    if (!since_s_ || !stay(now_s)) return std::nullopt;
    return *since_s_ + stay_s - now_s;
}

}  // namespace zeroset
