#include "engine/noise/noise.hpp"

#include "engine/noise/cellular.hpp"
#include "engine/noise/lattice_noise.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <mutex>
#include <string>
#include <utility>

namespace zeroset {
namespace {

std::shared_ptr<const Field> made(NoiseWord word, std::uint32_t seed, std::string text) {
    switch (word) {
        case NoiseWord::Noise:
            return std::make_shared<LatticeNoiseField>(LatticeNoise(NoiseKind::Gradient, seed),
                                                       std::move(text));
        case NoiseWord::ValueNoise:
            return std::make_shared<LatticeNoiseField>(LatticeNoise(NoiseKind::Value, seed),
                                                       std::move(text));
        case NoiseWord::Cellular:
            return std::make_shared<CellularField>(Cellular(1, seed), std::move(text));
        case NoiseWord::Cellular2:
            return std::make_shared<CellularField>(Cellular(2, seed), std::move(text));
    }
    return nullptr;
}

}  // namespace

std::string_view noise_name(NoiseWord word) {
    switch (word) {
        case NoiseWord::Noise: return "noise";
        case NoiseWord::ValueNoise: return "value_noise";
        case NoiseWord::Cellular: return "cellular";
        case NoiseWord::Cellular2: return "cellular2";
    }
    return {};
}

std::shared_ptr<const Field> noise_field(NoiseWord word, std::uint32_t seed) {
    struct Known {
        NoiseWord word;
        std::uint32_t seed;
        std::shared_ptr<const Field> field;
    };
    constexpr std::size_t most_kept = 256;
    static std::mutex mutex;
    static std::deque<Known> latest;
    const std::scoped_lock lock(mutex);
    const auto known = std::ranges::find_if(
        latest, [&](const Known& one) { return one.word == word && one.seed == seed; });
    if (known != latest.end()) return known->field;
    std::string text(noise_name(word));
    if (seed != 0) text += ", " + std::to_string(seed);
    if (latest.size() == most_kept) latest.pop_front();
    return latest.emplace_back(word, seed, made(word, seed, std::move(text))).field;
}

}  // namespace zeroset
