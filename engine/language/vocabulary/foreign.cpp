#include "engine/language/vocabulary/foreign.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/nearest_word.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>
#include <vector>

namespace zeroset {

namespace {

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

/// The error for a word (of small letters) with which programs are written, typed as `name`.
std::optional<ParseError> error_for_word_of_programs(std::string_view word, std::string_view name,
                                                     std::size_t offset) {
    if (word == "for") {
        return ParseError{
            .offset = offset,
            .reason = filled(tr("{0} belongs to a program, which is not read"), {quoted(name)}),
            .hint = tr("put a condition behind a comma: z = x^2, x > 0")};
    }
    if (word == "def" || word == "lambda") {
        return ParseError{
            .offset = offset,
            .reason = filled(tr("{0} belongs to a program, which is not read"), {quoted(name)}),
            .hint = tr("define the function as f(x, y, z) = x^2 + y^2 - z")};
    }
    if (is_one_of(word, {"while", "return", "void", "else", "struct", "uniform", "import"})) {
        return ParseError{
            .offset = offset,
            .reason = filled(tr("{0} belongs to a program, which is not read"), {quoted(name)}),
            .hint = tr("type its formulas, each on a line of its own")};
    }
    if (is_one_of(word,
                  {"contourplot3d", "plot3d", "implicitplot3d", "implicitplot", "implicit_plot3d",
                   "fimplicit3", "fimplicit", "isosurface", "parametricplot3d", "show",
                   "manipulate", "plot3", "implicit3d", "contour3", "scatter3d", "plot_surface"})) {
        return ParseError{
            .offset = offset,
            .reason = filled(tr("{0} is a command of another program"), {quoted(name)}),
            .hint = tr("type only the equation in it")};
    }
    return std::nullopt;
}

}  // namespace

std::optional<ParseError> error_for_foreign(std::string_view name, std::size_t offset) {
    const std::string word = in_small_letters(name);
    if (is_one_of(word,
                  {"vec", "float2", "float3", "float4", "ivec2", "ivec3", "dvec2", "dvec3"})) {
        return ParseError{.offset = offset,
                          .reason = filled(tr("{0} is not known as a vector"), {quoted(name)}),
                          .hint = tr("type a vector as (x, y, z) or vec3(x, y, z)")};
    }
    if (is_one_of(word, {"mat2", "mat3", "mat4", "matrix"})) {
        return ParseError{.offset = offset,
                          .reason = filled(tr("matrices are not read: {0}"), {quoted(name)}),
                          .hint = tr("to turn a point type rotate(p, axis, angle)")};
    }
    constexpr std::array parts = {"noise", "perlin", "turbulence", "simplex", "fbm"};
    const bool is_noise =
        std::ranges::any_of(parts, [&](std::string_view part) { return word.contains(part); }) ||
        is_one_of(word, {"f_hetero_mf", "f_ridge", "f_ripples", "f_waves"});
    const Function* const known = is_noise ? find_function(name) : nullptr;
    if (is_noise && known == nullptr) {
        return ParseError{
            .offset = offset,
            .reason = filled(tr("{0} is not among the noises here"), {quoted(name)}),
            .hint = filled(tr("type {0}, which have values of their own"),
                           {"noise(p), value_noise(p), cellular(p), fbm(p), turbulence(p)"})};
    }
    if (is_one_of(word, {"mandelfractal", "juliafractal", "mandelbulb", "f_mandel"})) {
        return ParseError{
            .offset = offset,
            .reason = filled(tr("{0} is not known, but iterations are"), {quoted(name)}),
            .hint = filled(tr("type {0}"), {"iterate(p, n, start, step)"})};
    }
    if (is_one_of(word, {"f_hexagon", "f_pigment", "f_transform", "f_spline"})) {
        return ParseError{
            .offset = offset,
            .reason = filled(tr("{0} of POV-Ray gives a color or a vector"), {quoted(name)}),
            .hint = tr("type a formula that gives a number")};
    }
    return error_for_word_of_programs(word, name, offset);
}

std::optional<std::string> nearest_known_name(std::string_view name) {
    std::vector<std::string_view> words = function_spellings();
    constexpr std::size_t shortest_of_library = 5;  // shorter library names, such as f_r, are near
                                                    // to any short name
    std::erase_if(words, [&](std::string_view word) {
        return name.size() < shortest_of_library && find_function(word)->is_of_library();
    });
    words.insert(words.end(), built_in_values().begin(), built_in_values().end());
    const auto meant = meant_word(name, words);
    return meant ? std::optional(std::string(*meant)) : std::nullopt;
}

namespace {

/// The name as a product; a letter before a known name, such as ksin, is a coefficient times that.
std::optional<std::string> as_product(std::string_view name) {
    const bool coefficient = name.size() > 1 && is_built_in(name.substr(1));
    if (!coefficient && name.size() != 2) return std::nullopt;
    return std::string(name.substr(0, 1)) + "*" + std::string(name.substr(1));
}

}  // namespace

std::optional<Mend> mend_for_unknown(const std::string& name) {
    if (const auto meant = nearest_known_name(name)) return Mend{.word = name, .by = *meant};
    if (const auto product = as_product(name)) return Mend{.word = name, .by = *product};
    return std::nullopt;
}

namespace {

/// A hint that an unknown name may be meant as a known one, or as a product.
std::optional<std::string> hint_for_meant(std::string_view name) {
    if (const Function* const word = find_function(name); word != nullptr && word->is_word())
        return filled(tr("type {0}"), {std::string(name) + "(...)"});
    if (const auto meant = nearest_known_name(name))
        return filled(tr("did you mean {0}?"), {*meant});
    if (const auto product = as_product(name))
        return filled(tr("for a product type {0}"), {*product});
    constexpr std::size_t longest_shown = 24;
    if (name.size() > longest_shown) return tr("type a product with *");
    return std::nullopt;
}

}  // namespace

std::string hint_for_unknown(std::string_view name) {
    if (auto hint = hint_for_meant(name)) return std::move(*hint);
    return filled(tr("define it, as in {0}, or type a product with *"),
                  {std::string(name) + " = 2"});
}

std::string hint_for_unknown_function(std::string_view name) {
    if (auto hint = hint_for_meant(name)) return std::move(*hint);
    return hint_to_define(name);
}

std::string hint_to_define(std::string_view function) {
    return filled(tr("define it, as in {0}"), {std::string(function) + "(u, v) = u^2 + v^2"});
}

std::string hint_for_sign(char32_t code) {
    constexpr char32_t wide = 0xFF01 - '!';  // full-width form of an ASCII character c: c + wide
    static constexpr std::array<std::pair<std::u32string_view, const char*>, 7> hints{
        {{U"\"'`“”„‘’«»",
          marked("leave quotation marks out; a derivative is typed as its formula")},
         {U"±∓", marked("type two equations, one with + and one with -")},
         {U"°", marked("type radians(90) for 90 degrees")},
         {U"∑Σ∏", marked("type sum(f, i, 1, 5) or prod(f, i, 1, 5), written out")},
         {U"∫∂∇", marked("integrals and derivatives are not read; type their formulas")},
         {U"∞", marked("type a large number")},
         {U"∈∉⊂∀∃", marked("type a condition such as -1 < x < 1 behind a comma")}}};
    for (const auto& [signs, hint] : hints) {
        if (signs.contains(code)) return tr(hint);
    }
    if (code > wide + ' ' && code < wide + 0x7F)
        return filled(tr("it is a wide sign; type {0}"),
                      {std::string(1, static_cast<char>(code - wide))});
    if (code >= 0x0400 && code < 0x0500) return tr("it is a Cyrillic letter; type the Latin one");
    return tr("type + - * / ^ ( ) and names such as x, y, z, sqrt");
}

ParseError error_for_part(std::string_view part, std::size_t offset) {
    constexpr std::array<std::string_view, 8> colours{"hf",    "gray", "grey",   "red",
                                                      "green", "blue", "filter", "transmit"};
    if (std::ranges::find(colours, part) != colours.end()) {
        return {.offset = offset,
                .reason = filled(tr("{0} is a part of a color, which is not read"),
                                 {"." + std::string(part)}),
                .hint = tr("type a formula that gives a number")};
    }
    return {.offset = offset,
            .reason = filled(tr("a vector has no part {0}"), {"." + std::string(part)}),
            .hint = tr("type .x, .y, .z or .w, or several at once: p.xz")};
}

}  // namespace zeroset
