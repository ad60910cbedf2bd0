#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace zeroset::test {

/// Reads the text and does all that the program would do with it: its canonical texts read again,
/// its surfaces tightened, interpreted and, where that is quick, compiled. What is wrong, if
/// anything is; the same for the same text.
std::optional<std::string> complaint_about(std::string_view text);

}  // namespace zeroset::test
