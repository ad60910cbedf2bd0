#pragma once

#include "engine/kernel/kernel.hpp"

#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace zeroset {

/// The parts of a solid (Kernel::memory): functions, or their negatives, of which f is a tree of
/// min and max, so that f is 0 only where one of them is. Their code is made when it is first asked
/// for. Any thread.
class CsgParts {
public:
    using Make = std::function<std::vector<Kernel>()>;

    /// Tells how their code is made, before anyone asks for it. Nothing new where that is known.
    void set(Make make) {
        const std::scoped_lock lock(mutex_);
        if (is_set_) return;
        is_set_ = true;
        make_ = std::move(make);
    }
    /// None where f is not known as such a tree.
    [[nodiscard]] const std::vector<Kernel>& kernels() {
        const std::scoped_lock lock(mutex_);
        if (make_) kernels_ = std::exchange(make_, nullptr)();
        return kernels_;
    }

private:
    std::mutex mutex_;
    bool is_set_ = false;
    Make make_;
    std::vector<Kernel> kernels_;
};

}  // namespace zeroset
