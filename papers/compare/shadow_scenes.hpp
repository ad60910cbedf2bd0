#pragma once

#include <array>
#include <string_view>

namespace zeroset {

/// A surface that throws shadows on itself, in the box [-domain, domain]^3.
struct ShadowScene {
    std::string_view name, formula;
    double domain;
};

/// The name, as it is typed, of the comparison of shadow beams with single shadow rays [Florez08,
/// sec. 5.4.4], and what is printed of it.
struct ShadowTable {
    std::string_view name, source, note;
    int size_px;
    double printed_rays_min, printed_boxes_min;  ///< minutes of the whole picture
    std::array<ShadowScene, 4> scenes;
};

const ShadowTable& shadow_table();

}  // namespace zeroset
