// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace flowslide::native {

/// Threads that run one function together, the caller as the first of them. They live as long as the team.
class ThreadTeam {
 public:
  /// Throws EngineError if the system gives no such number of threads.
  explicit ThreadTeam(int size);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return size_; }
  /// Calls `task(number)` on each thread, numbers 0 to size - 1, and returns when all are done. The task throws nothing.
  void run(const std::function<void(int)>& task);
  /// Within a task: waits for all. Gives the core away when it takes long, as on a busy machine the others may need it.
  void barrier();

 private:
  void serve(int number);
  void send_home();

  int size_;
  std::atomic<int> arrived_{0};
  std::atomic<unsigned> phase_{0};  ///< barriers passed
  std::atomic<unsigned> call_{0};   ///< tasks given
  const std::function<void(int)>* task_ = nullptr;
  std::vector<std::thread> threads_;
};

}  // namespace flowslide::native
