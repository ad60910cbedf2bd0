#include "engine/interpret/interpret_code.hpp"

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

class Buffer {
public:
    Buffer() = default;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    Buffer(Buffer&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    Buffer& operator=(Buffer&&) = delete;
    ~Buffer() { release(); }

    void* with(std::size_t bytes) {
        if (bytes > size_) {
            release();
            size_ = std::max(bytes, 2 * size_);
            data_ = ::operator new(size_, std::align_val_t(Scratch::alignment));
        }
        return data_;
    }

private:
    void release() {
        ::operator delete(data_, std::align_val_t(Scratch::alignment));
        data_ = nullptr;
    }

    void* data_ = nullptr;
    std::size_t size_ = 0;
};

struct Buffers {
    std::vector<Buffer> buffers;
    std::size_t in_use = 0;
};

Buffers& buffers_of_thread() {
    thread_local Buffers buffers;
    return buffers;
}

}  // namespace

Scratch::Scratch(std::size_t bytes) {
    auto& [buffers, in_use] = buffers_of_thread();
    if (buffers.size() <= in_use) buffers.emplace_back();
    data_ = buffers[in_use].with(bytes);
    ++in_use;
}

Scratch::~Scratch() { --buffers_of_thread().in_use; }

}  // namespace zeroset
