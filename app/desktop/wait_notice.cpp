#include "app/desktop/wait_notice.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr double frame_s = 1.0 / 60.0;

/// Start of a state: as it was `before`, or `now_s` if new; nothing if the state is over.
std::optional<double> since(const std::optional<double>& before, bool goes_on, double now_s) {
    if (!goes_on) return std::nullopt;
    return before.value_or(now_s);
}

bool lasts(const std::optional<double>& since_s, double now_s) {
    return since_s && now_s - *since_s >= WaitNotice::delay_s;
}

}  // namespace

void WaitNotice::follow(const Causes& what, double now_s) {
    what_ = what;
    picture_since_s_ = since(picture_since_s_, what.picture, now_s);
    figures_since_s_ = since(figures_since_s_, what.figures, now_s);
    code_since_s_ = since(code_since_s_, what.code, now_s);
}

float WaitNotice::dimmed(double now_s) const {
    if (!picture_since_s_) return 0.0F;
    const double faded = (now_s - *picture_since_s_ - delay_s) / fade_s;
    return static_cast<float>(std::clamp(faded, 0.0, 1.0));
}

bool WaitNotice::hides_figures(double now_s) const { return lasts(figures_since_s_, now_s); }

std::string WaitNotice::text(double now_s) const {
    const bool waits_for_picture = lasts(picture_since_s_, now_s);
    if (waits_for_picture && what_.reading) return tr("preparing…");
    if (lasts(code_since_s_, now_s)) {
        return filled(tr("compiling… ({0} nodes)"), {std::to_string(what_.nodes)});
    }
    return waits_for_picture ? tr("drawing…") : "";
}

std::optional<double> WaitNotice::due_s(double now_s) const {
    std::optional<double> due;
    const auto at_least = [&](double seconds) { due = std::min(due.value_or(seconds), seconds); };
    for (const auto& since_s : {picture_since_s_, figures_since_s_, code_since_s_}) {
        if (since_s && !lasts(since_s, now_s)) at_least(*since_s + delay_s - now_s);
    }
    const float faded = dimmed(now_s);
    if (lasts(picture_since_s_, now_s) && faded < 1.0F) at_least(frame_s);
    return due;
}

}  // namespace zeroset
