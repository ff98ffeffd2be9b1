// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/thread_team.hpp"

#include <fmt/format.h>

#include <system_error>

#include "dem/engine.hpp"

namespace flowslide::native {
namespace {

/// Number of checks of a barrier before a thread yields its core: some microseconds, less than a step.
constexpr int spins_before_yield = 200;
/// Number of yields before a thread without a task sleeps. While a sample is sheared, the next task follows soon.
constexpr int yields_before_sleep = 200;

/// Leaves the units of a core to its other hardware thread for a moment. A thread that spins without this slows down
/// the thread that it waits for, where both share a core.
inline void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace

ThreadTeam::ThreadTeam(int size) : size_(size) {
  try {
    for (int number = 1; number < size; ++number) threads_.emplace_back([this, number] { run_tasks(number); });
  } catch (const std::system_error& error) {
    join_threads();
    throw EngineError(
        fmt::format("the native engine cannot start {} threads: {}; let it use fewer", size, error.what()));
  }
}

ThreadTeam::~ThreadTeam() { join_threads(); }

void ThreadTeam::join_threads() {
  task_ = nullptr;
  call_.fetch_add(1, std::memory_order_release);
  call_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadTeam::run_tasks(int number) {
  for (unsigned call = 0;; ++call) {
    for (int yields = 0; call_.load(std::memory_order_acquire) == call; ++yields)
      if (yields < yields_before_sleep)
        std::this_thread::yield();
      else
        call_.wait(call, std::memory_order_acquire);
    if (!task_) return;
    (*task_)(number);
    barrier();
  }
}

void ThreadTeam::run(const std::function<void(int)>& task) {
  if (size_ > 1) {
    task_ = &task;
    call_.fetch_add(1, std::memory_order_release);
    call_.notify_all();
  }
  task(0);
  barrier();
}

void ThreadTeam::barrier() {
  if (size_ == 1) return;
  const unsigned phase = phase_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == size_) {
    arrived_.store(0, std::memory_order_relaxed);
    phase_.fetch_add(1, std::memory_order_release);
    return;
  }
  for (int spins = 0; phase_.load(std::memory_order_acquire) == phase; ++spins) {
    pause();
    if (spins >= spins_before_yield) std::this_thread::yield();
  }
}

}  // namespace flowslide::native
