#pragma once

#include <algorithm>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace zeroset::jit {

/// A cache of the most recently used results, each under a text that names it. Thread-safe.
template <class Made>
class KernelCache {
public:
    explicit KernelCache(std::size_t capacity) : capacity_(capacity) {}

    /// The result under this key, or nullptr.
    std::shared_ptr<const Made> find(std::string_view key) {
        const std::scoped_lock lock(mutex_);
        const auto found = std::ranges::find(entries_, key, &Entry::key);
        if (found == entries_.end()) return nullptr;
        entries_.splice(entries_.begin(), entries_, found);
        return found->made;
    }
    void insert(std::string key, std::shared_ptr<const Made> made) {
        const std::scoped_lock lock(mutex_);
        entries_.push_front({std::move(key), std::move(made)});
        if (entries_.size() > capacity_) entries_.pop_back();
    }
    void clear() {
        const std::scoped_lock lock(mutex_);
        entries_.clear();
    }

private:
    struct Entry {
        std::string key;
        std::shared_ptr<const Made> made;
    };

    std::size_t capacity_;
    std::mutex mutex_;
    std::list<Entry> entries_;  ///< most recently used first
};

}  // namespace zeroset::jit
