#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace zeroset {

/// The type in which a sample is stored.
enum class SampleType : std::uint8_t {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float,
    Double
};

/// Bytes of one sample.
std::size_t size_of(SampleType type);
/// "int16", "float32" and so on.
std::string_view name_of(SampleType type);

/// How many samples there are along i, j and k.
using GridSize = std::array<std::uint64_t, 3>;

/// The number of bytes of a grid, or nothing where that is no 63-bit number.
std::optional<std::uint64_t> bytes_of(const GridSize& size, SampleType type);

/// Samples of a regular grid in memory, i running fastest, in this machine's byte order and aligned
/// as their type asks.
struct Samples {
    SampleType type = SampleType::Float;
    GridSize size{};
    std::shared_ptr<const void> data{};  ///< owns or maps them

    [[nodiscard]] std::uint64_t count() const { return size[0] * size[1] * size[2]; }
};

/// Calls `function` with the samples as an array of their own type.
auto visit_samples(const Samples& samples, auto function) {
    const void* const data = samples.data.get();
    switch (samples.type) {
        case SampleType::Int8: return function(static_cast<const std::int8_t*>(data));
        case SampleType::UInt8: return function(static_cast<const std::uint8_t*>(data));
        case SampleType::Int16: return function(static_cast<const std::int16_t*>(data));
        case SampleType::UInt16: return function(static_cast<const std::uint16_t*>(data));
        case SampleType::Int32: return function(static_cast<const std::int32_t*>(data));
        case SampleType::UInt32: return function(static_cast<const std::uint32_t*>(data));
        case SampleType::Int64: return function(static_cast<const std::int64_t*>(data));
        case SampleType::UInt64: return function(static_cast<const std::uint64_t*>(data));
        case SampleType::Float: break;
        case SampleType::Double: return function(static_cast<const double*>(data));
    }
    return function(static_cast<const float*>(data));
}

}  // namespace zeroset
