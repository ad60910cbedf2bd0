#pragma once

#include "engine/language/parse.hpp"
#include "engine/volume/volume.hpp"
#include "ui/model/shown.hpp"

#include <atomic>
#include <deque>
#include <future>
#include <map>
#include <memory>
#include <string>

namespace zeroset {

/// Counts the samples of the volumes of which sliders choose a value, in the background. One thread
/// owns it.
class Histograms {
public:
    /// How often it wants to be asked while it is not settled.
    static constexpr double poll_s = 0.03;

    Histograms() = default;
    ~Histograms() { stop_ = true; }
    Histograms(const Histograms&) = delete;
    Histograms& operator=(const Histograms&) = delete;

    /// Which volumes are asked for from now on.
    void follow(const Program& program);
    /// The volumes of which sliders choose a value, by the slider's name.
    [[nodiscard]] const std::map<std::string, std::shared_ptr<const Volume>>& wanted() const {
        return wanted_;
    }
    /// To be called before each frame of the panels.
    void show(ui::ReadingFacts& reading);
    [[nodiscard]] bool settled() const { return !counting_.valid(); }

private:
    struct Counted {
        std::weak_ptr<const VolumeData> data;
        std::shared_ptr<const Histogram> histogram;  ///< nullptr: there is nothing to count
    };

    [[nodiscard]] const Counted* find(const VolumeData& data) const;
    void start();

    std::map<std::string, std::shared_ptr<const Volume>> wanted_;
    std::deque<Counted> counted_;  ///< the latest
    std::atomic<bool> stop_{false};
    std::future<Counted> counting_;  ///< ends first
};

}  // namespace zeroset
