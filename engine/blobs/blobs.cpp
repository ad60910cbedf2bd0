#include "engine/blobs/blobs.hpp"

#include "engine/blobs/blob_lanes.hpp"
#include "engine/real/bounds_product.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The roundings of one blob's value and slope, amply counted.
constexpr double roundings = 64;

double error_of(double blobs) { return unit_of<double> * (roundings + blobs); }

double longest_edge(const FieldBox& box) {
    return std::max({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]});
}

FieldBox hull_of(const FieldBox& a, const FieldBox& b) {
    FieldBox hull = a;
    for (std::size_t i = 0; i < 3; ++i) {
        hull.lo[i] = std::min(a.lo[i], b.lo[i]);
        hull.hi[i] = std::max(a.hi[i], b.hi[i]);
    }
    return hull;
}

/// Calls visit(first, last, hull) for runs of boxes whose hulls are at most `edge` long.
void for_each_run(std::span<const FieldBox> boxes, double edge, const auto& visit) {
    const auto take = [&](const auto& self, std::size_t first, std::size_t last) -> void {
        FieldBox hull = boxes[first];
        for (std::size_t n = first + 1; n < last; ++n)
            hull = hull_of(hull, boxes[n]);
        if (last - first == 1 || longest_edge(hull) <= edge) return visit(first, last, hull);
        const std::size_t middle = first + (last - first) / 2;
        self(self, first, middle);
        self(self, middle, last);
    };
    if (!boxes.empty()) take(take, 0, boxes.size());
}

/// Adds all blobs that reach into the box to lanes.
void add_near(const Blobs& blobs, const FieldBox& box, auto& lanes) {
    std::array<BlobRange, 64> ranges{};
    std::size_t count = 0;
    const auto flush = [&] {
        add_blobs({blobs.set(), blobs.kind(), std::span(ranges).first(count)}, lanes);
        count = 0;
    };
    blobs.set().each_near(box.lo, box.hi, [&](std::uint32_t first, std::uint32_t last) {
        if (count == ranges.size()) flush();
        ranges[count++] = {.first = first, .last = last};
    });
    flush();
}

/// h' and h'' at q within the reach.
struct HeightAt {
    double slope, bend;
};
HeightAt height_at(BlobKind kind, double q) {
    if (kind == BlobKind::Wyvill)
        return {.slope = -11.0 / 9 + q * (17.0 / 36 - q / 24), .bend = 17.0 / 36 - q / 12};
    if (kind == BlobKind::Metaball) {
        if (q <= 4.0 / 9) return {.slope = -2, .bend = 0};
        const double root = std::sqrt(q);
        return {.slope = 1 - 2 / root, .bend = 1 / (q * root)};
    }
    const double value = std::exp(2 * (1 - q));
    return {.slope = -2 * value, .bend = 4 * value};
}

}  // namespace

PointAnswer Blobs::at(const std::array<double, 3>& point, bool with_bends) const {
    PointAnswer answer;
    at(std::span(&point, 1), &answer);
    if (!with_bends) return answer;
    const double reach = blob_facts(kind_).reach;
    set_->each_near(point, point, [&](std::size_t first, std::size_t last) {
        for (std::size_t n = first; n < last; ++n) {
            std::array<double, 3> from{};
            double squares = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                from[i] = point[i] - set_->center(i)[n];
                squares += from[i] * from[i];
            }
            const double per_square = set_->per_square()[n];
            const double q = squares * per_square;
            if (q >= reach) continue;
            const HeightAt h = height_at(kind_, q);
            const double factor = 2 * set_->strength()[n] * per_square;
            for (std::size_t a = 0; a < 3; ++a) {
                answer.bend[a][a] += factor * h.slope;
                for (std::size_t b = 0; b < 3; ++b)
                    answer.bend[a][b] += factor * (2 * per_square * h.bend) * (from[a] * from[b]);
            }
        }
    });
    return answer;
}

void Blobs::at(std::span<const std::array<double, 3>> points, PointAnswer* answers) const {
    std::array<FieldBox, most_asked> places;
    for (std::size_t n = 0; n < points.size(); ++n)
        places[n] = {.lo = points[n], .hi = points[n]};
    for_each_run(std::span(places).first(points.size()), set_->usual_support(),
                 [&](std::size_t first, std::size_t last, const FieldBox& hull) {
                     BlobPoints lanes{};
                     lanes.count = last - first;
                     for (std::size_t n = first; n < last; ++n) {
                         for (std::size_t i = 0; i < 3; ++i)
                             lanes.at[i][n - first] = points[n][i];
                     }
                     add_near(*this, hull, lanes);
                     for (std::size_t n = first; n < last; ++n) {
                         answers[n].value = lanes.value[n - first];
                         for (std::size_t i = 0; i < 3; ++i)
                             answers[n].slope[i] = lanes.slope[i][n - first];
                     }
                 });
}

/// Whether a box may meet so many blobs that they are not asked one by one.
bool Blobs::is_large(const FieldBox& box) const {
    for (std::size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(box.lo[i]) || !std::isfinite(box.hi[i]) || box.lo[i] > box.hi[i])
            return true;
    }
    return longest_edge(box) > set_->usual_support();
}

BoxAnswer Blobs::over_large(const FieldBox& box) const {
    const BlobFacts facts = blob_facts(kind_);
    const BlobSet::Sums sums = set_->near_sums(box.lo, box.hi);
    const BlobSet::Sums& total = set_->total();
    BoxAnswer answer;
    answer.error = error_of(static_cast<double>(set_->size())) * sums.size() * facts.top +
                   facts.tail * total.size();
    answer.value = ValueBounds{.lo = sums.below * facts.top, .hi = sums.above * facts.top}.widened(
        answer.error);
    const double slope =
        sums.per_radius * facts.slope * (1 + error_of(static_cast<double>(set_->size()))) +
        facts.tail * total.per_radius;
    answer.slopes.fill({.lo = -slope, .hi = slope});
    return answer;
}

/// Encloses the sums over boxes close to each other.
void Blobs::over_near(std::span<const FieldBox> boxes, std::span<const std::size_t> of,
                      BoxAnswer* answers) const {
    const BlobFacts facts = blob_facts(kind_);
    const BlobSet::Sums& total = set_->total();
    for_each_run(
        boxes, 2 * set_->usual_support(),
        [&](std::size_t first, std::size_t last, const FieldBox& hull) {
            BlobBoxes lanes{};
            lanes.count = last - first;
            for (std::size_t n = first; n < last; ++n) {
                for (std::size_t i = 0; i < 3; ++i) {
                    lanes.lo[i][n - first] = boxes[n].lo[i];
                    lanes.hi[i][n - first] = boxes[n].hi[i];
                }
            }
            add_near(*this, hull, lanes);
            for (std::size_t n = first; n < last; ++n) {
                const std::size_t lane = n - first;
                const double error = error_of(lanes.reached[lane]);
                BoxAnswer& answer = answers[of[n]];
                answer = {};
                answer.error = error * lanes.size[lane] * facts.top + facts.tail * total.size();
                answer.value =
                    ValueBounds{.lo = lanes.value_lo[lane], .hi = lanes.value_hi[lane]}.widened(
                        answer.error);
                const double slope_error = error * lanes.size_per_radius[lane] * facts.slope +
                                           facts.tail * total.per_radius;
                for (std::size_t i = 0; i < 3; ++i) {
                    answer.slopes[i] =
                        ValueBounds{.lo = lanes.slope_lo[i][lane], .hi = lanes.slope_hi[i][lane]}
                            .widened(slope_error);
                }
            }
        });
}

void Blobs::over(std::span<const FieldBox> boxes, BoxAnswer* answers) const {
    std::array<FieldBox, most_asked> near;
    std::array<std::size_t, most_asked> of{};
    std::size_t count = 0;
    for (std::size_t n = 0; n < boxes.size(); ++n) {
        if (is_large(boxes[n])) {
            answers[n] = over_large(boxes[n]);
        } else {
            near[count] = boxes[n];
            of[count++] = n;
        }
    }
    over_near(std::span(near).first(count), std::span(of).first(count), answers);
}

BendAnswer Blobs::bend(const FieldBox& box, const std::array<std::size_t, 2>& axes) const {
    const BlobFacts facts = blob_facts(kind_);
    const BlobSet::Sums& total = set_->total();
    const double most = total.per_square * facts.bend * 2;
    BendAnswer answer{.value = {.lo = -most, .hi = most}, .smooth = kind_ == BlobKind::Blinn};
    if (is_large(box)) return answer;
    answer = {};
    double size = 0;
    double count = 0;
    set_->each_near(box.lo, box.hi, [&](std::size_t first, std::size_t last) {
        for (std::size_t n = first; n < last; ++n) {
            std::array<ValueBounds, 3> from;
            double near = 0;
            double far = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                from[i] = {.lo = box.lo[i] - set_->center(i)[n],
                           .hi = box.hi[i] - set_->center(i)[n]};
                const double gap = std::max({from[i].lo, -from[i].hi, 0.0});
                near += gap * gap;
                far += from[i].size() * from[i].size();
            }
            const double per_square = set_->per_square()[n];
            constexpr double slack = 0x1p-44;
            const ValueBounds q{.lo = near * per_square * (1 - slack),
                                .hi = far * per_square * (1 + slack)};
            if (q.lo >= facts.reach) continue;
            const HeightAt begin = height_at(kind_, q.lo);
            const HeightAt end = height_at(kind_, std::min(q.hi, facts.reach));
            ValueBounds slope{.lo = begin.slope, .hi = end.slope};
            ValueBounds bend{.lo = std::min(begin.bend, end.bend),
                             .hi = std::max(begin.bend, end.bend)};
            const bool turns = kind_ == BlobKind::Metaball && q.lo <= 4.0 / 9 && q.hi > 4.0 / 9;
            if (turns) bend.add({.lo = 0, .hi = 27.0 / 8 + 1e-9});
            const bool ends = q.hi >= facts.reach && kind_ != BlobKind::Blinn;
            if (ends || q.hi >= facts.reach) {
                slope.add({});
                bend.add({});
            }
            answer.smooth = answer.smooth && !turns && !ends;
            const double factor = 2 * set_->strength()[n] * per_square;
            ValueBounds sum =
                product_of(product_of(from[axes[0]], from[axes[1]]),
                           product_of(bend, {.lo = 2 * per_square, .hi = 2 * per_square}));
            if (axes[0] == axes[1]) sum = {.lo = sum.lo + slope.lo, .hi = sum.hi + slope.hi};
            sum = product_of(sum, {.lo = factor, .hi = factor});
            answer.value = {.lo = answer.value.lo + sum.lo, .hi = answer.value.hi + sum.hi};
            size += std::max(sum.size(), std::abs(factor) * facts.bend);
            ++count;
        }
    });
    answer.value =
        answer.value.widened(error_of(count) * size * 4 + 64 * facts.tail * total.per_square);
    return answer;
}

std::shared_ptr<const Field> blobs_field(BlobKind kind, std::span<const Blob> blobs,
                                         const std::string& text) {
    struct Known {
        BlobKind kind;
        std::vector<Blob> blobs;
        std::shared_ptr<const Field> field;
    };
    constexpr std::size_t most_kept = 8;
    static std::mutex mutex;
    static std::deque<Known> latest;
    const std::scoped_lock lock(mutex);
    const auto same = std::ranges::find_if(latest, [&](const Known& known) {
        return known.kind == kind && known.field->text() == text &&
               std::ranges::equal(known.blobs, blobs);
    });
    if (same != latest.end()) {
        std::rotate(same, std::next(same), latest.end());
        return latest.back().field;
    }
    latest.push_back({.kind = kind,
                      .blobs = {blobs.begin(), blobs.end()},
                      .field = std::make_shared<const BlobsField>(Blobs(kind, blobs), text)});
    if (latest.size() > most_kept) latest.pop_front();
    return latest.back().field;
}

}  // namespace zeroset
