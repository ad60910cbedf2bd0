#include "app/exports/export_news.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/image/frame_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace zeroset {
namespace {

/// Pixels along a side of the picture as it goes, at most.
constexpr int shown_px = 480;
/// Time between two of these pictures.
constexpr std::chrono::milliseconds between_pictures(120);
/// Before, a rate says nothing.
constexpr double rate_from_s = 0.3;

}  // namespace

std::string clock_text(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(seconds));
    std::array<char, 48> text{};
    if (whole < 3600) {
        std::snprintf(text.data(), text.size(), "%lld:%02lld", whole / 60, whole % 60);
    } else {
        std::snprintf(text.data(), text.size(), "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    }
    return text.data();
}

void ExportNews::enter(std::string stage, std::uint64_t parts, std::string unit) {
    const std::scoped_lock lock(mutex_);
    stage_ = std::move(stage);
    unit_ = std::move(unit);
    begun_ = now_();
    parts_ = parts;
    done_ = 0;
}

void ExportNews::show(const Framebuffer& frame, int row, int rows) {
    const bool last = row + frame.height >= rows;
    {
        const std::scoped_lock lock(mutex_);
        const auto now = now_();
        if (row == 0 && last && now < shown_ + between_pictures) return;
        shown_ = now;
        take_over(frame, row, rows, shown_px, picture_);
        fresh_ = true;
    }
    wake_();
}

double ExportNews::share() const {
    const std::uint64_t parts = parts_;
    return parts == 0 ? 0.0
                      : std::min(static_cast<double>(done_) / static_cast<double>(parts), 1.0);
}

std::string ExportNews::text() const {
    const std::scoped_lock lock(mutex_);
    const std::uint64_t parts = parts_;
    const std::uint64_t done = std::min(done_.load(), parts);
    if (parts == 0) return stage_;
    const double seconds = std::chrono::duration<double>(now_() - begun_).count();
    std::string text =
        unit_.empty() ? std::to_string(100 * done / parts) + " %"
                      : filled(tr("{0} {1} of {2}"),
                               {tr(unit_.c_str()), std::to_string(done), std::to_string(parts)});
    if (done == 0 || seconds < rate_from_s) return text;
    const double rate = static_cast<double>(done) / seconds;
    const std::string left = clock_text(static_cast<double>(parts - done) / rate);
    if (unit_.empty()) return filled(tr("{0}, {1} left"), {text, left});
    return filled(tr("{0}, {1} a second, {2} left"),
                  {text, localized(short_number(rate, 3)), left});
}

std::optional<RgbaImage> ExportNews::take_picture() {
    const std::scoped_lock lock(mutex_);
    if (!std::exchange(fresh_, false)) return std::nullopt;
    return picture_;
}

}  // namespace zeroset
