#include "engine/volume/samples.hpp"

#include <limits>

namespace zeroset {

std::size_t size_of(SampleType type) {
    switch (type) {
        case SampleType::Int8:
        case SampleType::UInt8: return 1;
        case SampleType::Int16:
        case SampleType::UInt16: return 2;
        case SampleType::Int32:
        case SampleType::UInt32:
        case SampleType::Float: return 4;
        case SampleType::Int64:
        case SampleType::UInt64:
        case SampleType::Double: return 8;
    }
    return 1;
}

std::string_view name_of(SampleType type) {
    switch (type) {
        case SampleType::Int8: return "int8";
        case SampleType::UInt8: return "uint8";
        case SampleType::Int16: return "int16";
        case SampleType::UInt16: return "uint16";
        case SampleType::Int32: return "int32";
        case SampleType::UInt32: return "uint32";
        case SampleType::Int64: return "int64";
        case SampleType::UInt64: return "uint64";
        case SampleType::Float: return "float32";
        case SampleType::Double: return "float64";
    }
    return "";
}

std::optional<std::uint64_t> bytes_of(const GridSize& size, SampleType type) {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    std::uint64_t bytes = size_of(type);
    for (const std::uint64_t samples : size) {
        if (samples != 0 && bytes > most / samples) return std::nullopt;
        bytes *= samples;
    }
    return bytes;
}

}  // namespace zeroset
