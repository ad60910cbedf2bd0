#include "tests/support/oracle/random_surface.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace zeroset::test {
namespace {

using std::string;

string number(double value, int digits = 2) {
    char text[40];
    std::snprintf(text, sizeof text, value < 0 ? "(%.*f)" : "%.*f", digits, value);
    return text;
}

string between(RandomNumbers& random, double lo, double hi) {
    return number(random.uniform(lo, hi));
}

/// One text after the other: made in this order by every compiler, as sums are not.
string joined(std::initializer_list<string> texts) {
    string all;
    for (const string& text : texts)
        all += text;
    return all;
}

string monomial(RandomNumbers& random, int degree) {
    string text = between(random, -2, 2);
    for (int left = random.between(1, degree); left > 0;) {
        const int exponent = random.between(1, left);
        text += string("*") + "xyz"[random.below(3)];
        if (exponent > 1) text += "^" + std::to_string(exponent);
        left -= exponent;
    }
    return text;
}

string polynomial_of(RandomNumbers& random, int degree, int terms) {
    string text = monomial(random, degree);
    for (int i = 1; i < terms; ++i)
        text += " + " + monomial(random, degree);
    return text;
}

/// The squared distance from a random point, with scaled axes.
string squares(RandomNumbers& random) {
    string text;
    for (const char* axis : {"x", "y", "z"}) {
        if (!text.empty()) text += " + ";
        text += joined(
            {between(random, 0.4, 1.5), "*(", axis, " - ", between(random, -0.6, 0.6), ")^2"});
    }
    return text;
}

string plane(RandomNumbers& random) {
    return joined({between(random, -1, 1), "*x + ", between(random, -1, 1), "*y + ",
                   between(random, -1, 1), "*z"});
}

string polynomial(RandomNumbers& random) {
    const int degree = random.between(1, 9);
    const int terms = random.between(2, 8);
    string text = polynomial_of(random, degree, terms);
    if (random.one_in(2)) text += " + " + squares(random);
    return text;
}

string product(RandomNumbers& random) {
    string text = joined({"(", squares(random), " - ", between(random, 0.2, 1), ")*(",
                          plane(random), " + ", between(random, -0.3, 0.3), ")"});
    if (random.one_in(2)) text = "(" + text + ")*(" + squares(random) + " - 0.5)";
    return text;
}

string wave(RandomNumbers& random) {
    const string function = random.one_in(2) ? "sin" : "cos";
    const char axis = "xyz"[random.below(3)];
    return joined({function, "(", between(random, 0.5, 4), "*", string(1, axis), " + ",
                   between(random, -1, 1), ")"});
}

string trigonometric(RandomNumbers& random) {
    string text = joined({wave(random), "*", wave(random)});
    for (int i = random.between(1, 3); i > 0; --i)
        text += joined({" + ", wave(random), "*", wave(random)});
    if (random.one_in(3)) text += " + " + plane(random);
    return text;
}

string solid(RandomNumbers& random) {
    switch (random.below(4)) {
        case 0: return joined({squares(random), " - ", between(random, 0.2, 1.2)});
        case 1:
            return joined({"max(max(abs(x - ", between(random, -0.5, 0.5), "), abs(y - ",
                           between(random, -0.5, 0.5), ")), abs(z)) - ",
                           between(random, 0.3, 0.9)});
        case 2: return joined({"abs(", plane(random), ") - ", between(random, 0.1, 0.6)});
        default: {
            const bool upright = random.one_in(2);
            return string(upright ? "x^2 + y^2 - " : "y^2 + z^2 - ") + between(random, 0.1, 0.6);
        }
    }
}

string solids(RandomNumbers& random) {
    string text = solid(random);
    for (int i = random.between(1, 3); i > 0; --i) {
        const char* const function = random.one_in(2) ? "min(" : "max(";
        text = function + text + ", " +
               (random.one_in(3) ? "-(" + solid(random) + ")" : solid(random)) + ")";
    }
    return text;
}

string quotient(RandomNumbers& random) {
    const string above = polynomial_of(random, 3, 3);
    if (random.one_in(2)) return "(" + above + ")/(0.1 + " + squares(random) + ")";
    return joined({"(", above, ")/(", plane(random), " + ", monomial(random, 2), ")"});
}

string roots(RandomNumbers& random) {
    switch (random.below(4)) {
        case 0:
            return joined({"(sqrt(", squares(random), ") - ", between(random, 0.4, 1), ")^2 + ",
                           monomial(random, 2)});
        case 1: return joined({"sqrt(", plane(random), " + 0.3) + ", polynomial_of(random, 2, 2)});
        case 2: return joined({"cbrt(", polynomial_of(random, 3, 2), ") + ", plane(random)});
        default: return joined({"sqrt(abs(", plane(random), ")) + ", squares(random)});
    }
}

string exponential(RandomNumbers& random) {
    switch (random.below(4)) {
        case 0: return joined({"exp(-(", squares(random), ")) + exp(-(", squares(random), "))"});
        case 1: return joined({"tanh(", plane(random), ") + atan(", monomial(random, 3), ")"});
        case 2: return joined({"log(0.2 + ", squares(random), ") + ", plane(random)});
        default: return "sin(3*atan2(y, x)) + " + squares(random);
    }
}

string steps(RandomNumbers& random) {
    switch (random.below(4)) {
        case 0:
            return joined({"floor(", between(random, 1, 3), "*x) + ", polynomial_of(random, 2, 3)});
        case 1: return "mod(x, 0.7)^2 + mod(y, 0.9)^2 + " + plane(random);
        case 2: return joined({"sign(", plane(random), ") + ", squares(random)});
        default: return joined({"tan(", plane(random), ") + ", plane(random)});
    }
}

constexpr std::array families{
    SurfaceFamily{"polynomial", polynomial},       SurfaceFamily{"product", product},
    SurfaceFamily{"trigonometric", trigonometric}, SurfaceFamily{"solids", solids},
    SurfaceFamily{"quotient", quotient},           SurfaceFamily{"roots", roots},
    SurfaceFamily{"exponential", exponential},     SurfaceFamily{"steps", steps}};

}  // namespace

std::span<const SurfaceFamily> surface_families() { return families; }

string random_surface(const SurfaceFamily& family, double half_edge, RandomNumbers& random) {
    for (;;) {
        const string formula = family.formula(random);
        const auto expr = parse(formula);
        if (!expr) {
            ADD_FAILURE() << formula << ": " << expr.error().reason;
            return "x";
        }
        const double middle = 0.6 * half_edge;
        const std::array at{random.uniform(-middle, middle), random.uniform(-middle, middle),
                            random.uniform(-middle, middle), 0.0};
        const double level = value_at(*expr, at).value;
        if (std::abs(level) < 100) return formula + " - " + number(level, 3);
    }
}

}  // namespace zeroset::test
