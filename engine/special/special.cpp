#include "engine/special/special.hpp"

#include "engine/special/families.hpp"

#include <map>
#include <mutex>
#include <utility>

namespace zeroset {
namespace {

PiecedLine made(SpecialFunction function, int order) {
    switch (function) {
        case SpecialFunction::Erf: return erf_line();
        case SpecialFunction::Erfc: return erfc_line();
        case SpecialFunction::ReciprocalGamma: return reciprocal_gamma_line();
        case SpecialFunction::LogGamma: return log_gamma_line();
        case SpecialFunction::Digamma: return digamma_line();
        case SpecialFunction::ZetaTimes: return zeta_line();
        case SpecialFunction::LambertOfRoot: return lambert_line();
        case SpecialFunction::BesselJ: return bessel_j_line(order);
        case SpecialFunction::BesselY: return bessel_y_line(order);
        case SpecialFunction::BesselI: return bessel_i_line(order);
        case SpecialFunction::BesselK: return bessel_k_line(order);
    }
    return {};
}

}  // namespace

std::shared_ptr<const Field> special_field(SpecialFunction function, int order) {
    static std::mutex mutex;
    static std::map<std::pair<SpecialFunction, int>, std::shared_ptr<const Field>> known;
    const std::scoped_lock lock(mutex);
    auto& field = known[{function, order}];
    if (!field)
        field = std::make_shared<LineField>(std::make_shared<PiecedLine>(made(function, order)), 0);
    return field;
}

}  // namespace zeroset
