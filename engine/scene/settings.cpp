#include "engine/scene/settings.hpp"

#include "engine/base/enum_names.hpp"

namespace zeroset {
namespace {

constexpr auto antialias_names = enum_names<Antialias>("none", "iaa", "4", "9", "16", "64");

}  // namespace

std::string_view name_of(Antialias antialias) { return antialias_names.of(antialias); }

std::optional<Antialias> antialias_named(std::string_view name) {
    return name == "1" ? Antialias::None : antialias_names.named(name);
}

int rays_across(Antialias antialias) {
    switch (antialias) {
        case Antialias::None:
        case Antialias::Beams: break;
        case Antialias::Rays4: return 2;
        case Antialias::Rays9: return 3;
        case Antialias::Rays16: return 4;
        case Antialias::Rays64: return 8;
    }
    return 1;
}

}  // namespace zeroset
