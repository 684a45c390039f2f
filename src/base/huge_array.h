// An array for random access. Its memory is requested in huge pages, which avoids most TLB misses. All bytes are zero
// at first, so zero bytes must be a valid T.
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>

namespace drc {

// Zeroed memory in whole pages; throws std::bad_alloc. bytes > 0.
void* allocatePages(size_t bytes);
void freePages(void* memory, size_t bytes);

template <class T>
class HugeArray {
    static_assert(std::is_trivially_destructible_v<T>);

  public:
    HugeArray() = default;
    explicit HugeArray(size_t size) : data_(static_cast<T*>(allocatePages(size * sizeof(T)))), size_(size) {}
    HugeArray(HugeArray&& other) noexcept { swap(other); }
    HugeArray& operator=(HugeArray&& other) noexcept {
        swap(other);
        return *this;
    }
    ~HugeArray() {
        if (data_) freePages(data_, size_ * sizeof(T));
    }

    size_t size() const { return size_; }
    T& operator[](size_t i) { return data_[i]; }
    const T& operator[](size_t i) const { return data_[i]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }

  private:
    void swap(HugeArray& other) {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
    }
    T* data_ = nullptr;
    size_t size_ = 0;
};

}  // namespace drc
