#include "engine/interpret/interpret_code.hpp"

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

class Room {
public:
    Room() = default;
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    Room(Room&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    Room& operator=(Room&&) = delete;
    ~Room() { release(); }

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

struct Rooms {
    std::vector<Room> rooms;
    std::size_t in_use = 0;
};

Rooms& rooms_of_thread() {
    thread_local Rooms rooms;
    return rooms;
}

}  // namespace

Scratch::Scratch(std::size_t bytes) {
    auto& [rooms, in_use] = rooms_of_thread();
    if (rooms.size() <= in_use) rooms.emplace_back();
    data_ = rooms[in_use].with(bytes);
    ++in_use;
}

Scratch::~Scratch() { --rooms_of_thread().in_use; }

}  // namespace zeroset
