#include "tests/support/library_references.hpp"
#include "tests/support/noise_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

// The noise of library.def: sums of the noise of noise_reference.hpp.

namespace zeroset::test {
namespace {

double noise_at(double x, double y, double z, std::uint32_t seed = 0) {
    return lattice_noise_reference(NoiseKind::Gradient, seed, MpfrNumber(x), MpfrNumber(y),
                                   MpfrNumber(z))
        .nearest();
}

/// A sum of octaves in which each is less where the one before it is low.
double ridges(const Arguments& a) {
    double sum = 0;
    double weight = 1;
    double frequency = 1;
    for (int octave = 0; octave < a.p[2]; ++octave, frequency *= a.p[1]) {
        const double noise = noise_at(frequency * a.x, frequency * a.y, frequency * a.z);
        const double signal = std::pow(a.p[3] - std::abs(noise), 2) * weight;
        sum += signal * std::pow(frequency, -a.p[0]);
        weight = std::clamp(a.p[4] * signal, 0.0, 1.0);
    }
    return sum;
}

double octaves(const Arguments& a) {
    double sum = 0;
    double size = 1;
    double frequency = 1;
    for (std::uint32_t octave = 0; octave < a.p[0]; ++octave, frequency *= a.p[1], size *= a.p[2])
        sum += size * noise_at(frequency * a.x, frequency * a.y, frequency * a.z, octave);
    return sum;
}

double cells(const Arguments& a) {
    const auto distance = [&a](int rank) {
        return cellular_reference(rank, static_cast<std::uint32_t>(a.p[0]), MpfrNumber(a.x),
                                  MpfrNumber(a.y), MpfrNumber(a.z))
            .nearest();
    };
    return a.p[2] == 0 ? distance(1) : distance(2) - distance(1);
}

}  // namespace

References noise_references() {
    return {{"f_noise3d", [](const Arguments& a) { return 0.5 + 0.5 * noise_at(a.x, a.y, a.z); }},
            {"f_snoise3d", [](const Arguments& a) { return noise_at(a.x, a.y, a.z); }},
            {"f_ridged_mf", ridges},
            {"NoiseP", octaves},
            {"NoiseW", cells}};
}

}  // namespace zeroset::test
