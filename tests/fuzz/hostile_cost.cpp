// Counts allocations by replacing the global operators new and delete; the fuzzer is a program of its own, so
// no test is affected.
#include "fuzz/hostile_cost.h"

#include <malloc.h>
#include <time.h>

#include <atomic>
#include <bit>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> held{0};
std::atomic<std::size_t> peak{0};

}  // namespace

#ifndef VOROGEO_SMALL_TESTS
namespace {

void* counted_allocation(std::size_t size, std::size_t alignment) {
  void* memory = alignment == 0
                     ? std::malloc(size == 0 ? 1 : size)
                     : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t now = held += malloc_usable_size(memory);
  std::size_t most = peak;
  while (now > most && !peak.compare_exchange_weak(most, now)) {
  }
  return memory;
}

void counted_release(void* memory) noexcept {
  if (memory == nullptr) return;
  held -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted_allocation(size, 0); }
void* operator new[](std::size_t size) { return counted_allocation(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted_allocation(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return counted_allocation(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { counted_release(memory); }
void operator delete[](void* memory) noexcept { counted_release(memory); }
void operator delete(void* memory, std::size_t) noexcept { counted_release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { counted_release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { counted_release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { counted_release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { counted_release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { counted_release(memory); }
#endif

namespace vorogeo::test {

bool counts_memory() {
#ifdef VOROGEO_SMALL_TESTS
  return false;
#else
  return true;
#endif
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::size_t held_bytes() { return held; }
std::size_t peak_bytes() { return peak; }
void reset_peak_bytes() { peak = held.load(); }

Cost cost_of(const std::function<void()>& run) {
  reset_peak_bytes();
  const std::size_t before = held_bytes();
  const double start = processor_seconds();
  run();
  return {processor_seconds() - start, static_cast<double>(peak_bytes() - before)};
}

const Costs& ScanCosts::of(std::size_t vertices, Index patches, const IndexOptions& options) {
  const std::size_t size = std::bit_ceil(std::max<std::size_t>(vertices, 32));
  const Measured& chosen = measured(size, options);
  if (patches <= 1 || chosen.patches > 1) return chosen.costs;
  IndexOptions two = options;
  two.first_layer_patches = 1;
  two.second_layer_patches = 2;
  return measured(size, two).costs;
}

const Measured& ScanCosts::measured(std::size_t size, const IndexOptions& options) {
  const std::array<int, 4> key{static_cast<int>(size), options.first_layer_patches,
                               options.second_layer_patches, options.delta > 0.0 ? 1 : 0};
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  HostileRandom random(size);
  // A large scan is a torus of whole rows, with up to an eighth fewer vertices than asked for.
  const HostileMesh scan = hostile_base(HostileBase::scan, static_cast<int>(size + size / 8), random);
  return known_[key] = measure_(scan, options);
}

}  // namespace vorogeo::test
