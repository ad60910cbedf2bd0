#include "engine/trace/frame_union.hpp"

#include "engine/kernel/form_cells.hpp"
#include "engine/real/scalar.hpp"
#include "engine/real/unbounded.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace zeroset {
namespace {

/// Whether the clip box's faces are in the layers under those of the box that holds it.
bool has_faces_in_layers(const Box& clip, const Box& domain, double spare) {
    const double thick = face_layer * domain.size();
    return glm::all(glm::lessThan(clip.lo + spare, domain.lo + thick)) &&
           glm::all(glm::greaterThan(clip.hi - spare, domain.hi - thick));
}

bool outside(const glm::dvec3& point, const Box& box, double spare) {
    return glm::any(glm::lessThan(point, box.lo - spare)) ||
           glm::any(glm::greaterThan(point, box.hi + spare));
}

/// A member of a union that lies in the box, as the view shows it.
UnionMember seen(const TraceFrame& frame, const Kernel* kernel, const Box& box, double spare) {
    constexpr double pixel_spare = 1.0;
    UnionMember member{.kernel = kernel,
                       .from = unbounded,
                       .to = -unbounded,
                       .first_col = unbounded,
                       .last_col = -unbounded,
                       .first_row = unbounded,
                       .last_row = -unbounded};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? box.hi.x + spare : box.lo.x - spare,
                            (corner & 2) != 0 ? box.hi.y + spare : box.lo.y - spare,
                            (corner & 4) != 0 ? box.hi.z + spare : box.lo.z - spare);
        const double along = glm::dot(at - frame.view.eye, frame.view.forward);
        if (!frame.view.parallel() && along < 0x1p-10 * (box.size() + spare))
            return {.kernel = kernel,
                    .from = -unbounded,
                    .to = unbounded,
                    .first_col = -unbounded,
                    .last_col = unbounded,
                    .first_row = -unbounded,
                    .last_row = unbounded};
        const glm::dvec3 shown = frame.view.homogeneous(at);
        const double half = 0.5 * frame.image.height;
        const double col = 0.5 * frame.image.width + half * (shown.x / shown.z);
        const double row = half - half * (shown.y / shown.z);
        member.from = std::min(member.from, along - frame.view.look_distance - spare);
        member.to = std::max(member.to, along - frame.view.look_distance + spare);
        member.first_col = std::min(member.first_col, col - pixel_spare);
        member.last_col = std::max(member.last_col, col + pixel_spare);
        member.first_row = std::min(member.first_row, row - pixel_spare);
        member.last_row = std::max(member.last_row, row + pixel_spare);
    }
    return member;
}

bool meets(const UnionMember& member, const Tile& tile) {
    return member.last_col >= tile.col && member.first_col <= tile.col + tile.cols &&
           member.last_row >= tile.row && member.first_row <= tile.row + tile.rows;
}

/// Where the rays of a tile enter the clip box, as one cell for each of its sixteenths.
template <class Real>
class Entries {
public:
    Entries(const TraceFrame& frame, const Tile& tile);

    /// Whether f is above 0 where the rays enter, and continuous.
    bool are_above_zero(const Kernel& kernel);

private:
    static constexpr std::size_t capacity = batch_multiple;
    static constexpr int across = 4;
    static constexpr int side = tile_size / across;
    static constexpr auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());

    const TraceFrame& frame_;
    FrustumOf<Real> frustum_;
    std::size_t size_ = 0;
    FormCells<Real, capacity> cells_;
};

template <class Real>
Entries<Real>::Entries(const TraceFrame& frame, const Tile& tile) : frame_(frame) {
    const TileRays rays(frame, tile);
    frustum_ = rays.frustum<Real>(side);
    const double half = 0.5 * (side - 1);
    for (int i = 0; i < across * across; ++i) {
        const int col = i % across * side;
        const int row = i / across * side;
        if (col >= tile.cols || row >= tile.rows) continue;
        const double u = rays.u(col + half);
        const double v = rays.v(row + half);
        const double radius = half * rays.pixel();
        const DepthRange depths = rays.depths(u, v, radius, radius);
        if (depths.empty()) continue;
        const double far = std::min(depths.enter_hi, depths.exit_hi);
        const double most = std::max(std::abs(depths.enter_lo), std::abs(far));
        cells_.u[size_] = static_cast<Real>(u);
        cells_.v[size_] = static_cast<Real>(v);
        cells_.s[size_] = static_cast<Real>(0.5 * (depths.enter_lo + far));
        cells_.s_radius[size_] = upper_end(
            Real{}, 0.5 * (far - depths.enter_lo) + 16 * most * unit + 4 * rays.depth_error());
        ++size_;
    }
    for (std::size_t i = size_; i < capacity && size_ > 0; ++i) {
        cells_.u[i] = cells_.u[0];
        cells_.v[i] = cells_.v[0];
        cells_.s[i] = cells_.s[0];
        cells_.s_radius[i] = cells_.s_radius[0];
    }
}

template <class Real>
bool Entries<Real>::are_above_zero(const Kernel& kernel) {
    if (size_ == 0) return true;
    kernel.form(cells_.batch(capacity, frustum_, frame_.scene.uniforms.template boxes<Real>()));
    for (std::size_t i = 0; i < size_; ++i) {
        const bool above = cells_.c[i] > cells_.spread(i);
        if (!above || cells_.continuous[i] == 0) return false;
    }
    return true;
}

}  // namespace

ReachBox reach_box(const Box& box) {
    ReachBox result{};
    for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        result.lo[axis] = -float_above(-box.lo[i]);
        result.hi[axis] = float_above(box.hi[i]);
    }
    return result;
}

Box box_of(const ReachBox& box) {
    return {.lo = {box.lo[0], box.lo[1], box.lo[2]}, .hi = {box.hi[0], box.hi[1], box.hi[2]}};
}

FrameUnion::FrameUnion(const TraceFrame& frame, const UnionParts& union_parts) : frame_(frame) {
    const Box& clip = frame.scene.clip;
    const ReachBox domain = reach_box(clip);
    const auto reaches = union_parts.reaches(domain, frame.scene.uniforms);
    const double spare = 4 * place_error(frame);
    const bool tells_of_faces = has_faces_in_layers(clip, box_of(domain), spare);
    for (std::size_t i = 0; i < reaches->size(); ++i) {
        const Reach& reach = (*reaches)[i];
        if (!reach.any) continue;
        const Box box = box_of(reach.box);
        const bool enclosed = reach.within && tells_of_faces &&
                              (frame.view.parallel() || outside(frame.view.eye, box, spare));
        members_.push_back({.in_view = seen(frame, union_parts.kernels()[i], box, spare),
                            .continuous = reach.continuous,
                            .enclosed = enclosed});
    }
    std::ranges::stable_sort(members_, {},
                             [](const Member& member) { return member.in_view.from; });
}

template <class Real>
bool FrameUnion::are_apart(std::span<const Member* const> members, const Tile& tile) const {
    std::optional<Entries<Real>> entries;  // few tiles need them
    for (const Member* const member : members) {
        if (!member->continuous) return false;
        if (member->enclosed) continue;
        if (!entries) entries.emplace(frame_, tile);
        if (!entries->are_above_zero(*member->in_view.kernel)) return false;
    }
    return true;
}

bool FrameUnion::list(const Tile& tile, std::vector<UnionMember>& members) const {
    members.clear();
    std::vector<const Member*> in_tile;
    for (const Member& member : members_) {
        if (!meets(member.in_view, tile)) continue;
        members.push_back(member.in_view);
        in_tile.push_back(&member);
    }
    if (members.size() < 2) return true;
    return frame_.precision == Precision::Double ? are_apart<double>(in_tile, tile)
                                                 : are_apart<float>(in_tile, tile);
}

}  // namespace zeroset
