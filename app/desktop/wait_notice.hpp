#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {

/// Says what the window is doing while a text is prepared, but nothing of what takes less than a
/// tenth of a second, as the screen would flicker at each key.
class WaitNotice {
public:
    static constexpr double delay_s = 0.1;
    static constexpr double fade_s = 0.15;  ///< time over which the picture is dimmed after delay_s

    /// Causes for which the window waits at a moment.
    struct Causes {
        bool picture = false;   ///< the picture on the screen is of another text
        bool figures = false;   ///< the figures of the last full picture are of another text
        bool reading = false;   ///< the text is not read and prepared yet
        bool code = false;      ///< machine code is being made
        std::size_t nodes = 0;  ///< nodes of the formula that is compiled
    };

    /// To be called whenever `what` may have changed. `now_s`: any clock that does not go back.
    void follow(const Causes& what, double now_s);

    /// How much the picture is to be dimmed: 0 (not at all) to 1.
    [[nodiscard]] float dimmed(double now_s) const;
    /// True if the figures of the last full picture are to be left out.
    [[nodiscard]] bool hides_figures(double now_s) const;
    /// Text of what the window is doing, for the status line; empty: nothing to tell.
    [[nodiscard]] std::string text(double now_s) const;
    /// Seconds until an answer changes even if no event comes; nothing: none will.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;

private:
    Causes what_;
    std::optional<double> picture_since_s_, figures_since_s_, code_since_s_;
};

}  // namespace zeroset
