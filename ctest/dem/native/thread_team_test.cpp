// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/thread_team.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <set>
#include <string>

#include "dem/engine.hpp"

namespace flowslide::native {
namespace {

/// From one to more than there are cores, but never many.
std::vector<int> sizes() {
  return {1, 2, 3, 4, std::clamp(2 * static_cast<int>(std::thread::hardware_concurrency()) + 1, 5, 9)};
}

TEST(ThreadTeam, CallsTheTaskOnceOnEachThread) {
  for (const int size : sizes()) {
    ThreadTeam team(size);
    EXPECT_EQ(team.size(), size);
    std::vector<int> calls(static_cast<std::size_t>(size), 0);
    std::vector<std::thread::id> threads(static_cast<std::size_t>(size));
    team.run([&](int number) {
      ++calls[static_cast<std::size_t>(number)];
      threads[static_cast<std::size_t>(number)] = std::this_thread::get_id();
    });
    EXPECT_EQ(calls, std::vector<int>(static_cast<std::size_t>(size), 1));
    EXPECT_EQ(threads[0], std::this_thread::get_id());
    EXPECT_EQ(std::set(threads.begin(), threads.end()).size(), static_cast<std::size_t>(size));
  }
}

TEST(ThreadTeam, ReturnsWhenAllAreDoneHoweverOften) {
  for (const int size : sizes()) {
    ThreadTeam team(size);
    const int runs = size <= 2 ? 20000 : 2000;  // threads that share a core take turns
    std::vector<int> done(static_cast<std::size_t>(size), 0);
    for (int run = 1; run <= runs; ++run) {
      const int increment = run % 3;  // each task is another
      team.run([&done, increment](int number) { done[static_cast<std::size_t>(number)] += increment; });
      if (run % 500 == 0) {
        ASSERT_EQ(std::set(done.begin(), done.end()).size(), 1u) << size << " threads, run " << run;
      }
    }
    EXPECT_EQ(done.back(), runs / 3 * 3 + (runs % 3 == 2 ? 3 : runs % 3));
  }
}

TEST(ThreadTeam, ABarrierWaitsForAll) {
  for (const int size : sizes()) {
    ThreadTeam team(size);
    const auto n = static_cast<std::size_t>(size);
    const int steps = size <= 2 ? 50000 : 3000;
    // Like the engine: two buffers that alternate, with one barrier between writing and reading.
    std::array<std::vector<long>, 2> published{std::vector<long>(n), std::vector<long>(n)};
    std::vector<int> wrong(n, 0);
    team.run([&](int number) {
      const auto own = static_cast<std::size_t>(number);
      for (int step = 0; step < steps; ++step) {
        std::vector<long>& now = published[static_cast<std::size_t>(step % 2)];
        now[own] = step * (number + 1L);
        team.barrier();
        wrong[own] += std::accumulate(now.begin(), now.end(), 0L) != step * (size * (size + 1L) / 2);
      }
    });
    EXPECT_EQ(wrong, std::vector<int>(n, 0)) << size << " threads";
  }
}

TEST(ThreadTeam, WakesAfterAPause) {
  ThreadTeam team(3);
  std::atomic<int> calls{0};
  for (int run = 0; run < 5; ++run) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // longer than a thread spins for a task
    team.run([&](int) { ++calls; });
  }
  EXPECT_EQ(calls, 15);
}

TEST(ThreadTeam, WaitsForTheSlowestAtABarrier) {
  ThreadTeam team(3);
  std::atomic<bool> late{false};
  std::array<bool, 3> seen{};
  team.run([&](int number) {
    if (number == 2) {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));  // simulates other load on the machine
      late = true;
    }
    team.barrier();
    seen[static_cast<std::size_t>(number)] = late;
  });
  EXPECT_EQ(seen, (std::array{true, true, true}));
}

TEST(ThreadTeam, CanBeSentHomeWithoutATaskAndBesideAnother) {
  for (int i = 0; i < 50; ++i) {
    ThreadTeam idle(4), busy(2), other(3);
    std::atomic<int> calls{0};
    busy.run([&](int) {
      busy.barrier();
      ++calls;
    });
    other.run([&](int) { ++calls; });
    ASSERT_EQ(calls, 5);
  }
}

/// Ends the process with 0 if a team that is too large is refused in words.
[[noreturn]] void ask_for_too_many_threads() {
  std::ifstream sizes("/proc/self/statm");
  rlim_t pages = 0;
  sizes >> pages;
  const rlim_t room = 64U << 20U, now = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));  // of stacks of 8 MB
  const rlimit limit{now + room, now + room};
  if (::setrlimit(RLIMIT_AS, &limit) != 0) std::_Exit(2);
  try {
    const ThreadTeam team(500);
  } catch (const EngineError& error) {
    std::_Exit(std::string(error.what()).find("cannot start 500 threads") == std::string::npos);
  }
  std::_Exit(3);
}

TEST(ThreadTeamDeathTest, RefusesMoreThreadsThanThereCanBe) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more memory than the test leaves";
#endif
  EXPECT_EXIT(ask_for_too_many_threads(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace flowslide::native
