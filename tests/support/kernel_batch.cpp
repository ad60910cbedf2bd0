#include "tests/support/kernel_batch.hpp"

#include "engine/real/rounding.hpp"

#include <bit>
#include <cmath>

namespace zeroset::test {
namespace {

template <class Real>
void append_bits(std::vector<std::uint64_t>& bits, const std::vector<Real>& values) {
    constexpr std::uint64_t some_nan = 0x7ff8'0000'0000'0000;
    for (const Real value : values) {
        bits.push_back(std::isnan(value) ? some_nan : std::bit_cast<ContinuityMask<Real>>(value));
    }
}

}  // namespace

Bits one_item(const Interval<float>& range, bool continuous, float value,
              const std::array<float, 3>& gradient) {
    Bits bits;
    append_bits<float>(bits.range, {range.neg_lo, range.hi});
    bits.range.push_back(continuous ? ~0U : 0U);
    append_bits<float>(bits.value, {value});
    for (const float slope : gradient)
        append_bits<float>(bits.value, {std::isnan(value) ? value : slope});
    return bits;
}

Bits item(const Bits& batch, std::size_t item) {
    const auto every = [item](const std::vector<std::uint64_t>& all, std::size_t rows) {
        std::vector<std::uint64_t> one;
        for (std::size_t row = 0; row < rows; ++row)
            one.push_back(all[row * (all.size() / rows) + item]);
        return one;
    };
    return {every(batch.range, 3), every(batch.value, 4)};
}

template <class Real>
std::array<Interval<Real>, 3> KernelBatchOf<Real>::box(std::size_t item) const {
    return {Interval<Real>{neg_lo_[0][item], hi_[0][item]},
            {neg_lo_[1][item], hi_[1][item]},
            {neg_lo_[2][item], hi_[2][item]}};
}

template <class Real>
std::array<Real, 3> KernelBatchOf<Real>::point(std::size_t item) const {
    return {x_[0][item], x_[1][item], x_[2][item]};
}

template <class Real>
KernelBatchOf<Real>::KernelBatchOf(RandomNumbers& random, std::size_t count) : count_(count) {
    for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto box = random.interval<Real>();
            neg_lo_[v].push_back(box.neg_lo);
            hi_[v].push_back(box.hi);
            x_[v].push_back(random.number<Real>());
        }
    }
    const double w = random.uniform(-2, 2);
    uniforms.set(0, w, w + random.uniform());
}

template <class Real>
void KernelBatchOf<Real>::run_range(const Kernel& kernel, std::vector<std::uint64_t>& bits) const {
    std::vector<Real> f_neg_lo(count_);
    std::vector<Real> f_hi(count_);
    std::vector<ContinuityMask<Real>> continuous(count_, 0xabcd);
    kernel.range(RangeBatchOf<Real>{count_,
                                    {neg_lo_[0].data(), neg_lo_[1].data(), neg_lo_[2].data()},
                                    {hi_[0].data(), hi_[1].data(), hi_[2].data()},
                                    uniforms.boxes<Real>(),
                                    f_neg_lo.data(),
                                    f_hi.data(),
                                    continuous.data()});
    append_bits(bits, f_neg_lo);
    append_bits(bits, f_hi);
    bits.insert(bits.end(), continuous.begin(), continuous.end());
}

template <class Real>
void KernelBatchOf<Real>::run_value(const Kernel& kernel, std::vector<std::uint64_t>& bits) const {
    std::vector<Real> f(count_);
    std::vector<Real> gradient[3] = {f, f, f};
    kernel.value(ValueBatchOf<Real>{count_,
                                    {x_[0].data(), x_[1].data(), x_[2].data()},
                                    uniforms.points<Real>(),
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

template <class Real>
Bits KernelBatchOf<Real>::run(const Kernel& kernel) const {
    Bits bits;
    const UpwardRounding upward;
    run_range(kernel, bits.range);
    run_value(kernel, bits.value);
    return bits;
}

template class KernelBatchOf<float>;
template class KernelBatchOf<double>;

}  // namespace zeroset::test
