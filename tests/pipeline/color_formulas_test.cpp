#include "pipeline/color_formulas.hpp"

#include "engine/real/rounding.hpp"
#include "pipeline/input_error.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace zeroset::test::color_formulas_test {
namespace {

/// Returns the number that determines the colour of a point.
double value(const PointFunction& function, const Scene& scene, const glm::dvec3& at) {
    std::array<std::array<double, batch_multiple>, 3> x{};
    for (int k = 0; k < 3; ++k)
        x.at(static_cast<std::size_t>(k)).fill(at[k]);
    std::array<double, batch_multiple> f{};
    const UpwardRounding upward;
    function(ValueBatchOf<double>{batch_multiple,
                                  {x[0].data(), x[1].data(), x[2].data()},
                                  scene.uniforms.points<double>(),
                                  f.data(),
                                  {}});
    return f[0];
}

struct Colored {
    Colored(const std::string& text, const ColorChoice& choice,
            const std::map<std::string, double>& parameters = {}, double w = 0)
        : formula(*prepared_formula(text, Box())),
          formulas(color_formulas(formula, choice)),
          scene(make_scene(formula, Box(), w, parameters)) {}

    [[nodiscard]] double at(const glm::dvec3& point, std::size_t surface = 0) const {
        return value(formulas->values.at(surface), scene, point);
    }

    Formula formula;
    std::expected<ColorFormulas, InputError> formulas;
    Scene scene;
};

ColorChoice by(const std::string& expression) { return {ColorBy::Expression, expression}; }

TEST(ColorFormulas, ReadExpressionsWithWTheParametersAndTheDefinitions) {
    const Colored colored("g(u) = u^2; c = 5; b x + a y = z", by("g(x) + a w + b + c"),
                          {{"a", 2}, {"b", 100}}, 3);
    ASSERT_TRUE(colored.formulas.has_value()) << colored.formulas.error().reason;
    EXPECT_DOUBLE_EQ(colored.at({4, 0, 0}), 16 + 6 + 100 + 5);
}

TEST(ColorFormulas, ReadExpressionsWithoutSpace) {
    const Colored colored("x = a", by("w"), {}, 0.25);
    ASSERT_TRUE(colored.formulas.has_value());
    EXPECT_DOUBLE_EQ(colored.at({1, 2, 3}), 0.25);
}

TEST(ColorFormulas, AreOfEachSurface) {
    const Colored colored("x^2 + y^2 + z^2 = 4; x^2 + y^2 = a", {ColorBy::MeanCurvature},
                          {{"a", 1}});
    ASSERT_EQ(colored.formulas->values.size(), 2U);
    EXPECT_NEAR(colored.at({0, 2, 0}, 0), 0.5, 1e-15);
    EXPECT_NEAR(colored.at({0, 1, 7}, 1), 0.5, 1e-15);
    const Colored gaussian("x^2 + y^2 + z^2 = 4; x^2 + y^2 = a", {ColorBy::GaussianCurvature});
    EXPECT_NEAR(gaussian.at({0, 2, 0}, 0), 0.25, 1e-15);
    EXPECT_NEAR(gaussian.at({0, 1, 7}, 1), 0.0, 1e-15);
    const Colored steep("x^2 + y^2 + z^2 = 4", {ColorBy::Gradient});
    EXPECT_NEAR(steep.at({0, 2, 0}), 4.0, 1e-15);
}

TEST(ColorFormulas, OfAQuotientAreThoseOfWhatWasTyped) {
    // The traceable form has no denominator, but the colour is that of the typed formula.
    const Colored steep("x/(1 + z^2) = 1", {ColorBy::Gradient});
    EXPECT_NEAR(steep.at({1, 0, 0}), 1.0, 1e-15);
    EXPECT_NEAR(steep.at({5, 0, 2}), std::hypot(0.2, 0.8), 1e-15);
}

std::string reason(const std::string& expression) {
    const Colored colored("a x^2 + y^2 = z", by(expression));
    return colored.formulas ? "" : colored.formulas.error().reason;
}

TEST(ColorFormulas, SayWhatIsWrongWithAnExpression) {
    EXPECT_EQ(reason("x +* y").empty(), false);
    EXPECT_EQ(reason("b x"), "there is no parameter 'b'; the formula's are a");
    EXPECT_EQ(reason("x = 1"),
              "an expression is needed here, no equation and no condition; type a value such as "
              "x^2 + y^2");
    EXPECT_EQ(reason("x < 1"), reason("x = 1"));
    EXPECT_EQ(reason("").empty(), false);
    EXPECT_EQ(reason("x; y"), "there is a second expression; type one of them");
    EXPECT_EQ(reason("  "), "there is no expression to color by; type one such as x^2 + y^2");
    const Colored colored("x = 1", by("x + q(2"));
    ASSERT_FALSE(colored.formulas.has_value());
    EXPECT_LE(*colored.formulas.error().offset, std::string("x + q(2").size());
}

TEST(Coloring, FollowsTheChoiceAndTheSurfacesShown) {
    const Colored colored("x = 1; x^2 + y^2 = 2", {ColorBy::Gradient});
    ColorChoice choice{ColorBy::Gradient};
    choice.range = ValueRange{1, 2};
    const Coloring coloring =
        coloring_of(choice, *colored.formulas, {1}, {0.1, -0.9, 0.2}, Box::cube(2));
    EXPECT_EQ(coloring.by, ColorBy::Gradient);
    EXPECT_EQ(coloring.map, ColorMap::Aurora);
    EXPECT_EQ(coloring.range, (ValueRange{1, 2}));
    ASSERT_EQ(coloring.values.size(), 1U);
    EXPECT_EQ(coloring.values[0], colored.formulas->values[1]);
    EXPECT_EQ(coloring.up, glm::dvec3(0, -1, 0));
}

}  // namespace
}  // namespace zeroset::test::color_formulas_test
