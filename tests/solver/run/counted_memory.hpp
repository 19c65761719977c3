#pragma once

#include <cstdlib>
#include <new>

// Counts the heap allocations of a test. Its operators replace those of the whole program: include it in one file only.

inline long taken = 0;               ///< number of allocations
inline std::size_t taken_bytes = 0;  ///< their total size

[[gnu::noinline]] inline void* take(std::size_t size) {
  ++taken;
  taken_bytes += size;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc{};
}

// Not inline, as take(): a compiler that sees one of the two in place of the other finds them mismatched.
[[gnu::noinline]] inline void give_back(void* memory) noexcept { std::free(memory); }

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
// Also the non-throwing ones: the address sanitizer replaces them, and std::free must not free its memory.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++taken;
  taken_bytes += size;
  return std::malloc(size);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept { return ::operator new(size, tag); }
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { give_back(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory); }
