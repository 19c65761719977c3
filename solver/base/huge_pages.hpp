#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace talus {

/// Archive for long arrays that are gone through again and again: large ones in pages of 2 MiB, where the system has
/// them, so that it looks up fewer; small ones at the start of a line of the cache.
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
    if (page == large) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));  // advice: may be left aside
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  friend constexpr bool operator==(HugePages, HugePages) = default;

 private:
  static constexpr std::size_t line = 64, large = std::size_t{2} << 20;
};

}  // namespace talus
