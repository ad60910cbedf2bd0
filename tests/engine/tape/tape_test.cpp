#include "engine/tape/tape.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/rewrite/passes.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

// Specialized kernels against whole ones, at points of the cells that they were specialized for.

namespace zeroset::test::tape_test {
namespace {

constexpr std::size_t cells = batch_multiple;
constexpr double distance = 4.0;
constexpr double radius = 0.05;  ///< of u and v

/// Cells of a view along z: the point at depth s on the ray of (u, v) is (u (4 + s), v (4 + s), s).
template <class Real>
struct View {
    std::array<Real, cells> u, v, s, s_radius;
    FrustumOf<Real> frustum{{0, 0, 0},    {1, 0, 0},    {0, 1, 0}, {0, 0, 1}, distance,
                            Real(radius), Real(radius), {4, 4, 2}, {1, 1, 1}};
    Uniforms uniforms;

    /// Some cells of a tile one behind the other.
    explicit View(RandomNumbers& random) {
        const double column = random.uniform(-0.2, 0.2);
        const double row = random.uniform(-0.2, 0.2);
        for (std::size_t i = 0; i < cells; ++i) {
            u[i] = static_cast<Real>(column);
            v[i] = static_cast<Real>(row);
            s[i] = static_cast<Real>(-1.0 + 2.0 * static_cast<double>(i) / cells);
            s_radius[i] = Real(1.0 / cells);
        }
        uniforms.set(0, 0.5);
    }
    [[nodiscard]] std::array<Real, 3> point_in(std::size_t cell, RandomNumbers& random) const {
        const double at = static_cast<double>(s[cell]) + random.uniform(-1, 1) / cells;
        const auto across = [&](Real middle) {
            return (static_cast<double>(middle) + random.uniform(-radius, radius)) *
                   (distance + at);
        };
        return {static_cast<Real>(across(u[cell])), static_cast<Real>(across(v[cell])),
                static_cast<Real>(at)};
    }
};

template <class Real>
struct FormColumns {
    std::array<Real, cells> c, e, r, slope_neg_lo, slope_hi;
    std::array<std::array<Real, cells>, 3> k;
    std::array<ContinuityMask<Real>, cells> continuous, nowhere;

    FormBatchOf<Real> batch(const View<Real>& view) {
        return {cells,
                view.u.data(),
                view.v.data(),
                view.s.data(),
                view.s_radius.data(),
                view.frustum.base,
                view.uniforms.template boxes<Real>(),
                c.data(),
                {k[0].data(), k[1].data(), k[2].data()},
                e.data(),
                r.data(),
                slope_neg_lo.data(),
                slope_hi.data(),
                continuous.data(),
                nowhere.data()};
    }
    /// How far f is from 0 at least, and the reach of its enclosure.
    [[nodiscard]] double reach(std::size_t i) const {
        return static_cast<double>(std::abs(k[0][i]) + std::abs(k[1][i]) + std::abs(k[2][i]) +
                                   e[i]);
    }
};

template <class Real>
Real value_of(const Kernel& kernel, const View<Real>& view, const std::array<Real, 3>& point) {
    std::array<std::array<Real, cells>, 7> columns{};
    for (std::size_t k = 0; k < 3; ++k)
        columns[k].fill(point[k]);
    kernel.value(ValueBatchOf<Real>{cells,
                                    {columns[0].data(), columns[1].data(), columns[2].data()},
                                    view.uniforms.template points<Real>(),
                                    columns[3].data(),
                                    {columns[4].data(), columns[5].data(), columns[6].data()}});
    return columns[3][0];
}

/// A formula of some spheres and planes, with every choice.
std::string random_solid(RandomNumbers& random, int depth) {
    const auto number = [&] { return std::to_string(random.uniform(-0.7, 0.7)); };
    if (depth == 0) {
        return "((x - " + number() + ")^2 + (y - " + number() + ")^2 + (z - " + number() +
               ")^2 - 0.1)";
    }
    const std::string a = random_solid(random, depth - 1);
    const std::string b = random_solid(random, depth - 1);
    switch (random.below(9)) {
        case 0:
        case 1: return "min(" + a + ", " + b + ")";
        case 2: return "max(" + a + ", " + b + ")";
        case 3: return "max(" + a + ", -" + b + ")";
        case 4: return "if(x + y < " + number() + ", " + a + ", " + b + ")";
        case 5: return "min(" + a + ", sqrt(" + b + " + 0.3) - 0.4)";
        case 6: return "smooth_union(" + a + ", " + b + ", 0.2)";
        case 7: return "smooth_subtract(" + a + ", " + b + ", 0.3)";
        default: return "(min(" + a + ", " + b + ") - max(0.1 - |" + a + " - " + b + "|, 0)^2)";
    }
}

Expr parsed(const std::string& text) {
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << text << ": " << expr.error().reason;
        return {};
    }
    return *expr;
}

/// Specializes `text` for one or some of a view's cells and compares there.
template <class Real>
class Comparison {
public:
    Comparison(std::string text, Kernel whole, RandomNumbers& random)
        : text_(std::move(text)), random_(random), view_(random), whole_(std::move(whole)) {
        ChoiceRecord record;
        const FormBatchOf<Real> batch = forms_.batch(view_);
        whole_.specializer->form(batch, record);
        first_ = random.below(cells);
        const std::size_t last = std::min(cells, first_ + 1 + random.below(3));
        for (std::size_t cell = first_; cell < last; ++cell)
            chosen_.push_back(cell);
        short_ = whole_.specializer->specialized(record, chosen_);
    }
    /// Whether it could be specialized at all.
    explicit operator bool() const { return short_ != nullptr; }

    /// Values of the whole and the short one at points of the cells.
    void compare(auto expectation) {
        for (const std::size_t cell : chosen_) {
            for (int i = 0; i < 4; ++i) {
                const auto point = view_.point_in(cell, random_);
                SCOPED_TRACE(text_ + " at " + std::to_string(point[0]) + ", " +
                             std::to_string(point[1]) + ", " + std::to_string(point[2]));
                expectation(value_of(whole_, view_, point), value_of(*short_, view_, point));
            }
        }
    }
    /// The short one's forms enclose the values of the whole, and are no wider but for roundings.
    void compare_forms() {
        FormColumns<Real> columns;
        short_->form(columns.batch(view_));
        for (const std::size_t cell : chosen_) {
            SCOPED_TRACE(text_);
            EXPECT_LE(columns.reach(cell), forms_.reach(cell) * 1.001 + 1e-5);
            const auto value =
                static_cast<double>(value_of(whole_, view_, view_.point_in(cell, random_)));
            if (std::isfinite(value) && std::isfinite(columns.e[cell])) {
                EXPECT_LE(std::abs(value - static_cast<double>(columns.c[cell])),
                          columns.reach(cell) + 2e-6);
            }
            EXPECT_EQ(columns.continuous[cell] | forms_.continuous[cell], columns.continuous[cell]);
            EXPECT_EQ(columns.nowhere[cell], forms_.nowhere[cell]);
        }
    }

private:
    std::string text_;
    RandomNumbers& random_;
    View<Real> view_;
    Kernel whole_;
    std::shared_ptr<const Kernel> short_;
    FormColumns<Real> forms_;
    std::size_t first_ = 0;
    std::vector<std::size_t> chosen_;
};

struct Whole {
    static Kernel kernel(const std::string& text) { return interpret(parsed(text)); }
};
struct InParts {
    static Kernel kernel(const std::string& text) { return interpret_with_parts(parsed(text)); }
};
/// With operators of their own for smooth unions and differences.
struct Blended {
    static Kernel kernel(const std::string& text) {
        return interpret(with_smooth_minima(parsed(text)));
    }
};
template <class Type, class Code>
struct Way : Code {
    using Real = Type;
};

template <class Way>
class SpecializedKernel : public testing::Test {};
using Ways = testing::Types<Way<float, Whole>, Way<double, Whole>, Way<float, InParts>,
                            Way<double, InParts>, Way<float, Blended>, Way<double, Blended>>;
TYPED_TEST_SUITE(SpecializedKernel, Ways);

constexpr int formulas = 700;

TYPED_TEST(SpecializedKernel, HasTheSignsOfTheWholeOne) {
    using Real = typename TypeParam::Real;
    RandomNumbers random(1);
    int specialized = 0;
    for (int i = 0; i < formulas; ++i) {
        const std::string text = random_solid(random, random.between(1, 4));
        const UpwardRounding upward;
        Comparison<Real> comparison(text, TypeParam::kernel(text), random);
        if (!comparison) continue;
        ++specialized;
        comparison.compare([](Real whole, Real part) {
            // A root of either may be rounded to the other side.
            if (std::abs(whole) < Real(1e-5)) return;
            EXPECT_EQ(std::isnan(whole), std::isnan(part));
            EXPECT_EQ(whole < 0, part < 0) << whole << " and " << part;
        });
    }
    EXPECT_GT(specialized, formulas / 4);
}

/// Under a sum nothing follows from signs.
TYPED_TEST(SpecializedKernel, HasTheValuesOfTheWholeOneWhereTheyMatter) {
    using Real = typename TypeParam::Real;
    RandomNumbers random(2);
    int specialized = 0;
    for (int i = 0; i < formulas; ++i) {
        const std::string text = random_solid(random, random.between(1, 4)) + " + 0.25x";
        const UpwardRounding upward;
        Comparison<Real> comparison(text, TypeParam::kernel(text), random);
        if (!comparison) continue;
        ++specialized;
        comparison.compare([](Real whole, Real part) {
            if (!(std::isnan(whole) && std::isnan(part))) {
                EXPECT_NEAR(static_cast<double>(whole), static_cast<double>(part), 2e-6);
            }
        });
        comparison.compare_forms();
    }
    EXPECT_GT(specialized, formulas / 8);
}

/// The number of choices that the tape of a formula keeps in cells where u and v are about 0 and s
/// is from -1 to 1.
std::optional<std::size_t> choices_left(const Expr& expr) {
    RandomNumbers random(3);
    View<float> view(random);
    view.u.fill(0);
    view.v.fill(0);
    FormColumns<float> columns;
    const UpwardRounding upward;
    const Kernel whole = interpret(expr);
    ChoiceRecord record;
    whole.specializer->form(columns.batch(view), record);
    std::vector<std::size_t> all(cells);
    for (std::size_t i = 0; i < cells; ++i)
        all[i] = i;
    const auto kernel = whole.specializer->specialized(record, all);
    if (!kernel) return std::nullopt;
    if (kernel->specializer == nullptr) return 0;
    kernel->specializer->form(columns.batch(view), record);
    return record.choices;
}

std::optional<std::size_t> choices_left(const std::string& text) {
    return choices_left(parsed(text));
}

TEST(Tape, LeavesOutWhatLosesEverywhere) {
    EXPECT_EQ(choices_left("min(x, 7 + y) + 1"), 0U);
    EXPECT_EQ(choices_left("max(x, 7 + y) + 1"), 0U);
    EXPECT_EQ(choices_left("if(z < 3, x, y) + 1"), 0U);
    EXPECT_EQ(choices_left("min(x, 7 + y) + z"), 0U);
    EXPECT_EQ(choices_left("max(x, 7 + y) + z"), 0U);
    EXPECT_EQ(choices_left("min(x, 7 + y, y) + z"), 1U);
    EXPECT_EQ(choices_left("if(z < 3, x, y) + z"), 0U);
    EXPECT_EQ(choices_left("min(x, y) + z"), std::nullopt);
}

TEST(Tape, LeavesOutWhatHasNoPartInTheZeros) {
    EXPECT_EQ(choices_left("min(z, 0.7 + x)"), 0U);
    EXPECT_EQ(choices_left("-max(z, x - 0.7)"), 0U);
    EXPECT_EQ(choices_left("max(z, 0.7 + x)"), std::nullopt);
    EXPECT_EQ(choices_left("min(z, 0.7 + x) + y"), std::nullopt);
    // The operand has a part in the zeros elsewhere.
    EXPECT_EQ(choices_left("min(min(z, 0.7 + x) + y, min(z, 0.7 + x))"), std::nullopt);
}

/// A term added to a choice moves the values that matter.
TEST(Tape, LeavesOutWhatIsFarFromTheValuesThatMatter) {
    EXPECT_EQ(choices_left("min(z, 0.9 + x) - 0.6"), 0U);
    EXPECT_EQ(choices_left("0.6 - min(z, 0.9 + x)"), 0U);
    EXPECT_EQ(choices_left("min(z, 0.9 + x) - 0.7"), std::nullopt);
    EXPECT_EQ(choices_left("max(z, x - 0.9) + 0.6"), 0U);
    EXPECT_EQ(choices_left("max(z, x - 0.9) + 0.8"), std::nullopt);
}

/// A blend of width k reaches as far above 0 as k and what it takes away at most.
TEST(Tape, LeavesOutWhatABlendDoesNotReach) {
    EXPECT_EQ(choices_left("smooth_union(z, 0.9 + x, 0.5)"), 0U);
    EXPECT_EQ(choices_left("smooth_union(0.9 + x, z, 0.5)"), 0U);
    EXPECT_EQ(choices_left("smooth_union(z, 0.9 + x, 0.6)"), std::nullopt);
    EXPECT_EQ(choices_left("smooth_intersect(z, x - 0.9, 0.5)"), 0U);
    EXPECT_EQ(choices_left("smooth_intersect(z, x - 0.9, 0.6)"), std::nullopt);
    EXPECT_EQ(choices_left("smooth_subtract(z, 0.9 + x, 0.5)"), 0U);
    EXPECT_EQ(choices_left("min(z, 1.1 + x) - max(0.5 - |z - (1.1 + x)|, 0)^2"), 0U);
    EXPECT_EQ(choices_left("min(z, 0.9 + x) - max(0.5 - |z - (0.9 + x)|, 0)^2"), std::nullopt);
    EXPECT_EQ(choices_left("max(z, x - 0.8) + 2max(0.3 - |z - (x - 0.8)|, 0)^2"), 0U);
    EXPECT_EQ(choices_left("max(z, x - 0.8) + 9max(0.3 - |z - (x - 0.8)|, 0)^2"), std::nullopt);
    // Not a blend: the width of its second part is that of other operands.
    EXPECT_EQ(choices_left("min(z, 0.9 + x) - max(0.5 - |z - (0.8 + x)|, 0)^2"), std::nullopt);
}

std::optional<std::size_t> blends_left(const std::string& text) {
    return choices_left(with_smooth_minima(parsed(text)));
}

/// The operator of its own reaches as far as its width, and its ends are known exactly.
TEST(Tape, LeavesOutWhatASmoothMinimumDoesNotReach) {
    EXPECT_EQ(blends_left("smooth_union(z, 0.9 + x, 0.6)"), 0U);
    EXPECT_EQ(blends_left("smooth_union(0.9 + x, z, 0.6)"), 0U);
    EXPECT_EQ(blends_left("smooth_union(z, 0.9 + x, 0.8)"), std::nullopt);
    EXPECT_EQ(blends_left("smooth_intersect(z, x - 0.9, 0.6)"), 0U);
    EXPECT_EQ(blends_left("smooth_subtract(z, 0.9 + x, 0.6)"), 0U);
    EXPECT_EQ(blends_left("smooth_union(z, 0.9 + x, 0.6) + y"), std::nullopt);
    EXPECT_EQ(blends_left("smooth_union(z, 1.9 + x, 0.6) + y"), 0U);
}

/// However many there are before it: each may take something away, all of them less than the width.
TEST(Tape, LeavesOutAllThatIsFarInAChainOfSmoothMinima) {
    std::string far;
    for (int i = 0; i < 100; ++i)
        far += "2.3 + x^2 + (y - " + std::to_string(i) + ")^2, ";
    EXPECT_EQ(blends_left("smooth_union(" + far + "z, 0.3)"), 0U);
    EXPECT_EQ(blends_left("smooth_union(z, " + far + "0.3)"), 0U);
}

TEST(Tape, LeavesOutLessInsideABlend) {
    const std::string outer = "smooth_union(y + z, smooth_union(y + 2z, ";
    EXPECT_EQ(choices_left(outer + "0.9 + x, 0.4), 0.4)"), std::nullopt);
    EXPECT_NE(choices_left(outer + "1.3 + x, 0.4), 0.4)"), std::nullopt);
}

/// The blend itself ends; its height is asked for elsewhere.
TEST(Tape, KeepsWhatABlendSharesWithOthers) {
    const std::string height = "max(0.5 - |z - (1 + x)|, 0)";
    EXPECT_EQ(choices_left("max(smooth_union(z, 1 + x, 0.5), y + " + height + ")"), 2U);
}

TEST(Tape, KeepsWhatMayBeUndefined) {
    EXPECT_EQ(choices_left("min(x, sqrt(z) + 7)"), std::nullopt);
    EXPECT_EQ(choices_left("min(x, sqrt(z + 2) + 7)"), 0U);
    EXPECT_EQ(choices_left("min(x, 1/z + 90)"), std::nullopt);
    EXPECT_EQ(choices_left("if(sqrt(z) < 3, x, y)"), std::nullopt);
}

/// The root of max(x, 0) relies on its operand not being negative.
TEST(Tape, KeepsWhatOthersRelyOn) {
    EXPECT_EQ(choices_left("sqrt(max(x + 2, 0)) + y"), std::nullopt);
    EXPECT_EQ(choices_left("sqrt(max(x^2 + 2, 0)) + y"), 0U);
}

}  // namespace
}  // namespace zeroset::test::tape_test
