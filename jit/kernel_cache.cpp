#include "jit/kernel_cache.hpp"

#include <algorithm>

namespace zeroset::jit {

std::shared_ptr<const MachineCode> KernelCache::find(std::string_view key) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return found->code;
}

void KernelCache::insert(std::string key, std::shared_ptr<const MachineCode> code) {
    const std::scoped_lock lock(mutex_);
    entries_.push_front({std::move(key), std::move(code)});
    if (entries_.size() > capacity_) entries_.pop_back();
}

}  // namespace zeroset::jit
