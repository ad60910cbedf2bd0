#include "tests/support/library_references.hpp"
#include "tests/support/noise_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

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

/// The sum of `count` octaves of noise, or of its absolute values; the first cell has the size
/// 1/first.
double halving_octaves(const Arguments& a, std::uint32_t count, double first, bool absolute) {
    double sum = 0;
    for (std::uint32_t octave = 0; octave < count; ++octave) {
        const double frequency = first * std::pow(2.0, octave);
        const double noise = noise_at(frequency * a.x, frequency * a.y, frequency * a.z, octave);
        sum += (absolute ? std::abs(noise) : noise) * std::pow(0.5, octave);
    }
    return sum;
}

double agate(const Arguments& a) {
    // POV-Ray adds 1/2 to the noise of each octave.
    const double bent = halving_octaves(a, 6, 1, false) + 63.0 / 64.0;
    return std::pow((1 + std::sin(2 * std::numbers::pi * (1.3 * bent + 1.1 * a.z))) / 2, 0.77);
}

double crackle(const Arguments& a) {
    const auto distance = [&a](int rank) {
        return cellular_reference(rank, 0, MpfrNumber(a.x), MpfrNumber(a.y), MpfrNumber(a.z))
            .nearest();
    };
    return std::min(1.0, distance(2) - distance(1));
}

double noise_from_0(const Arguments& a) { return 0.5 + 0.5 * noise_at(a.x, a.y, a.z); }

}  // namespace

References noise_references() {
    return {{"f_noise3d", noise_from_0},
            {"f_bozo", noise_from_0},
            {"f_bumps", noise_from_0},
            {"f_spotted", noise_from_0},
            {"f_dents", [](const Arguments& a) { return std::pow(noise_from_0(a), 3); }},
            {"f_agate", agate},
            {"f_crackle", crackle},
            {"f_granite", [](const Arguments& a) { return halving_octaves(a, 6, 4, true); }},
            {"f_wrinkles", [](const Arguments& a) { return halving_octaves(a, 10, 1, true) / 2; }},
            {"f_snoise3d", [](const Arguments& a) { return noise_at(a.x, a.y, a.z); }},
            {"f_ridged_mf", ridges},
            {"NoiseP", octaves},
            {"NoiseW", cells}};
}

}  // namespace zeroset::test
