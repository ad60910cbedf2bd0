// The nearest roots found so far on the rays of a tile.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_NEAREST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_NEAREST_INL
#undef ZEROSET_BEAM_NEAREST_INL
#else
#define ZEROSET_BEAM_NEAREST_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/beam/cover_marks-inl.hpp"
#include "engine/trace/simd/bit_bytes.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The nearest roots on a tile's rays so far, in the type of its cells.
template <class Real>
class NearestRoots {
public:
    static constexpr Real none = std::numeric_limits<Real>::infinity();

    /// Begins a tile whose certificates and gradients go to `hits`, which is clear. Where less is
    /// wanted of its rays, a root stands at the limit until `end` takes it away.
    void begin(TileHits& hits, const Tile& tile, const TileRays& rays) {
        if constexpr (std::is_same_v<Real, float>) {
            s = hits.depth.data();
        } else {
            own_.assign(tile_pixels, none);
            s = own_.data();
        }
        any_ = false;
        hits_ = &hits;
        pending.clear();
        limits_.clear();
        if (tile.limits == nullptr) return;
        for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel)
            s[pixel] = upper_end(Real{}, rays.limit(pixel));
        limits_.assign(s, s + tile_pixels);
    }
    void end() {
        for (std::size_t pixel = 0; pixel < limits_.size(); ++pixel) {
            if (s[pixel] == limits_[pixel]) s[pixel] = none;
        }
    }
    /// Takes a root at the depth `at` if it is the nearest so far; returns whether it is.
    bool add(std::size_t pixel, double at, Certificate known, const std::array<float, 3>& slope) {
        if (!(at < static_cast<double>(s[pixel]))) return false;
        any_ = true;
        s[pixel] = static_cast<Real>(at);
        hits_->certificate[pixel] = known;
        for (std::size_t k = 0; k < 3; ++k)
            hits_->gradient[k][pixel] = slope[k];
        return true;
    }
    /// Takes a root whose gradient is not known yet, if it is the nearest so far.
    void add_pending(std::uint32_t pixel, double at, Certificate known, Trend trend) {
        if (add(pixel, at, known, {})) pending.push_back({pixel, at, trend});
    }
    /// Certifies the roots of those of `most` pixels from `pixel` on whose bits are set; the caller
    /// writes their depths and gradients to `s` and `gradients`.
    template <std::size_t most>
    void certify(std::size_t pixel, LaneBits bits) {
        static_assert(most <= 8);
        any_ = true;
        Certificate* const known = &hits_->certificate[pixel];
        const std::uint64_t bytes = bytes_of_bits(bits);
        std::uint64_t all = 0;
        std::memcpy(&all, known, most);
        constexpr auto certified = static_cast<std::uint64_t>(Certificate::Certified);
        all = (all & ~bytes) | (bytes & (certified * 0x0101010101010101U));
        std::memcpy(known, &all, most);
    }
    /// Certifies the roots of all of `most` pixels from `pixel` on.
    template <std::size_t most>
    void certify(std::size_t pixel) {
        any_ = true;
        std::memset(&hits_->certificate[pixel], static_cast<int>(Certificate::Certified), most);
    }
    float* gradients(std::size_t axis, std::size_t pixel) { return &hits_->gradient[axis][pixel]; }
    [[nodiscard]] bool any() const { return any_; }

    /// The depth of the nearest root of each pixel, in rows of tile_size; +inf: none. In float it
    /// stands in TileHits::depth, whose distances BeamTile::write_hits makes of it in the end: an
    /// array of its own takes the quickest pictures some hundredths longer.
    Real* s = nullptr;
    CoverMarks<Real> cover;
    /// Roots whose gradients are not known, or not for sure.
    struct Pending {
        std::uint32_t pixel;
        double s;
        Trend trend;
    };
    std::vector<Pending> pending;

private:
    bool any_ = false;
    std::vector<Real> own_;     ///< depths that have no place in the hits
    std::vector<Real> limits_;  ///< what `s` began with; empty: `none`
    TileHits* hits_ = nullptr;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
