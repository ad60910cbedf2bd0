#pragma once

#include <glm/glm.hpp>

#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <vector>

namespace zeroset {

static_assert(std::endian::native == std::endian::little);

/// Bytes that grow, numbers in little endian.
class ByteWriter {
public:
    explicit ByteWriter(std::size_t expected = 0) { bytes_.reserve(expected); }

    template <class Number>
    void put(Number value) {
        const auto* const from = reinterpret_cast<const std::byte*>(&value);
        bytes_.insert(bytes_.end(), from, from + sizeof(Number));
    }
    void put_floats(const glm::dvec3& vector) {
        for (int axis = 0; axis < 3; ++axis)
            put(static_cast<float>(vector[axis]));
    }
    void put_text(std::string_view text) {
        const auto* const from = reinterpret_cast<const std::byte*>(text.data());
        bytes_.insert(bytes_.end(), from, from + text.size());
    }
    void pad_to(std::size_t size, std::byte with) { bytes_.resize(size, with); }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

}  // namespace zeroset
