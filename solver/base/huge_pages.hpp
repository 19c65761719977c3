#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace talus {

/// Allocator for long arrays that are traversed repeatedly. Large arrays use pages of 2 MiB where the system provides
/// them, which reduces page look-ups; small ones are aligned to cache lines.
template <class T>
struct HugePages {
  using value_type = T;

  HugePages() = default;
  template <class Other>
  constexpr HugePages(const HugePages<Other>&) {}

  T* allocate(std::size_t count) {
    const std::size_t page = count * sizeof(T) < large ? line : large;
    const std::size_t bytes = (count * sizeof(T) + page - 1) / page * page;
    void* const memory = std::aligned_alloc(page, bytes);
    if (memory == nullptr) throw std::bad_alloc{};
#if defined(__linux__)
    if (page == large) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));  // the system may ignore it
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  friend constexpr bool operator==(HugePages, HugePages) = default;

 private:
  static constexpr std::size_t line = 64, large = std::size_t{2} << 20;
};

}  // namespace talus
