#include "tests/support/kernel_batch.hpp"

#include "engine/num/rounding.hpp"

#include <bit>
#include <cmath>

namespace zeroset::test {
namespace {

void append_bits(std::vector<std::uint32_t>& bits, const std::vector<float>& values) {
    constexpr std::uint32_t some_nan = 0x7fc00000;
    for (const float value : values) {
        bits.push_back(std::isnan(value) ? some_nan : std::bit_cast<std::uint32_t>(value));
    }
}

}  // namespace

Bits one_item(const Interval<float>& range, bool continuous, float value,
              const std::array<float, 3>& gradient) {
    Bits bits;
    append_bits(bits.range, {range.neg_lo, range.hi});
    bits.range.push_back(continuous ? ~0U : 0U);
    append_bits(bits.value, {value});
    for (const float slope : gradient)
        append_bits(bits.value, {std::isnan(value) ? value : slope});
    return bits;
}

Bits item(const Bits& batch, std::size_t item) {
    const auto every = [item](const std::vector<std::uint32_t>& all, std::size_t rows) {
        std::vector<std::uint32_t> one;
        for (std::size_t row = 0; row < rows; ++row)
            one.push_back(all[row * (all.size() / rows) + item]);
        return one;
    };
    return {every(batch.range, 3), every(batch.value, 4)};
}

std::array<Interval<float>, 3> KernelBatch::box(std::size_t item) const {
    return {Interval<float>{neg_lo_[0][item], hi_[0][item]},
            {neg_lo_[1][item], hi_[1][item]},
            {neg_lo_[2][item], hi_[2][item]}};
}

std::array<float, 3> KernelBatch::point(std::size_t item) const {
    return {x_[0][item], x_[1][item], x_[2][item]};
}

KernelBatch::KernelBatch(RandomNumbers& random, std::size_t count) : count_(count) {
    for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto box = random.interval<float>();
            neg_lo_[v].push_back(box.neg_lo);
            hi_[v].push_back(box.hi);
            x_[v].push_back(random.number<float>());
        }
    }
    const double w = random.uniform(-2, 2);
    uniforms.set(0, w, w + random.uniform());
}

void KernelBatch::run_range(const Kernel& kernel, std::vector<std::uint32_t>& bits) const {
    std::vector<float> f_neg_lo(count_);
    std::vector<float> f_hi(count_);
    std::vector<std::uint32_t> continuous(count_, 0xabcd);
    kernel.range({count_,
                  {neg_lo_[0].data(), neg_lo_[1].data(), neg_lo_[2].data()},
                  {hi_[0].data(), hi_[1].data(), hi_[2].data()},
                  uniforms.neg_lo_hi.data(),
                  f_neg_lo.data(),
                  f_hi.data(),
                  continuous.data()});
    append_bits(bits, f_neg_lo);
    append_bits(bits, f_hi);
    bits.insert(bits.end(), continuous.begin(), continuous.end());
}

void KernelBatch::run_value(const Kernel& kernel, std::vector<std::uint32_t>& bits) const {
    std::vector<float> f(count_);
    std::vector<float> gradient[3] = {f, f, f};
    kernel.value({count_,
                  {x_[0].data(), x_[1].data(), x_[2].data()},
                  uniforms.middle.data(),
                  f.data(),
                  {gradient[0].data(), gradient[1].data(), gradient[2].data()}});
    append_bits(bits, f);
    for (auto& slope : gradient) {
        for (std::size_t i = 0; i < count_; ++i) {
            if (std::isnan(f[i])) slope[i] = f[i];
        }
        append_bits(bits, slope);
    }
}

Bits KernelBatch::run(const Kernel& kernel) const {
    Bits bits;
    const UpwardRounding upward;
    run_range(kernel, bits.range);
    run_value(kernel, bits.value);
    return bits;
}

}  // namespace zeroset::test
