#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Numbers 0, 1, 2, ... for keys in the order of their coming.
class KeyIndex {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    explicit KeyIndex(std::size_t expected) {
        std::size_t size = 64;
        while (size < 2 * expected)
            size *= 2;
        slots_.assign(size, none);
    }
    /// The key's number, a new one where it has none.
    std::uint32_t add(std::uint64_t key) {
        if (2 * (keys_.size() + 1) > slots_.size()) grow();
        std::uint32_t& slot = slots_[slot_of(key)];
        if (slot == none) {
            slot = static_cast<std::uint32_t>(keys_.size());
            keys_.push_back(key);
        }
        return slot;
    }
    /// The key's number, or `none`.
    [[nodiscard]] std::uint32_t find(std::uint64_t key) const { return slots_[slot_of(key)]; }
    [[nodiscard]] const std::vector<std::uint64_t>& keys() const { return keys_; }

private:
    [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
        constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;
        std::uint64_t mixed = key * golden;
        mixed ^= mixed >> 29U;
        mixed *= golden;
        std::size_t i = (mixed ^ mixed >> 32U) & (slots_.size() - 1);
        while (slots_[i] != none && keys_[slots_[i]] != key)
            i = (i + 1) & (slots_.size() - 1);
        return i;
    }
    void grow() {
        slots_.assign(2 * slots_.size(), none);
        for (std::uint32_t i = 0; i < keys_.size(); ++i)
            slots_[slot_of(keys_[i])] = i;
    }

    std::vector<std::uint32_t> slots_;
    std::vector<std::uint64_t> keys_;
};

/// A key of two numbers in this order.
constexpr std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{a} << 32U | b;
}

/// Numbers 0, 1, 2, ... for pairs in the order of their coming, quick where few have the same
/// first.
class PairIndex {
public:
    /// `firsts`: all first numbers are below.
    explicit PairIndex(std::size_t firsts) : last_(firsts, KeyIndex::none) {}

    std::uint32_t add(std::uint32_t a, std::uint32_t b) {
        for (std::uint32_t i = last_[a]; i != KeyIndex::none; i = before_[i]) {
            if (static_cast<std::uint32_t>(keys_[i]) == b) return i;
        }
        before_.push_back(last_[a]);
        keys_.push_back(pair_key(a, b));
        return last_[a] = static_cast<std::uint32_t>(keys_.size() - 1);
    }
    [[nodiscard]] const std::vector<std::uint64_t>& keys() const { return keys_; }

private:
    std::vector<std::uint32_t> last_;    ///< of each first number
    std::vector<std::uint32_t> before_;  ///< the pair before with the same first
    std::vector<std::uint64_t> keys_;
};

}  // namespace zeroset
