// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace flowslide::native {

/// Threads that run one function together. The caller is the first of them. The others exist as long as the team.
class ThreadTeam {
 public:
  /// Throws EngineError if the system cannot start `size` threads.
  explicit ThreadTeam(int size);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return size_; }
  /// Calls `task(number)` on each thread, with numbers 0 to size - 1, and returns when all are done. The task must not
  /// throw.
  void run(const std::function<void(int)>& task);
  /// Within a task: waits for all threads. After a while it yields the core, which other threads may need on a busy
  /// machine.
  void barrier();

 private:
  void run_tasks(int number);
  void join_threads();

  int size_;
  std::atomic<int> arrived_{0};
  std::atomic<unsigned> phase_{0};  ///< number of barriers passed
  std::atomic<unsigned> call_{0};   ///< number of tasks started
  const std::function<void(int)>* task_ = nullptr;
  std::vector<std::thread> threads_;
};

}  // namespace flowslide::native
