#include "engine/special/pieces.hpp"

#include "engine/special/piece_maker.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace zeroset {
namespace {

constexpr auto coefficient_count = static_cast<std::size_t>(piece_degree) + 1;

/// n (n - 1) ... (n - order + 1) for each order and n.
constexpr auto falling_factorials = [] {
    std::array<std::array<double, coefficient_count>, known_orders> table{};
    for (std::size_t order = 0; order < known_orders; ++order) {
        for (std::size_t n = 0; n < coefficient_count; ++n) {
            table[order][n] = order == 0 ? 1 : n < order ? 0 : table[order - 1][n];
            if (order > 0 && n >= order) table[order][n] *= static_cast<double>(n - order + 1);
        }
    }
    return table;
}();

double scale_of(const Piece& piece, std::size_t order) {
    double scale = 1;
    for (std::size_t i = 0; i < order; ++i)
        scale *= piece.per_half;  // exact: a power of 2
    return scale;
}

/// Horner's rule for a polynomial and its derivative, for four samples side by side, as the steps
/// of one wait for each other. Those beyond `count` are the first one again.
template <std::size_t order>
void evaluate_four(PieceSample* samples, std::size_t count) {
    constexpr std::size_t together = 4;
    std::array<const double*, together> coefficients{};
    std::array<double, together> t{};
    std::array<double, together> value{};
    std::array<double, together> slope{};
    for (std::size_t i = 0; i < together; ++i) {
        const PieceSample& sample = samples[i < count ? i : 0];
        coefficients[i] = sample.piece->coefficients.data();
        t[i] = sample.t;
    }
    for (std::size_t n = coefficient_count; n-- > order;) {
        for (std::size_t i = 0; i < together; ++i) {
            slope[i] = slope[i] * t[i] + value[i];
            value[i] = value[i] * t[i] + falling_factorials[order][n] * coefficients[i][n];
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double scale = scale_of(*samples[i].piece, order);
        samples[i].value = value[i] * scale;
        samples[i].slope = slope[i] * (scale * samples[i].piece->per_half);
    }
}

template <std::size_t order>
void evaluate_order(std::span<PieceSample> samples) {
    for (std::size_t first = 0; first < samples.size(); first += 4)
        evaluate_four<order>(&samples[first], std::min<std::size_t>(4, samples.size() - first));
}

/// floor(log2(x)) of a number above 0; less than it is for those below the smallest normal one.
int octave_of(double x) {
    constexpr std::uint64_t exponent = 0x7FF;
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52U & exponent) - 1023;
}

}  // namespace

double Piece::at(double x, int order) const {
    const double t = (x - middle) * per_half;
    const auto s = static_cast<std::size_t>(order);
    double value = 0;
    for (std::size_t n = coefficient_count; n-- > s;)
        value = value * t + falling_factorials[s][n] * coefficients[n];
    return value * scale_of(*this, s);
}

void evaluate(std::span<PieceSample> samples, int order) {
    switch (order) {
        case 0: return evaluate_order<0>(samples);
        case 1: return evaluate_order<1>(samples);
        case 2: return evaluate_order<2>(samples);
        default: return evaluate_order<3>(samples);
    }
}

/// Pieces of the same width, their turns, and the largest of their errors.
struct Pieces::Block {
    double from = 0, per_width = 0;
    std::vector<Piece> pieces;
    std::array<std::vector<PieceTurn>, highest_ranged_order + 1> turns;
    std::array<double, known_orders> errors{};

    Block(const Analytic& f, std::size_t index) {
        const bool at_zero = f.from_zero && index == 0;
        const int octave = f.first + static_cast<int>(index) - (f.from_zero ? 1 : 0);
        const double start = std::ldexp(1.0, at_zero ? f.first : octave);
        const double width = std::min(0.125 * start, f.widest);
        from = at_zero ? 0 : start;
        per_width = 1 / width;
        const double to = std::min(at_zero ? start : 2 * start, f.end);
        for (double at = from; at < to; at += width)
            pieces.push_back(make_piece(f, at, width));
        for (const Piece& piece : pieces) {
            for (std::size_t order = 0; order < known_orders; ++order)
                errors[order] = std::max(errors[order], piece.errors[order]);
            for (std::size_t order = 0; order < turns.size(); ++order)
                add_turns(piece, static_cast<int>(order), turns[order]);
        }
        mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);  // which would leak at the end of a thread
    }

    [[nodiscard]] std::size_t index(double x) const {
        const auto at = static_cast<std::size_t>(std::max(0.0, (x - from) * per_width));
        return std::min(at, pieces.size() - 1);
    }
};

Pieces::Pieces(Analytic f)
    : f_(std::move(f)),
      start_(f_.from_zero ? 0 : std::ldexp(1.0, f_.first)),
      last_(static_cast<std::size_t>(octave_of(std::nextafter(f_.end, 0.0)) - f_.first +
                                     (f_.from_zero ? 1 : 0))),
      blocks_(last_ + 1) {}

Pieces::~Pieces() {
    for (const auto& block : blocks_)
        delete block.load();
}

std::size_t Pieces::block_at(double x) const {
    const int octave = x > 0 ? octave_of(x) - f_.first : -1;
    const int index = octave + (f_.from_zero ? 1 : 0);
    return std::min(static_cast<std::size_t>(std::max(index, 0)), last_);
}

const Pieces::Block& Pieces::block(std::size_t index) const {
    if (const Block* const known = blocks_[index].load(std::memory_order_acquire)) return *known;
    const std::scoped_lock lock(mutex_);
    if (blocks_[index].load(std::memory_order_acquire) == nullptr)
        blocks_[index].store(std::make_unique<Block>(f_, index).release(),
                             std::memory_order_release);
    return *blocks_[index].load(std::memory_order_acquire);
}

const Piece* Pieces::piece(double x) const {
    if (!(x >= start_ && x < f_.end)) return nullptr;
    const Block& in = block(block_at(x));
    return &in.pieces[in.index(x)];
}

void Pieces::add_inner(double lo, double hi, int order, ValueBounds& bounds) const {
    if (lo <= 0 || lo < start_) {
        const Piece& first = block(0).pieces.front();
        const double at_start = first.at(start_, order);
        const double error = first.errors[static_cast<std::size_t>(order)];
        bounds.add({.lo = at_start - error, .hi = at_start + error});
    }
    if (lo < start_) {
        const bool up = (f_.sign_at_zero > 0) == (order % 2 == 0);
        bounds.add(up ? ValueBounds{.lo = unbounded, .hi = unbounded}
                      : ValueBounds{.lo = -unbounded, .hi = -unbounded});
    }
    if (hi >= f_.end) bounds.add(f_.beyond(order));
    if (lo >= f_.end) return;
    constexpr double wide = 16;
    if (hi > f_.far && hi - lo > wide) {
        bounds.add(f_.everywhere ? f_.everywhere(order)
                                 : ValueBounds{.lo = -unbounded, .hi = unbounded});
        return;
    }
    const double from = std::max(lo, start_);
    const double to = std::min(hi, f_.end);
    if (!(from <= to)) return;
    for (std::size_t index = block_at(from); index <= block_at(to); ++index) {
        const auto& turns = block(index).turns[static_cast<std::size_t>(order)];
        auto turn = std::ranges::lower_bound(turns, from, {}, &PieceTurn::to);
        for (; turn != turns.end() && turn->from <= to; ++turn)
            bounds.add(turn->bounds);
    }
}

double Pieces::error_over(double lo, double hi, int order) const {
    const auto s = static_cast<std::size_t>(order);
    const Piece* const first = piece(lo);
    const Piece* const last = piece(hi);
    if (first != nullptr && first == last) return first->errors[s];
    double error = hi < f_.end ? 0 : error_beyond;
    for (std::size_t index = block_at(lo); index <= block_at(std::min(hi, f_.end)); ++index) {
        const Block* const known = blocks_[index].load(std::memory_order_acquire);
        error = std::max(error, known != nullptr ? known->errors[s] : unbounded);
    }
    return error;
}

}  // namespace zeroset
