#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace zeroset::test {

/// Reads the text and does with it all that the program would do: reads its canonical texts again,
/// tightens its surfaces, interprets and, where that is quick, compiles them. Returns what is
/// wrong, if anything; equal texts give equal results.
std::optional<std::string> complaint_about(std::string_view text);

}  // namespace zeroset::test
