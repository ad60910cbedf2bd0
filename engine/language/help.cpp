#include "engine/language/help.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/functions.hpp"

#include <cstddef>
#include <utility>

namespace zeroset {
namespace {

struct Line {
    const char* typed;
    const char* meaning;

    constexpr Line(const char* what, const char* about) : typed(what), meaning(about) {}
};

constexpr Line statements[] = {
    {"x^2 + y^2 + z^2 = 1", marked("an equation: a surface, where both sides are equal")},
    {"x^2 + y^2 - z", marked("an expression: the surface where it is 0")},
    {"x^2 + y^2 = 1, -1 < z < 1",
     marked("a surface, only where the inequalities hold; also {z < 1}")},
    {"z > x^2 + y^2, z < 1",
     marked("inequalities: the boundary of the solid where all of them hold")},
    {"f(x, y) = x^2 - y^2", marked("alone: the graph z = f(x, y); so of x and z, of y and z")},
    {"(u cos v, u sin v, v), 0 < u < 1, 0 < v < 2 pi",
     marked("a parametric surface: a point over two variables of any names")},
    {"s = u^2; (u, v, s), 0 < u < 1, 0 < v < 1",
     marked("values of other rows may go by the variables of the row")},
    {"r(u, v) = (u, v, u v), 0 < u < 1, 0 < v < 1",
     marked("the point with a name, which is left out")},
    {"(cos t, sin t, t/3), 0 < t < 20", marked("a curve: a point over one variable")},
    {"x^2 + y^2 + z^2 = 4 and z = x y", marked("a curve: where two surfaces meet")},
    {"P = (1, 2, a)", marked("a point; a name begins with a capital letter")},
    {"segment(P, Q)  vector(P, v)  polygon(P, Q, R)",
     marked("made of points, each in a row of its own: a segment, an arrow, a part of a plane")},
    {"a = 2", marked("a constant, for all statements; a := 2 is never anything else")},
    {"f(u, v) = u^2 + v^2", marked("a function, for all statements; it cannot call itself")},
    {R"(scan = volume("ct.nrrd"))",
     marked("samples from a file, as a function of the point: scan(x, y, z) = 400")},
    {R"(scan = volume("ct.nrrd", cubic))",
     marked("a spline through the samples, else trilinear; with smooth in its place: beside them")},
    {R"(blobs("atoms.xyz", 0.8) = 1)",
     marked("soft balls from a file with x y z, or x y z r, in each line; also metaballs, blinn")},
    {"a = 2; a = a + 1", marked("defined again: for what follows and for all surfaces")},
    {"a = 2; z = a x",
     marked("between statements; a line goes on in brackets, behind an operator and before one")},
    {"-x + y",
     marked("at the start of a line another statement, but + goes on where no = was before")},
    {"# ...   // ...", marked("up to the end of the line, as % at its start; also /* a remark */")},
};

constexpr Line name_lines[] = {
    {"x y z w", marked("the variables; t is another name of w")},
    {"r, rho", "sqrt(x^2 + y^2 + z^2), sqrt(x^2 + y^2)"},
    {"theta \u03b8, phi \u03c6", marked("the angles atan2(y, x) and acos(z/r)")},
    {"swap theta, phi", marked("a row by which these two change places, as physics has them")},
    {"pi \u03c0, tau \u03c4, e, golden", "3.14159..., 2 pi, 2.71828..., (1 + sqrt 5)/2"},
    {"a, k, c_1, \u03b1",
     marked("any other letter is a parameter with a slider; its value is 1 at first")},
    {"radius, a1, Iso_2",
     marked("names of any length once they are defined, which are never split")},
    {"r = 0.5",
     marked(
         "a constant where another statement uses r, alone the sphere; so with each name above")},
    {"cx = 0.1", marked("a constant where another statement uses cx, alone the product c*x")},
};

constexpr Line expressions[] = {
    {"12  .5  1e-3",
     marked("numbers, with a decimal point; 0,5 is 0.5 where it cannot be two values")},
    {"+ - * / % ^",
     marked("a % b is mod(a, b); -x^2 is -(x^2); x^y^z is x^(y^z); also ** × · ÷ −")},
    {"2x  x(x+3)  xy  2xy^2", marked("products need no *; 1/2x is (1/2)*x")},
    {"( ) [ ] { }  |x|", marked("brackets; absolute value")},
    {"x\u00b2  x^(1/3)  x^-2", marked("powers; a root of odd degree takes negative numbers, too")},
    {"sin x  sin 2x  ln xy", marked("a function without parentheses takes the product behind it")},
    {"sin^2 x  sin^-1 x", marked("(sin x)^2, but the inverse function asin x")},
    {"T_4(x)  U_3(x)  P_2(x)  H_3(x)  L_2(x)",
     marked("Chebyshev's polynomials of the first and the second kind, for n up to 20, Legendre's, "
            "Hermite's and Laguerre's")},
    {"n!  Y_2^1(a, b)",
     marked(
         "factorials of whole numbers; spherical harmonics, by the angle from the z-axis and the "
         "one about it")},
    {"z = |x + i y|  z = Re((x + i y)^3)",
     marked("i is the imaginary unit where the text asks for Re, Im, arg or conj, or for |.| of a "
            "sum with i; elsewhere it is a parameter. Powers, exp, ln, sqrt and trigonometric "
            "functions have their principal values")},
    {R"(\frac{a}{b}  \sqrt{x}  \sin)", marked("LaTeX as copied from a paper")},
    {"x < y <= z  x == y  x != y", marked("conditions, for if, { } and behind a comma")},
    {"and or not  & | !  && ||",
     marked("join conditions; | | around a value stay its absolute value")},
    {"(x < 1)*y  if(x, 1, 2)",
     marked("a condition is 1 or 0 as a number; a number holds where it is not 0")},
    {"{x < 0: -x, x}", marked("cases, the same as if(x < 0, -x, x) and x < 0 ? -x : x")},
};

constexpr Line vectors[] = {
    {"p = (x, y, z)",
     marked("a vector of 2, 3 or 4 numbers, for all statements; also vec3(x, y, z)")},
    {"length(p - (1, 0, 0)) = 1", marked("sums of vectors, and a number times a vector: 2p")},
    {"p.x  p.z  p.xy", marked("parts of a vector, one or several: (p.x, p.y)")},
    {"f(p) = length(p) - 1",
     marked("functions of vectors, which may give vectors; f(x, y, z) takes one, too")},
    {"|p|", marked("the length of a vector")},
    {"max(abs(p) - 1, 0)", marked("functions of numbers go over the parts of vectors")},
    {"[1, 2, 3]", marked("a list of numbers or of vectors, over which all functions go")},
    {"sum([a, b, c])", marked("joins a list, or the parts of a vector; also prod, min, max")},
    {"min(length(p - [(1, 0, 0), (0, 1, 0)])) = 1/2",
     marked("two balls: the least of a list of distances")},
    {"iterate(q, 5, (x, y, z, 0), f(q))",
     marked("a step f done 5 times: up to 100 steps, 20 000 operations")},
    {"distance_estimate(q, 8, (x, y, z, 0), f(q)) = 0.01",
     marked("how far a point is from a Julia set, about: a thin shell around it")},
    {"vec3 q = abs(p) - b;",
     marked("vectors as GLSL writes them, within functions, too; p.xy *= 2. is read there")},
};

constexpr Line elsewhere[] = {
    {"const float a = 2., b = 3.;",
     marked("values as programs write them; also double, let, var, #declare")},
    {"float f(float u) { float v = u*u; return v + 1.; }",
     marked("a function, of values one after the other")},
    {"float f(float u) { if (u < 0.) return -u; else u += 1.; return u; }",
     marked("choices in a function; what a choice leaves open follows it")},
    {"#declare F = function(u, v) { u*v }", marked("a function as POV-Ray writes it")},
    {"f[u_, v_] := u v  Sin[x]",
     marked("definitions and calls as Mathematica writes them; there E is e")},
    {"f = @(x, y) x.^2  f = lambda x: x**2",
     marked("functions as MATLAB and Python write them; also (x) -> x, x => x and def f(x): return "
            "x")},
    {"def f(x, y): ...  function f(x, y) { ... }",
     marked("functions with steps of Python, JavaScript, R, Rust, MATLAB and Maple: values and "
            "choices, no loops")},
    {"ContourPlot3D[x == y z, {x, -1, 1}, ...]",
     marked("a plotting command of Mathematica, Maple, MATLAB, Sage, SymPy, Maxima, gnuplot or "
            "GeoGebra; its ranges are the clip box")},
    {"[X, Y, Z] = meshgrid(-2:0.1:2)",
     marked("a grid of MATLAB or NumPy, with isosurface, marching_cubes or surf behind it")},
    {"\\sum_{i=1}^{3} x^i  Sum[x^i, {i, 1, 3}]",
     marked("sums and products as LaTeX, Mathematica, Maple and Python write them")},
    {"#define R 2.5", marked("a constant or function as C's macros write it")},
    {"Math.sin(x)  np.sqrt(x)", marked("functions with the name of their library")},
    {"x - 1 : y - 1 :", marked("surfaces apart by colons, as in K3DSurf")},
    {"_0 var-x",
     marked("the first line of a list of instructions, as Fidget and libfive keep models")},
};

constexpr std::string_view grammar =
    R"grammar(text      = statement { (";" | ":" | line end) statement }
statement = [ words ] [ left ("=" | ":=") ] choice { "," choice | "{" choice { "," choice } "}" }
          | words name "(" names ")" body
body      = "{" step { step } "}"
step      = [ words ] name [ "=" choice ] ";" | "return" choice ";"
          | "if" "(" choice ")" ( step | body ) [ "else" ( step | body ) ]
left      = name | name "(" names ")" | sum
names     = [ words ] name { "," [ words ] name }
words     = ("const" | "float" | "double" | "int" | "let" | "var" | "#declare" | ...) [ words ]
choice    = logic [ "?" choice ":" choice ]
logic     = both { ("or" | "|" | "||") both }
both      = negation { ("and" | "&" | "&&") negation }
negation  = "not" negation | relation
relation  = sum { ("=" | "==" | "!=" | "<" | ">" | "<=" | ">=") sum }
sum       = product { ("+" | "-") product }
product   = signed { ("*" | "/" | "%") signed | power }
signed    = { "+" | "-" } ( power | "!" signed )
power     = operand { "^" signed | superscript }
operand   = value { "." parts }
value     = number | name | "(" choice ")" | "[" choice "]" | "{" choice "}" | "|" choice "|"
          | "(" choice "," choice { "," choice } ")" | "[" choice "," choice { "," choice } "]"
          | function [ "^" signed ] ( "(" choice { "," choice } ")" | bare )
          | "{" logic ":" choice { "," logic ":" choice } [ "," choice ] "}"
          | "\frac" part part | "\sqrt" [ "[" choice "]" ] part
bare      = signed { power of a name }
part      = operand | digit
parts     = ("x" | "y" | "z" | "w") [ parts ]
)grammar";

template <std::size_t size>
HelpSection section(std::string title, const Line (&lines)[size]) {
    HelpSection result{.title = std::move(title), .entries = {}};
    for (const Line& line : lines)
        result.entries.push_back({.typed = line.typed, .meaning = line.meaning});
    return result;
}

}  // namespace

std::vector<HelpSection> language_help() {
    std::vector<HelpSection> help{
        section(marked("Statements"), statements),
        section(marked("Names"), name_lines),
        section(marked("Expressions"), expressions),
        section(marked("Vectors"), vectors),
        section(marked("Texts from elsewhere"), elsewhere),
        {.title = marked("Functions"), .entries = {}},
        {.title = marked("Functions of vectors"), .entries = {}},
        {.title = marked("Shapes"), .entries = {}},
        {.title = marked("Moved shapes"), .entries = {}},
        {.title = marked("Blends and walls"), .entries = {}},
        {.title = marked("Things made of points"), .entries = {}},
        {.title = marked("Noise and blobs"), .entries = {}},
        {.title = marked("Complex numbers"), .entries = {}},
        {.title = marked("Polynomials and other functions with names"), .entries = {}},
        {.title = marked("Special functions"), .entries = {}},
        {.title = marked("Functions of POV-Ray and MathMod"), .entries = {}}};
    const std::size_t fixed = help.size() - 11;
    for (const Function& function : functions()) {
        const std::string call =
            std::string(function.name) + "(" + std::string(function.arguments) + ")";
        std::size_t at = fixed + static_cast<std::size_t>(function.section);
        if (function.is_of_library() && !function.is_word()) at = help.size() - 1;
        help[at].entries.push_back({.typed = call, .meaning = std::string(function.meaning)});
    }
    return help;
}

std::string_view language_grammar() { return grammar; }

}  // namespace zeroset
