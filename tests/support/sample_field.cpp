#include "tests/support/sample_field.hpp"

#include "engine/noise/cellular.hpp"
#include "engine/noise/lattice_noise.hpp"
#include "engine/noise/noise.hpp"
#include "engine/volume/spline.hpp"
#include "tests/support/blob_reference.hpp"
#include "tests/support/noise_reference.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/special_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace zeroset::test {
namespace {

std::shared_ptr<const Volume> made_field() {
    RandomNumbers random(2004);
    constexpr GridSize size{6, 5, 4};
    auto numbers = std::make_shared<std::vector<double>>(size[0] * size[1] * size[2]);
    for (double& number : *numbers)
        number = random.uniform(-1, 1);
    const Samples samples{.type = SampleType::Double,
                          .size = size,
                          .data = std::shared_ptr<const void>(numbers, numbers->data())};
    const Geometry place{.world_from_index = {{{0.5, 0.1, 0}, {-0.1, 0.6, 0.2}, {0.05, -0.1, 0.9}}},
                         .origin = {-1.4, -1.1, -1.2}};
    return Volume::make(VolumeData::make(samples, place).value(), {.outside = Outside::Edge},
                        "volume(\"sample\")");
}

/// The weights of four coefficients at `t` in a cell: the pieces of the cubic B-spline.
std::array<MpfrNumber, 4> spline_weights(const MpfrNumber& t) {
    const MpfrNumber s = MpfrNumber(1.0) - t;
    const auto cube = [](const MpfrNumber& x) { return x * x * x; };
    const auto middle = [&](const MpfrNumber& x) {
        return MpfrNumber(3.0) * cube(x) - MpfrNumber(6.0) * x * x + MpfrNumber(4.0);
    };
    std::array weights{cube(s), middle(t), middle(s), cube(t)};
    for (MpfrNumber& weight : weights)
        weight = weight / MpfrNumber(6.0);
    return weights;
}

Reference spline_reference(const SplineData& spline, const std::array<std::uint64_t, 3>& cell,
                           const std::array<MpfrNumber, 3>& share) {
    const std::array weights{spline_weights(share[0]), spline_weights(share[1]),
                             spline_weights(share[2])};
    MpfrNumber sum(0.0);
    for (std::size_t n = 0; n < 64; ++n) {
        const std::array of{n % 4, n / 4 % 4, n / 16};
        const MpfrNumber term(
            coefficient_at(spline, cell[0] + of[0], cell[1] + of[1], cell[2] + of[2]));
        if (!term.is_finite()) return {};
        sum = sum + term * weights[0][of[0]] * weights[1][of[1]] * weights[2][of[2]];
    }
    return {.defined = true, .value = sum};
}

}  // namespace

const std::shared_ptr<const Volume>& sample_field() {
    static const std::shared_ptr<const Volume> field = made_field();
    return field;
}

const std::vector<std::shared_ptr<const Field>>& sample_fields() {
    static const std::vector<std::shared_ptr<const Field>> fields{
        sample_field(),
        noise_field(NoiseWord::Noise, 0),
        noise_field(NoiseWord::ValueNoise, 7),
        noise_field(NoiseWord::Cellular, 0),
        noise_field(NoiseWord::Cellular2, 4294967295U),
        sample_blobs(BlobKind::Wyvill),
        sample_blobs(BlobKind::Metaball),
        sample_blobs(BlobKind::Blinn),
        special_field(SpecialFunction::Erf),
        special_field(SpecialFunction::ReciprocalGamma),
        special_field(SpecialFunction::BesselJ, 2),
        special_field(SpecialFunction::BesselY)};
    return fields;
}

Reference field_reference(const Field& field, const MpfrNumber& x, const MpfrNumber& y,
                          const MpfrNumber& z) {
    if (const auto* const volume = dynamic_cast<const Volume*>(&field))
        return field_reference(*volume, x, y, z);
    if (const auto* const noise = dynamic_cast<const LatticeNoiseField*>(&field)) {
        const LatticeNoise& of = noise->function();
        return {.defined = true, .value = lattice_noise_reference(of.kind(), of.seed(), x, y, z)};
    }
    if (const auto* const cells = dynamic_cast<const CellularField*>(&field)) {
        const Cellular& of = cells->function();
        return {.defined = true, .value = cellular_reference(of.rank(), of.seed(), x, y, z)};
    }
    if (const auto* const line = dynamic_cast<const LineField*>(&field))
        return special_reference(*line, x);
    if (const auto* const balls = dynamic_cast<const BlobsField*>(&field))
        return {.defined = true, .value = blobs_reference(balls->function(), x, y, z)};
    ADD_FAILURE() << "the reference does not know the field " << field.text();
    return {};
}

Reference field_reference(const Volume& volume, const MpfrNumber& x, const MpfrNumber& y,
                          const MpfrNumber& z) {
    const VolumeData& data = volume.data();
    const IndexMap& map = data.map();
    const std::array point{x, y, z};
    std::array<std::uint64_t, 3> cell{};
    std::array<MpfrNumber, 3> share;
    for (std::size_t i = 0; i < 3; ++i) {
        MpfrNumber index(map.shift[i]);
        for (std::size_t c = 0; c < 3; ++c)
            index = index + MpfrNumber(map.index_from_world[i][c]) * point[c];
        if (index.is_nan()) return {.defined = true, .value = index};
        const auto end = static_cast<double>(data.samples().size[i] - 1);
        const bool below = index < 0.0;
        if (below || index > end) {
            if (volume.options().outside == Outside::Undefined) return {};
            if (volume.options().outside == Outside::Constant)
                return {.defined = true, .value = MpfrNumber(volume.options().constant)};
            index = MpfrNumber(below ? 0.0 : end);
        }
        cell[i] = std::min(static_cast<std::uint64_t>(mpfr_get_d(index.get(), MPFR_RNDD)),
                           data.samples().size[i] - 2);
        share[i] = index - MpfrNumber(static_cast<double>(cell[i]));
    }
    if (volume.spline() != nullptr) return spline_reference(*volume.spline(), cell, share);
    MpfrNumber sum(0.0);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const std::array<std::uint64_t, 3> of{corner & 1U, corner >> 1U & 1U, corner >> 2U};
        MpfrNumber term(sample_at(data, cell[0] + of[0], cell[1] + of[1], cell[2] + of[2]));
        if (!term.is_finite()) return {};
        for (std::size_t i = 0; i < 3; ++i)
            term = term * (of[i] == 1 ? share[i] : MpfrNumber(1.0) - share[i]);
        sum = sum + term;
    }
    return {.defined = true, .value = sum};
}

NodeId applied(ExprBuilder& builder, Op op, NodeId a, NodeId b, NodeId c, int number) {
    if (op == Op::Field) return builder.look_up(sample_field(), a, b, c, number);
    return builder.apply(op, a, b, c, number);
}

Node node_of(Op op, int number) {
    Node node{.op = op, .number = number};
    if (op == Op::Field) node.field = sample_field();
    return node;
}

}  // namespace zeroset::test
