#pragma once

#include <cstdlib>
#include <new>

// Counts what a test takes from the heap. Its operators replace those of the whole program: for one file of it.

inline long taken = 0;               ///< pieces of memory
inline std::size_t taken_bytes = 0;  ///< their sizes together

[[gnu::noinline]] inline void* take(std::size_t size) {
  ++taken;
  taken_bytes += size;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc{};
}

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
// Also those that may fail: the address sanitizer has its own, whose memory must not be freed by std::free.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++taken;
  taken_bytes += size;
  return std::malloc(size);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept { return ::operator new(size, tag); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
