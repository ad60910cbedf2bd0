#pragma once

#include <span>
#include <string_view>

namespace zeroset {

/// An animation of a paper that is drawn with one grid for n frames [Florez08, sec. 6.5].
struct PrintedAnimation {
    std::string_view name;  ///< as it is typed: a table of `zeroset compare`
    std::string_view source;
    std::string_view note;     ///< what of the scene is not printed
    std::string_view formula;  ///< w is the time
    double domain;             ///< the clip box is [-domain, domain]^3
    double from, to;           ///< of w
    /// How much less time a frame takes by a grid for `n` frames than by one for each, in percent.
    double printed_least, printed_most;
    int n = 5;
};

std::span<const PrintedAnimation> printed_animations();
/// nullptr when there is none of the name.
const PrintedAnimation* find_printed_animation(std::string_view name);

}  // namespace zeroset
