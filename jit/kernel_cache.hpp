#pragma once

#include "jit/orc.hpp"

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace zeroset::jit {

/// The machine code made most recently, by graph, lanes, type and function. Thread-safe.
class KernelCache {
public:
    explicit KernelCache(std::size_t capacity) : capacity_(capacity) {}

    /// The code under this key, or nullptr.
    std::shared_ptr<const MachineCode> find(std::string_view key);
    void insert(std::string key, std::shared_ptr<const MachineCode> code);

private:
    struct Entry {
        std::string key;
        std::shared_ptr<const MachineCode> code;
    };

    std::size_t capacity_;
    std::mutex mutex_;
    std::list<Entry> entries_;  ///< newest first
};

}  // namespace zeroset::jit
