#pragma once

#include "engine/language/expressions/expression_reader.hpp"

namespace zeroset {

/// A call as the help shows it: sphere(p, r).
std::string call_of(const Function& function);

/// A call of a built-in function that is being read.
struct CallSite {
    ExpressionReader& reader;
    const Syntax& call;
    const Context& context;

    [[nodiscard]] GraphValues& values() const { return reader.values(); }
    [[nodiscard]] ExprBuilder& builder() const { return reader.values().builder(); }
    [[nodiscard]] std::string word() const { return std::string(call.function->name); }
    [[nodiscard]] Composed composed() const { return *call.function->composed; }
    [[nodiscard]] const Syntax& argument(std::size_t place) const {
        return reader.tree()[call.operands[place]];
    }
    /// Where errors at the call are shown, and those at an argument.
    [[nodiscard]] std::size_t offset() const { return context.at(call.offset); }
    [[nodiscard]] std::size_t offset_of(std::size_t place) const {
        return context.at(argument(place).offset);
    }
};

/// Errors at a call, and at one of its arguments.
std::nullopt_t refuse_call(const CallSite& site, std::string reason, std::string hint);
std::nullopt_t refuse_argument(const CallSite& site, std::size_t place, std::string reason,
                               std::string hint);

// Calls whose arguments are not only numbers; each stands in a file of its own, calls_*.cpp.

/// sum(f, i, m, n), prod, least or greatest, written out.
GraphValues::Built read_repeated(const CallSite& site);
/// iterate(p, n, start, step), written out.
GraphValues::Built read_iteration(const CallSite& site);
/// distance_estimate(p, n, start, step), written out.
GraphValues::Built read_distance_estimate(const CallSite& site);
/// A function of library.def or shapes.def: its body for the arguments, without the text's names.
GraphValues::Built read_library_call(const CallSite& site);
/// noise(p, seed) and its like.
GraphValues::Built read_noise(const CallSite& site);
/// legendre(n, a) and its like: the polynomial of the degree n.
GraphValues::Built read_polynomial(const CallSite& site);
/// erf(a), besselj(n, a) and the like: fields of a number, and formulas of these.
GraphValues::Built read_special(const CallSite& site);
/// blobs(list), blobs(p, list) and the like: a field where the numbers of the balls are constants,
/// else a formula.
GraphValues::Built read_blobs(const CallSite& site);

/// Takes the point off the front of the arguments of a call of noise or soft balls: a vector of 2
/// or 3 numbers, or up to three numbers. Coordinates that are left out are 0.
std::optional<std::array<NodeId, 3>> leading_point(const CallSite& site, BuiltValues& arguments);

}  // namespace zeroset
