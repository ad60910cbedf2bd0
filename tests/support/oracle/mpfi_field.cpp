#include "tests/support/oracle/mpfi_field.hpp"

#include "engine/volume/volume.hpp"
#include "tests/support/sample_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace zeroset::test {
namespace {

using Enclosure = MpfiInterval;

Enclosure at_end(mpfr_srcptr end) {
    Enclosure point;
    mpfi_set_fr(point.get(), end);
    return point;
}

/// One cell with the part of a box in it: its index and the shares of the part's two ends.
struct CellPart {
    std::array<std::int64_t, 3> cell{};
    std::array<std::array<Enclosure, 2>, 3> ends;
};

class FieldBox {
public:
    FieldBox(const Volume& volume, const std::array<const Enclosure*, 3>& world) : volume_(volume) {
        const IndexMap& map = volume.data().map();
        for (std::size_t i = 0; i < 3; ++i) {
            Enclosure index(map.shift[i]);
            for (std::size_t c = 0; c < 3; ++c)
                index = index + Enclosure(map.index_from_world[i][c]) * *world[c];
            const auto end = static_cast<double>(volume.data().samples().size[i] - 1);
            outside_ = outside_ || index.is_below(0) || index.is_above(end);
            inside_ = inside_ && mpfr_sgn(index.lo()) >= 0 && mpfr_cmp_d(index.hi(), end) <= 0;
            moves_[i] = index.is_above(0) && index.is_below(end);
            index_[i] = minimum(maximum(index, Enclosure(0.0)), Enclosure(end));
            const auto last_cell = static_cast<std::int64_t>(end) - 1;
            first_[i] = std::min(static_cast<std::int64_t>(index_[i].lower()), last_cell);
            last_[i] = std::min(static_cast<std::int64_t>(index_[i].upper()), last_cell);
        }
    }

    /// Whether it is surely beyond the grid, and surely within.
    [[nodiscard]] bool outside() const { return outside_; }
    [[nodiscard]] bool inside() const { return inside_; }
    [[nodiscard]] std::int64_t cells() const {
        std::int64_t count = 1;
        for (std::size_t i = 0; i < 3; ++i)
            count *= last_[i] - first_[i] + 1;
        return count;
    }

    /// Calls visit(part) for each cell that the box meets.
    void each_cell(auto visit) const {
        CellPart part;
        for (part.cell[2] = first_[2]; part.cell[2] <= last_[2]; ++part.cell[2]) {
            for (part.cell[1] = first_[1]; part.cell[1] <= last_[1]; ++part.cell[1]) {
                for (part.cell[0] = first_[0]; part.cell[0] <= last_[0]; ++part.cell[0]) {
                    for (std::size_t i = 0; i < 3; ++i) {
                        const Enclosure from(static_cast<double>(part.cell[i]));
                        part.ends[i] = {maximum(at_end(index_[i].lo()) - from, Enclosure(0.0)),
                                        minimum(at_end(index_[i].hi()) - from, Enclosure(1.0))};
                    }
                    visit(part);
                }
            }
        }
    }
    /// The number at corners (which[0], which[1], which[2]) of the part, or with `slope` an axis
    /// the slope along it between the other two.
    [[nodiscard]] Enclosure value(const CellPart& part, const std::array<std::size_t, 3>& which,
                                  std::optional<std::size_t> slope) const {
        Enclosure sum(0.0);
        for (unsigned corner = 0; corner < 8; ++corner) {
            const std::array<unsigned, 3> of{corner & 1U, corner >> 1U & 1U, corner >> 2U};
            const auto place = [&](std::size_t i) {
                return static_cast<std::uint64_t>(part.cell[i] + of[i]);
            };
            Enclosure term(sample_at(volume_.data(), place(0), place(1), place(2)));
            for (std::size_t i = 0; i < 3; ++i) {
                if (slope == i) {
                    if (of[i] == 0) term = -term;
                } else {
                    const Enclosure& share = part.ends[i][which[i]];
                    term = term * (of[i] == 1 ? share : Enclosure(1.0) - share);
                }
            }
            sum = sum + term;
        }
        return sum;
    }
    [[nodiscard]] Enclosure hull_of(std::optional<std::size_t> slope) const {
        constexpr std::int64_t most_cells = 64;
        if (cells() > most_cells) {
            const SampleRange& range = volume_.data().range();
            const Enclosure samples(range.lo, range.hi);
            return slope ? hull(samples - samples, Enclosure(0.0)) : samples;
        }
        std::optional<Enclosure> all;
        if (slope && !moves_[*slope]) all = Enclosure(0.0);
        each_cell([&](const CellPart& part) {
            for (unsigned corner = 0; corner < 8; ++corner) {
                const Enclosure one =
                    value(part, {corner & 1U, corner >> 1U & 1U, corner >> 2U}, slope);
                all = all ? hull(*all, one) : one;
            }
        });
        return *all;
    }

private:
    const Volume& volume_;
    std::array<Enclosure, 3> index_;
    std::array<bool, 3> moves_{};
    bool outside_ = false, inside_ = true;
    std::array<std::int64_t, 3> first_{}, last_{};
};

}  // namespace

MpfiEnclosure enclosed_field(const Field& field, const MpfiEnclosure& a, const MpfiEnclosure& b,
                             const MpfiEnclosure& c) {
    const auto& volume = dynamic_cast<const Volume&>(field);
    const FieldBox box(volume, {&a.range, &b.range, &c.range});
    MpfiEnclosure result;
    result.range = box.hull_of(std::nullopt);
    result.somewhere = a.somewhere && b.somewhere && c.somewhere;
    result.everywhere = a.everywhere && b.everywhere && c.everywhere;
    result.continuous = a.continuous && b.continuous && c.continuous;
    if (volume.data().range().holes) result.everywhere = false;
    if (volume.options().outside == Outside::Undefined) {
        result.somewhere = result.somewhere && !box.outside();
        result.everywhere = result.everywhere && box.inside();
    } else if (volume.options().outside == Outside::Constant && !box.inside()) {
        const Enclosure beyond(volume.options().constant);
        result.range = box.outside() ? beyond : hull(result.range, beyond);
        result.continuous = result.continuous && box.outside();
    }
    return result;
}

MpfiInterval slope_of_field(const Field& field, const MpfiDual& a, const MpfiDual& b,
                            const MpfiDual& c) {
    const auto& volume = dynamic_cast<const Volume&>(field);
    const FieldBox box(volume, {&a.value.range, &b.value.range, &c.value.range});
    const std::array<const Enclosure*, 3> slopes{&a.slope, &b.slope, &c.slope};
    Enclosure sum(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        const Enclosure by_index = box.hull_of(i);
        for (std::size_t k = 0; k < 3; ++k) {
            sum =
                sum + Enclosure(volume.data().map().index_from_world[i][k]) * by_index * *slopes[k];
        }
    }
    return sum;
}

}  // namespace zeroset::test
