#include "engine/image/framebuffer.hpp"
#include "engine/render/render.hpp"
#include "engine/scene/precision.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/formula.hpp"
#include "tests/support/formulas.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

// Draws formulas as people type them, from the text to the picture: one family of formulas for each
// kind that was once drawn wrongly.

namespace zeroset::test::formulas_as_typed_test {
namespace {

struct Drawn {
    Framebuffer frame;
    CertificateCounts counts;
    std::uint64_t evaluations = 0;

    [[nodiscard]] std::size_t hits() const {
        return counts.certified + counts.undecided - counts.not_drawn;
    }
};

Drawn drawn(const std::string& text, double half_edge, double d_stop = 22, int pixels = 48) {
    const Box clip{glm::dvec3(-half_edge), glm::dvec3(half_edge)};
    auto formula = compile_formula(text, clip, Precision::Float);
    if (!formula) {
        ADD_FAILURE() << text << ": " << formula.error().reason;
        return {};
    }
    TraceSettings settings;
    settings.stop.value = d_stop;
    settings.threads = 2;
    const Camera camera = default_camera(clip);
    const Precision precision =
        wanted_precision(make_scene(*formula, clip, 0.0, {}), ViewFrame(camera), settings.stop);
    if (!formula->has_code(precision)) formula = with_double(*formula);
    Drawn result{Framebuffer(pixels, pixels), {}};
    const Counters counters =
        render_frame(make_scene(*formula, clip, 0.0, {}), camera, settings, result.frame);
    result.evaluations = counters.range + counters.form + counters.value;
    result.counts = count_certificates(result.frame);
    return result;
}

std::string digits(double value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
}

bool is_hit(const Framebuffer& frame, std::size_t pixel) {
    return std::isfinite(frame.depth[pixel]);
}

/// Number of pixels in which the two pictures differ by more than a small tolerance.
int differing_pixels(const Framebuffer& a, const Framebuffer& b) {
    constexpr int tolerance = 3;
    int count = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i) {
        for (const unsigned shift : {0U, 8U, 16U}) {
            const auto channel = [&](const Framebuffer& frame) {
                return static_cast<int>(frame.color[i] >> shift & 0xFFU);
            };
            if (std::abs(channel(a) - channel(b)) <= tolerance) continue;
            ++count;
            break;
        }
    }
    return count;
}

/// Number of hits that are nearly black.
int black_pixels(const Framebuffer& frame) {
    int count = 0;
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        const std::uint32_t color = frame.color[i];
        const std::uint32_t brightest =
            std::max({color & 0xFFU, color >> 8U & 0xFFU, color >> 16U & 0xFFU});
        count += is_hit(frame, i) && brightest < 12 ? 1 : 0;
    }
    return count;
}

TEST(FormulasAsTyped, DrawNothingOutOfOverflow) {
    const std::pair<std::string, double> typed[] = {
        {"1 + exp(x)", 100},          {"1 + exp(x^2 + y^2 + z^2)", 6},
        {"1 + cosh(x y)", 15},        {"1 + sinh(x)^2", 200},
        {"0.5 + exp(exp(x + y))", 5}, {"x^60 + y^60 + z^60 + 1", 1000},
        {"2^(x y z) + 3^(-x)", 9},    {"1 + (x^2 + y^2)^40", 100}};
    for (const auto& [text, half_edge] : typed) {
        const Drawn picture = drawn(text, half_edge);
        EXPECT_EQ(picture.counts.certified + picture.counts.undecided, 0U) << text;
    }
}

TEST(FormulasAsTyped, OverflowLeavesTheRootsThatThereAre) {
    RandomNumbers random(3);
    for (int i = 0; i < 8; ++i) {
        const double c = random.uniform(-0.8, 0.8);
        const double scale = random.uniform(100, 400);
        const std::string at = "(x - (" + digits(c) + "))";
        const Drawn typed = drawn("exp(" + digits(scale) + " " + at + ") = 1", 1);
        const Drawn plane = drawn("x = " + digits(c), 1);
        EXPECT_EQ(typed.counts.certified, plane.counts.certified) << c << " " << scale;
        EXPECT_EQ(typed.counts.undecided, plane.counts.undecided) << c << " " << scale;
    }
}

TEST(FormulasAsTyped, DistancesOfBoxesHaveNoBlackFaces) {
    for (const std::string text :
         {"length(max(abs(x)-0.7,0), max(abs(y)-0.7,0), max(abs(z)-0.7,0)) - 0.3",
          "sqrt(max(abs(x)-0.5,0)^2 + max(abs(y)-0.8,0)^2 + max(abs(z)-0.2,0)^2) = 0.2",
          "length(max(abs(x),0.4) - 0.4, y) = 0.5", "hypot(max(x,0), max(y,0)) = 0.3"}) {
        const Drawn picture = drawn(text, 1.1);
        EXPECT_GT(picture.counts.certified, 200U) << text;
        EXPECT_LT(picture.counts.undecided, picture.counts.certified / 50) << text;
        EXPECT_EQ(black_pixels(picture.frame), 0) << text;
    }
}

/// A constant factor of one operand changes neither its side nor its normals.
TEST(FormulasAsTyped, OperandsOfUnlikeScalesLookAsThoseOfLikeOnes) {
    const auto cut_sphere = [](double scale) {
        return drawn("max(" + digits(scale) + "*(x^2+y^2+z^2-1), z-0.5)", 1.5, 14);
    };
    const auto holed_box = [](double scale) {
        return drawn("max(x^4+y^4+z^4-1, " + digits(scale) + "*(0.3-x^2-y^2))", 1.5, 14);
    };
    const Drawn sphere = cut_sphere(1);
    const Drawn box = holed_box(1);
    for (const double scale : {1e-6, 1e-3, 0.05, 20.0, 1e3, 1e5, 1e6}) {
        EXPECT_LE(differing_pixels(cut_sphere(scale).frame, sphere.frame), 40) << scale;
        EXPECT_LE(differing_pixels(holed_box(scale).frame, box.frame), 40) << scale;
    }
}

TEST(FormulasAsTyped, JumpsAtRandomPlacesAreNoRoots) {
    RandomNumbers random(9);
    for (int i = 0; i < 10; ++i) {
        const std::string c = digits(random.uniform(-0.9, 0.9));
        const std::string d = digits(random.uniform(0.1, 0.9));
        for (const std::string& text :
             {"sign(x - " + c + ") + 0.5", "floor(x - " + c + ") + 0.5", "if(x < " + c + ", -1, 2)",
              "mod(x + y, " + d + ") - 2", "if(x < " + c + " and y < " + c + ", -1, 1)"}) {
            const Drawn picture = drawn(text, 1);
            EXPECT_EQ(picture.counts.certified + picture.counts.undecided, 0U) << text;
        }
        // Each side of the jump shows its own roots, and the jump leaves no pixel undecided.
        const Drawn steps = drawn("if(x < " + c + ", z - 0.1, z + 0.1)", 1);
        EXPECT_GT(steps.counts.certified, 200U) << c;
        EXPECT_EQ(steps.counts.undecided, 0U) << c;
    }
}

/// Expressions of jumps that are continuous are as certain as those without jumps.
TEST(FormulasAsTyped, RepeatedShapesAreCertain) {
    for (const std::string text : {"(mod(x,1)-0.5)^2+(mod(y,1)-1/2)^2+(mod(z,1)-.5)^2-0.2",
                                   "abs(mod(x+1,2)-1)+abs(mod(y+1,2)-1)-0.7",
                                   "length(abs(mod(x,1)-0.5), abs(mod(z,1)-0.5)) - 0.3"}) {
        const Drawn picture = drawn(text, 2);
        EXPECT_GT(picture.counts.certified, 200U) << text;
        EXPECT_EQ(picture.counts.undecided, 0U) << text;
    }
}

/// Where f is 0 in a solid region, each ray that meets it has a proved first root.
TEST(FormulasAsTyped, SolidsOfZerosAreCertain) {
    for (const std::string text : {"if(abs(x) < 0.5, 0, 1)", "(x^2+y^2+z^2-2)*if(y < 0.2, 1, 0)",
                                   "(z-2)*if(if(abs(x)<1/3,1,0)+if(abs(y)<1/3,1,0) <= 0, 1, 0)"}) {
        const Drawn picture = drawn(text, 1);
        EXPECT_GT(picture.counts.certified, 200U) << text;
        EXPECT_EQ(picture.counts.undecided, 0U) << text;
    }
}

/// A root at which f only touches 0, or jumps to it, is proved by a part of f that crosses 0 there.
TEST(FormulasAsTyped, RootsOfPartsAreProved) {
    const std::pair<std::string, std::string> typed[] = {
        {"(x^2 + y^2 + z^2 - 0.8)^2", "x^2 + y^2 + z^2 - 0.8"},
        {"abs(sin(3x) + y - z/2)", "sin(3x) + y - z/2"},
        {"-max(x^2+y^2-0.5, z-0.4)*max(max(x^2+y^2-0.5, z-0.4), -z)", "max(x^2+y^2-0.5, z-0.4)"},
        {"if(x^4+y^4+z^4 < 0.6, cos(x)+cos(y), x^4+y^4+z^4-0.6)", "x^4+y^4+z^4-0.6"},
        {"if(x^4+y^4+z^4 < 0.6, -cos(x), x^4+y^4+z^4-0.6)", "x^4+y^4+z^4-0.6"}};
    for (const auto& [text, part] : typed) {
        const Drawn picture = drawn(text, 1);
        const Drawn of_part = drawn(part, 1);
        ASSERT_GT(of_part.counts.certified, 200U) << part;
        EXPECT_GE(picture.counts.certified, of_part.counts.certified * 98 / 100) << text;
        EXPECT_LE(picture.hits(), of_part.hits() * 102 / 100) << text;
        for (std::size_t i = 0; i < picture.frame.depth.size(); ++i) {
            if (picture.frame.certificate[i] != Certificate::Certified) continue;
            EXPECT_NEAR(picture.frame.depth[i], of_part.frame.depth[i], 1e-4F) << text;
        }
    }
}

/// A remainder jumps to 0: the search along no ray goes on for ever, and most roots are proved.
TEST(FormulasAsTyped, RootsOfRemaindersAreFound) {
    const std::pair<std::string, std::string> typed[] = {
        {"frac(x^2 + y^2 + 1/3) = 0", "sin(pi*(x^2 + y^2 + 1/3))"},
        {"mod(2x^2 + y + z, 0.7) = 0", "sin(pi/0.7*(2x^2 + y + z))"},
        {"ceil(3y^2 z + 1/3) - (3y^2 z + 1/3) = 0", "sin(pi*(3y^2 z + 1/3))"}};
    for (const auto& [text, wave] : typed) {
        const Drawn picture = drawn(text, 1);
        const Drawn of_wave = drawn(wave, 1);
        EXPECT_GT(picture.counts.certified, of_wave.counts.certified * 9 / 10) << text;
        EXPECT_LT(picture.evaluations, 1000 * picture.frame.depth.size()) << text;
        for (std::size_t i = 0; i < picture.frame.depth.size(); ++i) {
            ASSERT_EQ(is_hit(picture.frame, i), is_hit(of_wave.frame, i)) << text;
            if (!is_hit(picture.frame, i)) continue;
            EXPECT_NEAR(picture.frame.depth[i], of_wave.frame.depth[i], 1e-4F) << text;
        }
    }
}

}  // namespace
}  // namespace zeroset::test::formulas_as_typed_test
