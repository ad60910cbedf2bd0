#pragma once

#include <string>

namespace zeroset::ui {

/// A field that fills the next item's width, into which one types a number; a decimal comma is read
/// as a point. Anything that is no number from `lo` to `hi` leaves the value alone. `empty`: shown
/// in place of 0, where that stands for a choice of its own. Returns true when the value changed.
bool draw_number_field(const char* id, double& value, double lo, double hi,
                       const char* empty = nullptr);
bool draw_integer_field(const char* id, int& value, int lo, int hi, const char* empty = nullptr);

/// Reads the number that a person typed, with a point or a comma; false where it is none.
bool read_typed(const std::string& typed, double& value);

}  // namespace zeroset::ui
