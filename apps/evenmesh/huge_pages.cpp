// SPDX-License-Identifier: MIT
//
// Large arrays ask for huge pages. Where Linux gives these on request only, as most distributions
// set it, the first touch of each 4 kB otherwise costs a page fault: a third of the time to read a
// file, more on virtual machines. Programs may link this file; the library does not.
#include <cstddef>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

void* allocate(std::size_t size) {
#ifdef MADV_HUGEPAGE
  // Smaller ones would waste more in their last page than they gain.
  constexpr std::size_t kLarge = 8 * kHugePage;
  if (size >= kLarge && size < ~std::size_t{0} - kHugePage) {
    const std::size_t whole = (size + kHugePage - 1) / kHugePage * kHugePage;
    void* const memory = std::aligned_alloc(kHugePage, whole);
    if (memory != nullptr) ::madvise(memory, whole, MADV_HUGEPAGE);
    return memory;
  }
#endif
  return std::malloc(size == 0 ? 1 : size);
}

}  // namespace

void* operator new(std::size_t size) {
  void* const memory = allocate(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
