#include "engine/noise/noise.hpp"

#include "engine/noise/cellular.hpp"
#include "engine/noise/lattice_noise.hpp"

#include <map>
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
    static std::mutex mutex;
    static std::map<std::pair<NoiseWord, std::uint32_t>, std::shared_ptr<const Field>> known;
    const std::scoped_lock lock(mutex);
    auto& field = known[{word, seed}];
    if (!field) {
        std::string text(noise_name(word));
        if (seed != 0) text += ", " + std::to_string(seed);
        field = made(word, seed, std::move(text));
    }
    return field;
}

}  // namespace zeroset
