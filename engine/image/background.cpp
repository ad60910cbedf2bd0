#include "engine/image/background.hpp"

namespace zeroset {

std::uint32_t background_color(const Background& background, int row, int height) {
    const double t = (row + 0.5) / height;
    const auto mixed = [&](unsigned shift) {
        const double top = background.top >> shift & 0xFFU;
        const double bottom = background.bottom >> shift & 0xFFU;
        return static_cast<std::uint32_t>(top + t * (bottom - top));
    };
    return 0xFF000000U | mixed(0) << 16U | mixed(8) << 8U | mixed(16);
}

}  // namespace zeroset
