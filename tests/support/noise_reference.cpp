#include "tests/support/noise_reference.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace zeroset::test {
namespace {

constexpr std::uint64_t two_to_32 = std::uint64_t{1} << 32U;

/// lowbias32, by remainders of 2^32.
std::uint64_t lowbias(std::uint64_t x) {
    x = (x ^ (x / 65536)) * 0x7FEB352D % two_to_32;
    x = (x ^ (x / 32768)) * 0x846CA68B % two_to_32;
    return x ^ (x / 65536);
}

std::uint64_t remainder_of(std::int64_t i) {
    const auto period = static_cast<std::int64_t>(two_to_32);
    return static_cast<std::uint64_t>(((i % period) + period) % period);
}

/// A coordinate as a cell modulo 2^32 and a share of it.
struct Coordinate {
    std::int64_t cell;
    MpfrNumber share;
};

Coordinate split(const MpfrNumber& x) {
    MpfrNumber below;
    mpfr_floor(below.get(), x.get());
    MpfrNumber turns;
    mpfr_div_2ui(turns.get(), below.get(), 32, MPFR_RNDN);
    mpfr_floor(turns.get(), turns.get());
    mpfr_mul_2ui(turns.get(), turns.get(), 32, MPFR_RNDN);
    return {.cell = static_cast<std::int64_t>(mpfr_get_d((below - turns).get(), MPFR_RNDN)),
            .share = x - below};
}

MpfrNumber fade(const MpfrNumber& t) {
    const MpfrNumber cube = t * t * t;
    return MpfrNumber(6.0) * cube * t * t - MpfrNumber(15.0) * cube * t + MpfrNumber(10.0) * cube;
}

/// The gradient's product with a vector, as [Perlin02] prints it.
MpfrNumber perlin_grad(std::uint32_t h, const MpfrNumber& x, const MpfrNumber& y,
                       const MpfrNumber& z) {
    const MpfrNumber& u = h < 8 ? x : y;
    const MpfrNumber& v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
    return ((h & 1U) == 0 ? u : -u) + ((h & 2U) == 0 ? v : -v);
}

}  // namespace

std::uint32_t reference_hash(std::uint32_t seed, std::int64_t i, std::int64_t j, std::int64_t k) {
    std::uint64_t hash = lowbias((seed + std::uint64_t{0x9E3779B9}) % two_to_32);
    for (const std::int64_t coordinate : {i, j, k})
        hash = lowbias(hash ^ remainder_of(coordinate));
    return static_cast<std::uint32_t>(hash);
}

MpfrNumber lattice_noise_reference(NoiseKind kind, std::uint32_t seed, const MpfrNumber& x,
                                   const MpfrNumber& y, const MpfrNumber& z) {
    const std::array at{split(x), split(y), split(z)};
    MpfrNumber sum(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const std::array of{corner % 2, corner / 2 % 2, corner / 4};
        const std::uint32_t hash =
            reference_hash(seed, at[0].cell + of[0], at[1].cell + of[1], at[2].cell + of[2]);
        std::array<MpfrNumber, 3> from;
        MpfrNumber weight(1.0);
        for (std::size_t i = 0; i < 3; ++i) {
            from[i] = at[i].share - MpfrNumber(static_cast<double>(of[i]));
            const MpfrNumber s = fade(at[i].share);
            weight = weight * (of[i] == 1 ? s : MpfrNumber(1.0) - s);
        }
        // The twelve directions are numbered as in the paper up to 11; then 12 to 15 are doubles.
        const MpfrNumber number = kind == NoiseKind::Value
                                      ? MpfrNumber(static_cast<double>(hash / 256) / 8388608.0 - 1)
                                      : perlin_grad(hash / 268435456U, from[0], from[1], from[2]);
        sum = sum + weight * number;
    }
    return sum;
}

MpfrNumber cellular_reference(int rank, std::uint32_t seed, const MpfrNumber& x,
                              const MpfrNumber& y, const MpfrNumber& z) {
    constexpr int far = 3;
    const std::array at{split(x), split(y), split(z)};
    std::vector<MpfrNumber> squares;
    constexpr int side = 2 * far + 1;
    for (int n = 0; n < side * side * side; ++n) {
        const std::array step{n % side - far, n / side % side - far, n / (side * side) - far};
        const std::uint64_t hash =
            reference_hash(seed, at[0].cell + step[0], at[1].cell + step[1], at[2].cell + step[2]);
        MpfrNumber square(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const double inside = static_cast<double>(lowbias(hash ^ (i + 1)) / 256) / 16777216.0;
            const MpfrNumber from =
                at[i].share - MpfrNumber(static_cast<double>(step[i])) - MpfrNumber(inside);
            square = square + from * from;
        }
        squares.push_back(square);
    }
    const auto nth = squares.begin() + (rank - 1);
    std::ranges::nth_element(squares, nth, [](const MpfrNumber& a, const MpfrNumber& b) {
        return mpfr_less_p(a.get(), b.get()) != 0;
    });
    MpfrNumber root;
    mpfr_sqrt(root.get(), nth->get(), MPFR_RNDN);
    return root;
}

}  // namespace zeroset::test
