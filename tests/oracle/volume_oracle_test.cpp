#include "engine/language/vocabulary/field_source.hpp"
#include "engine/volume/spline.hpp"
#include "engine/volume/volume.hpp"
#include "pipeline/volume_source.hpp"
#include "tests/oracle/ray_audit.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

// Tracers on volumes against each cell's polynomial, solved exactly. ZEROSET_FORMULAS says how many
// volumes are made, each for some 500 rays.

namespace zeroset::test::volume_oracle_test {
namespace {

/// Numbers that are hard to trace: noise, thin sheets, plateaus, zero cells, single samples.
std::vector<float> hard_numbers(std::uint64_t kind, const GridSize& size, RandomNumbers& random) {
    std::vector<float> numbers;
    for (std::uint64_t k = 0; k < size[2]; ++k) {
        for (std::uint64_t j = 0; j < size[1]; ++j) {
            for (std::uint64_t i = 0; i < size[0]; ++i) {
                const double x = static_cast<double>(i) / static_cast<double>(size[0] - 1);
                double value = random.uniform(-1, 1);
                if (kind == 1) value = k == size[2] / 2 ? 1.0 : -0.9;    // a sheet of a sample
                if (kind == 2) value = random.one_in(3) ? 1.0 : -1.0;    // plateaus and corners
                if (kind == 3) value = random.one_in(2) ? 0.0 : value;   // many zero cells
                if (kind == 4) value = std::sin(9 * x) + 0.2 * value;    // waves with noise
                if (kind == 5) value = random.one_in(50) ? 1.0 : -0.02;  // single samples
                numbers.push_back(static_cast<float>(value));
            }
        }
    }
    return numbers;
}

enum class Between : std::uint8_t { Trilinear, Cubic };

/// `most`: samples along an axis.
std::shared_ptr<const Volume> hard_volume(std::uint64_t seed, Between kind, int most,
                                          const std::string& text) {
    RandomNumbers random(seed);
    GridSize size{};
    for (auto& count : size)
        count = static_cast<std::uint64_t>(random.between(3, most));
    const auto numbers =
        std::make_shared<const std::vector<float>>(hard_numbers(seed % 6, size, random));
    Geometry place;
    const double angle = seed % 2 == 0 ? 0 : random.uniform(0, 6.28);
    std::array<double, 3> spacing{};
    for (std::size_t i = 0; i < 3; ++i)
        spacing[i] = 2 * random.uniform(0.3, 1) / static_cast<double>(size[i] - 1);
    place.world_from_index = {{{std::cos(angle) * spacing[0], 0, -std::sin(angle) * spacing[2]},
                               {0, spacing[1], 0},
                               {std::sin(angle) * spacing[0], 0, std::cos(angle) * spacing[2]}}};
    const auto middle = world_point(
        place, {0.5 * static_cast<double>(size[0] - 1), 0.5 * static_cast<double>(size[1] - 1),
                0.5 * static_cast<double>(size[2] - 1)});
    for (std::size_t i = 0; i < 3; ++i)
        place.origin[i] = -middle[i];
    const auto data =
        VolumeData::make({.type = SampleType::Float,
                          .size = size,
                          .data = std::shared_ptr<const void>(numbers, numbers->data())},
                         place);
    const Outside outside = seed % 5 == 0 ? Outside::Edge : Outside::Undefined;
    if (kind == Between::Trilinear) return Volume::make(data.value(), {.outside = outside}, text);
    const SplineKind spline = seed % 4 == 1 ? SplineKind::Smoothing : SplineKind::Interpolating;
    return Volume::make(SplineData::of(data.value(), spline).value(), {.outside = outside}, text);
}

/// volume("SEED")
class HardVolumes final : public FieldSource {
public:
    HardVolumes(Between kind, int most) : kind_(kind), most_(most) {}

    [[nodiscard]] std::expected<std::shared_ptr<const Field>, FieldError> open(
        const FieldCall& call) const override {
        std::uint64_t seed = 0;
        std::from_chars(call.file.data(), call.file.data() + call.file.size(), seed);
        return hard_volume(seed, kind_, most_, std::string(call.text));
    }

private:
    Between kind_;
    int most_;  ///< samples along an axis
};

struct AuditPlan {
    Between kind;
    int volumes;
    int most = 14;     ///< samples along an axis
    bool cut = false;  ///< by spheres and sections, in both projections
    int first = 0;     ///< of the volumes
};

AuditReport audit_of(const AuditPlan& plan, const AuditSettings& settings) {
    const auto volumes = std::make_shared<const HardVolumes>(plan.kind, plan.most);
    AuditReport total;
    for (int n = plan.first; n < plan.first + plan.volumes; ++n) {
        RandomNumbers random(static_cast<std::uint64_t>(n) + 500);
        const std::array levels{" = 0", " = 0.3", " = -0.01", " = 0.9999"};
        const std::string name = std::to_string(n);
        AuditSurface surface{
            .name = "volume " + name,
            .equation = "volume(\"" + name + "\")(x, y, z)" + levels[random.below(levels.size())],
            .clip = Box::cube(1.1),
            .w = 0.0,
            .camera = suite_camera(1.3),
            .files = volumes};
        surface.camera.eye = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(1, 3)};
        if (plan.cut) {
            const std::vector<AuditSurface> of(static_cast<std::size_t>(n) % 12 + 1, surface);
            surface = cut_open(of, static_cast<std::uint64_t>(n)).back();
        }
        total += audit(surface, settings);
    }
    return total;
}

const AuditSettings beams{.tracer = "beams", .interpreted = true};

void expect_sound(const AuditReport& total) {
    for (std::size_t i = 0; i < std::min<std::size_t>(total.failures.size(), 10); ++i)
        ADD_FAILURE() << total.failures[i];
    EXPECT_EQ(total.failures.size(), 0U);
    std::printf("%s\n", total.text().c_str());
    EXPECT_GT(total.hit, total.rays / 4);
    EXPECT_LT(total.unknown, total.rays / 20);
    EXPECT_GT(total.hit_certified, total.hit * 9 / 10);
}

TEST(TracerOnVolumes, MissesNoRootAndCertifiesOnlyTrueOnes) {
    expect_sound(audit_of({Between::Trilinear, formulas_to_try(6)}, beams));
}

TEST(TracerOnVolumes, MissesNoRootVoxelByVoxelAndCertifiesOnlyTrueOnes) {
    AuditSettings voxels = beams;
    voxels.knows_fields = true;
    expect_sound(audit_of({Between::Trilinear, formulas_to_try(6)}, voxels));
    expect_sound(audit_of({Between::Trilinear, formulas_to_try(6), 40}, voxels));
}

TEST(TracerOnVolumes, MissesNoRootVoxelByVoxelWhereTheyAreCut) {
    AuditSettings voxels = beams;
    voxels.knows_fields = true;
    const AuditReport total =
        audit_of({.kind = Between::Trilinear, .volumes = formulas_to_try(6), .cut = true}, voxels);
    std::printf("%s\n", total.text().c_str());
    EXPECT_EQ(total.failures, std::vector<std::string>());
    EXPECT_GT(total.hit_certified, total.hit * 9 / 10);
}

// In this volume's view most of what is left by the cuts lies behind the grid.
TEST(TracerOnVolumes, FindsNothingBehindTheGrid) {
    AuditSettings voxels = beams;
    voxels.knows_fields = true;
    const AuditReport total =
        audit_of({.kind = Between::Trilinear, .volumes = 1, .cut = true, .first = 578}, voxels);
    EXPECT_EQ(total.failures, std::vector<std::string>());
    EXPECT_GT(total.empty, 500U);
}

TEST(TracerOnVolumes, MissesNoRootOfSplinesVoxelByVoxelAndCertifiesOnlyTrueOnes) {
    AuditSettings voxels = beams;
    voxels.knows_fields = true;
    expect_sound(audit_of({Between::Cubic, formulas_to_try(3)}, voxels));
    expect_sound(audit_of({Between::Cubic, formulas_to_try(2), 40}, voxels));
}

TEST(TracerOnVolumes, MissesNoRootOfSplinesAndCertifiesOnlyTrueOnes) {
    expect_sound(audit_of({Between::Cubic, formulas_to_try(3)}, beams));
}

}  // namespace
}  // namespace zeroset::test::volume_oracle_test
