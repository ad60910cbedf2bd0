// Builds soft balls: a field where their numbers are constants, else a formula.

#include "engine/base/translation.hpp"
#include "engine/blobs/blobs.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/expressions/calls.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace zeroset {
namespace {

constexpr std::size_t most_that_change = 200;

BlobKind kind_of(Composed function) {
    if (function == Composed::Metaballs) return BlobKind::Metaball;
    return function == Composed::Blinn ? BlobKind::Blinn : BlobKind::Wyvill;
}

/// The decimal number that is read as this double: the shortest one, or the exact one where that
/// has more digits than fractions are surely read with.
std::string decimal(double number) {
    constexpr std::ptrdiff_t most_digits = 15;
    std::array<char, 1200> text{};
    auto end = std::to_chars(text.begin(), text.end(), number).ptr;
    const auto digits = std::count_if(text.begin(), end, [](char c) { return is_digit(c); });
    if (digits > most_digits) {
        constexpr int places = 1074;
        end = std::to_chars(text.begin(), text.end(), number, std::chars_format::fixed, places).ptr;
        while (end[-1] == '0')
            --end;
        if (end[-1] == '.') --end;
    }
    return {text.begin(), end};
}

/// The list as it is typed.
std::string text_of_blobs(BlobKind kind, const std::vector<Blob>& blobs) {
    std::string text(blob_name(kind));
    for (std::size_t n = 0; n < blobs.size(); ++n) {
        text += n == 0 ? ", [" : ", ";
        for (std::size_t i = 0; i < 3; ++i)
            text += (i == 0 ? "(" : ", ") + decimal(blobs[n].center[i]);
        text += ", " + decimal(blobs[n].radius * blobs[n].strength) + ")";
    }
    return text + "]";
}

/// The height of a ball at q (engine/blobs/blob_kind.hpp).
NodeId height_of(ExprBuilder& builder, BlobKind kind, NodeId q) {
    const auto number = [&](double x) { return builder.constant(x); };
    const auto share = [&](double a, double b) {
        return make_divide(builder, number(a), number(b));
    };
    const auto product = [&](NodeId a, NodeId b) { return make_multiply(builder, a, b); };
    const auto difference = [&](NodeId a, NodeId b) { return make_subtract(builder, a, b); };
    if (kind == BlobKind::Blinn) {
        return make_call(builder, Op::Exp, product(number(2), difference(number(1), q)));
    }
    const NodeId w = make_call(builder, Op::Min, q, number(4));
    if (kind == BlobKind::Wyvill) {
        const NodeId cubic = difference(share(17, 72), product(share(1, 72), w));
        const NodeId inner = difference(product(w, cubic), share(11, 9));
        return make_add(builder, number(2), product(w, inner));
    }
    const NodeId rest = difference(number(2), make_call(builder, Op::Sqrt, w));
    const NodeId near = make_call(builder, Op::LessEqual, q, share(4, 9));
    return make_call(builder, Op::If, near, difference(share(8, 3), product(number(2), q)),
                     make_int_power(builder, rest, 2));
}

/// The point of blobs(p, list) or blobs(x, y, z, list); (x, y, z) where there is none.
std::optional<std::array<NodeId, 3>> point_of_blobs(const CallSite& site, BuiltValues before) {
    if (before.empty()) {
        return std::array{site.builder().variable(0), site.builder().variable(1),
                          site.builder().variable(2)};
    }
    const auto point = leading_point(site, before);
    if (point && before.empty()) return point;
    if (!point) return std::nullopt;
    const std::string name = site.word();
    return refuse_call(site, filled(tr("{0} is of one point and a list"), {name}),
                       filled(tr("type {0}"), {name + "(p, [(0, 0, 0, 1), (1, 0, 0, 1)])"}));
}

/// Adds a ball: a vector (x, y, z, r), or (x, y, z) where a radius is behind the list.
bool add_blob(const CallSite& site, const BuiltValue& from, const BuiltValues& radius,
              std::vector<std::array<NodeId, 4>>& blobs) {
    const bool fits = from.is_vector() && (from.size() == 4 || from.size() == 3);
    if (!fits) {
        refuse_call(site,
                    filled(tr("{0} is of a list of balls (x, y, z, r), not of {1}"),
                           {site.word(), from.described()}),
                    filled(tr("type {0}"), {"[(0, 0, 0, 1), (1, 0, 0, 1)]"}));
        return false;
    }
    std::array<NodeId, 4> blob{};
    blob[3] = radius.empty() ? site.builder().constant(1.0) : radius.front().id;
    for (std::size_t i = 0; i < from.size(); ++i)
        blob[i] = from.part(i).id;
    if (!site.values().done(blob[3], site.offset())) return false;
    blobs.push_back(blob);
    return true;
}

GraphValues::Built blobs_field_of(const CallSite& site, const std::array<NodeId, 3>& point,
                                  const std::vector<std::array<NodeId, 4>>& balls) {
    // Decimal numbers as the nearest doubles, as which they are printed.
    const auto number = [&](NodeId id) {
        const auto fraction = exact_fraction(site.builder(), id);
        if (!fraction) return site.values().facts(id).middle;
        return static_cast<double>(static_cast<long double>(fraction->p) /
                                   static_cast<long double>(fraction->q));
    };
    std::vector<Blob> blobs;
    for (const auto& ball : balls) {
        const double radius = number(ball[3]);
        constexpr double least = 1e-100;
        constexpr double most = 1e100;
        Blob blob{.center = {number(ball[0]), number(ball[1]), number(ball[2])},
                  .radius = std::abs(radius),
                  .strength = radius < 0 ? -1.0 : 1.0};
        const bool near =
            std::ranges::all_of(blob.center, [](double c) { return std::abs(c) <= most; });
        if (!near || !(blob.radius >= least && blob.radius <= most)) {
            return refuse_call(site, tr("a ball has a radius other than 0 and a finite place"),
                               filled(tr("type {0}"), {"(0, 0, 0, 1)"}));
        }
        blobs.push_back(blob);
    }
    const BlobKind kind = kind_of(site.composed());
    const auto field = blobs_field(kind, blobs, text_of_blobs(kind, blobs));
    return site.values().done(site.builder().look_up(field, point[0], point[1], point[2]),
                              site.offset());
}

/// Writes out balls whose numbers change.
GraphValues::Built blobs_formula(const CallSite& site, const std::array<NodeId, 3>& point,
                                 const std::vector<std::array<NodeId, 4>>& balls) {
    ExprBuilder& builder = site.builder();
    if (balls.size() > most_that_change) {
        return refuse_call(site,
                           filled(tr("at most {0} balls may depend on sliders, w or the point"),
                                  {std::to_string(most_that_change)}),
                           tr("type numbers for the others in a list of their own"));
    }
    const BlobKind kind = kind_of(site.composed());
    NodeId sum = builder.constant(0.0);
    for (const auto& ball : balls) {
        NodeId squares = builder.constant(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const NodeId from = make_subtract(builder, point[i], ball[i]);
            const NodeId square = make_int_power(builder, from, 2);
            squares = i == 0 ? square : make_add(builder, squares, square);
        }
        const bool is_unit = exact_value(builder, ball[3]) == 1.0;
        const NodeId q =
            is_unit ? squares : make_divide(builder, squares, make_int_power(builder, ball[3], 2));
        NodeId height = height_of(builder, kind, q);
        if (const auto& radius = site.values().facts(ball[3]).constant;
            !radius || radius->neg_lo > 0)
            height = make_multiply(builder, make_call(builder, Op::Sign, ball[3]), height);
        sum = make_add(builder, sum, height);
        if (!site.values().done(sum, site.offset())) return std::nullopt;
    }
    return site.values().done(sum, site.offset());
}

}  // namespace

GraphValues::Built read_blobs(const CallSite& site) {
    const auto arguments = site.reader.operands(site.call.operands, site.context);
    if (!arguments) return std::nullopt;
    // A list of one is its element.
    auto list = std::ranges::find_if(*arguments, [](const BuiltValue& v) { return v.is_list(); });
    if (list == arguments->end()) {
        const auto last = std::find_if(arguments->rbegin(), arguments->rend(),
                                       [](const BuiltValue& v) { return v.is_vector(); });
        if (last != arguments->rend()) list = std::prev(last.base());
    }
    const BuiltValues radius(list == arguments->end() ? list : std::next(list), arguments->end());
    const bool has_list = list != arguments->end();
    if (!has_list || radius.size() > 1 || (!radius.empty() && !radius.front().is_single())) {
        const std::string name = site.word();
        return refuse_call(
            site,
            filled(tr("{0} is of a list of balls, with or without a radius behind it"), {name}),
            filled(tr("type {0}"), {name + "([(0, 0, 0, 1), (1, 0, 0, 1)])"}));
    }
    const auto point = point_of_blobs(site, BuiltValues(arguments->begin(), list));
    if (!point) return std::nullopt;
    std::vector<std::array<NodeId, 4>> balls;
    for (std::size_t n = 0; n < (list->is_list() ? list->size() : 1); ++n) {
        if (!site.values().counts(site.offset())) return std::nullopt;
        const BuiltValue ball = list->is_list() ? list->part(n) : *list;
        if (!add_blob(site, ball, radius, balls)) return std::nullopt;
    }
    const bool constant = std::ranges::all_of(balls, [&](const auto& ball) {
        return std::ranges::all_of(
            ball, [&](NodeId id) { return site.values().facts(id).constant.has_value(); });
    });
    return constant ? blobs_field_of(site, *point, balls) : blobs_formula(site, *point, balls);
}

}  // namespace zeroset
