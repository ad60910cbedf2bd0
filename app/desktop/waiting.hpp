#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {

/// What the window tells while a text is prepared. What is done within a tenth of a second goes
/// without a word: the screen would flicker with each key.
class Waiting {
public:
    static constexpr double delay_s = 0.1;
    static constexpr double fade_s = 0.15;  ///< in which the picture is dimmed after that

    /// How things stand.
    struct For {
        bool picture = false;   ///< the one that is shown is of another text
        bool figures = false;   ///< those of the last full picture are of another text
        bool reading = false;   ///< the text is not read and prepared yet
        bool code = false;      ///< machine code is being made
        std::size_t nodes = 0;  ///< of the formula that it is made for
    };

    /// Whenever that may have changed. `now_s`: any clock that does not go back.
    void follow(const For& what, double now_s);

    /// How far the picture is to be dimmed: 0 (as ever) to 1.
    [[nodiscard]] float dimmed(double now_s) const;
    /// Whether the figures of the last full picture are to be left out.
    [[nodiscard]] bool hides_figures(double now_s) const;
    /// What is going on; empty where there is nothing to tell.
    [[nodiscard]] std::string text(double now_s) const;
    /// Seconds until either changes though nothing happens.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;

private:
    For what_;
    std::optional<double> picture_since_s_, figures_since_s_, code_since_s_;
};

}  // namespace zeroset
