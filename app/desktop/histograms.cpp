#include "app/desktop/histograms.hpp"

#include "pipeline/volume_document.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

namespace zeroset {
namespace {

/// More parts than a slider has pixels would not be seen.
constexpr std::size_t most_parts = 512;
constexpr std::size_t most_kept = 8;

}  // namespace

void Histograms::follow(const Program& program) {
    wanted_ = isovalues(program);
    if (!counting_.valid()) start();
}

void Histograms::show(ui::ReadingFacts& reading) {
    if (counting_.valid() &&
        counting_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        counted_.push_back(counting_.get());
        if (counted_.size() > most_kept) counted_.pop_front();
        start();
    }
    reading.histograms.clear();
    for (const auto& [name, volume] : wanted_) {
        const Counted* const counted = find(volume->data());
        if (counted != nullptr && counted->histogram != nullptr)
            reading.histograms[name] = counted->histogram;
    }
}

const Histograms::Counted* Histograms::find(const VolumeData& data) const {
    const auto found = std::ranges::find_if(
        counted_, [&](const Counted& counted) { return counted.data.lock().get() == &data; });
    return found == counted_.end() ? nullptr : &*found;
}

void Histograms::start() {
    const auto next = std::ranges::find_if(
        wanted_, [&](const auto& entry) { return find(entry.second->data()) == nullptr; });
    if (next == wanted_.end()) return;
    counting_ = std::async(std::launch::async, [this, volume = next->second] {
        const VolumeData& data = volume->data();
        auto histogram = histogram_of(data.samples(), data.range(), most_parts, stop_);
        Counted counted{.data = volume->shared_data(), .histogram = nullptr};
        if (histogram) counted.histogram = std::make_shared<const Histogram>(std::move(*histogram));
        return counted;
    });
}

}  // namespace zeroset
