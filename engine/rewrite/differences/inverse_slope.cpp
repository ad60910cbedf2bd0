#include "engine/rewrite/differences/inverse_slope.hpp"

#include "engine/algebra/node_facts.hpp"
#include "engine/expr/simplify.hpp"

#include <initializer_list>

namespace zeroset {
namespace {

class InverseSlope {
public:
    InverseSlope(ExprBuilder& builder, const InverseValues& values) : b_(builder), of_(values) {}

    NodeId made() {
        const Op op = of_.op;
        if (op == Op::Log10 || op == Op::Log2) return of_logarithm(op == Op::Log2 ? 2.0 : 10.0);
        if (op == Op::Asin) return of_wave(Op::Cos, Op::Sinc);
        if (op == Op::Acos) return make_negate(b_, of_wave(Op::Sin, Op::Sinc));
        if (op == Op::Asinh) return of_wave(Op::Cosh, Op::Sinhc);
        if (op == Op::Acosh) return of_wave(Op::Sinh, Op::Sinhc);
        return op == Op::Log ? of_wave(Op::Exp, Op::Sinhc) : of_tangent();
    }

private:
    NodeId product(std::initializer_list<NodeId> factors) {
        NodeId result = b_.constant(1.0);
        for (const NodeId factor : factors)
            result = make_multiply(b_, result, factor);
        return result;
    }
    /// u - v is 2 exp(m) sinh(h) for u = exp(m + h) and v = exp(m - h), and its like for the
    /// others: `slope` is the derivative that is taken at m.
    NodeId of_wave(Op slope, Op cardinal) {
        const NodeId half = b_.constant(0.5);
        const NodeId m = product({half, make_add(b_, of_.p, of_.q)});
        const NodeId h = product({half, make_subtract(b_, of_.p, of_.q)});
        return product({make_call(b_, slope, m), b_.apply(cardinal, h)});
    }
    NodeId of_logarithm(double base) {
        const NodeId unit = make_call(b_, Op::Log, b_.constant(base));
        of_.p = product({unit, of_.p});
        of_.q = product({unit, of_.q});
        return product({unit, of_wave(Op::Exp, Op::Sinhc)});
    }
    /// u - v is sin(p - q)/(cos(p) cos(q)) for u = tan(p) and v = tan(q), where 1/cos(p)^2 is
    /// 1 + u^2; of tanh it is sinh(p - q)/(cosh(p) cosh(q)).
    NodeId of_tangent() {
        const bool turns = of_.op == Op::Atan;
        const NodeId one = b_.constant(1.0);
        const auto by_cosine = [&](NodeId a) {
            const NodeId square = make_int_power(b_, a, 2);
            return turns ? make_add(b_, one, square) : make_subtract(b_, one, square);
        };
        const NodeId roots = make_call(b_, Op::Sqrt, product({by_cosine(of_.u), by_cosine(of_.v)}));
        const NodeId difference = make_subtract(b_, of_.p, of_.q);
        return product({roots, b_.apply(turns ? Op::Sinc : Op::Sinhc, difference)});
    }

    ExprBuilder& b_;
    InverseValues of_;
};

}  // namespace

bool is_inverse(Op op) {
    return is_any_of(op, {Op::Log, Op::Log10, Op::Log2, Op::Asin, Op::Acos, Op::Asinh, Op::Acosh,
                          Op::Atan, Op::Atanh});
}

NodeId inverse_slope(ExprBuilder& builder, const InverseValues& values) {
    return InverseSlope(builder, values).made();
}

}  // namespace zeroset
