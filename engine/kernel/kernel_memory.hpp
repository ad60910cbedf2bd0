#pragma once

#include <memory>
#include <mutex>
#include <typeindex>
#include <utility>
#include <vector>

namespace zeroset {

/// Things that tracers have found out of a kernel's function and keep for later frames: one of each
/// type, empty when it is first asked for. Copies of a kernel share it, so it goes with the
/// last one. Any thread; the things look after their own threads.
class KernelMemory {
public:
    template <class Thing>
    std::shared_ptr<Thing> of() {
        const std::scoped_lock lock(mutex_);
        for (const auto& [type, thing] : things_) {
            if (type == typeid(Thing)) return std::static_pointer_cast<Thing>(thing);
        }
        auto thing = std::make_shared<Thing>();
        things_.emplace_back(typeid(Thing), thing);
        return thing;
    }

private:
    std::mutex mutex_;
    std::vector<std::pair<std::type_index, std::shared_ptr<void>>> things_;
};

}  // namespace zeroset
