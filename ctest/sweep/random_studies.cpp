// SPDX-License-Identifier: GPL-2.0-or-later
// random_studies BUILD_FOLDER SOURCE_FOLDER COUNT SEED [WORKERS]: random studies of every case on closed-form samples,
// and of the case `study` with sweeps, schemes and replicates on every engine of the build. Each is run,
// repeated, changed, collected and drawn. A crash, a wrong exit code, a missing file or a result that is not that of
// its configuration is a failure. Prints "N passed, N failed"; exit code 1 if a study failed.
#include <fmt/format.h>
#include <stdlib.h>

#include <atomic>
#include <iostream>
#include <mutex>
#include <thread>

#include "sweep/study.hpp"

namespace fs = std::filesystem;

namespace flowslide {
namespace {

int run_studies(const std::vector<CaseUnderTest>& cases, const fs::path& room, int count, std::uint64_t seed,
                int workers) {
  std::atomic<int> next = 0, failed = 0;
  std::mutex printing;
  const auto work = [&] {
    for (int number = next++; number < count; number = next++) {
      Dice dice(seed * 1'000'003 + static_cast<std::uint64_t>(number));
      const fs::path own = room / std::to_string(number);
      const CaseUnderTest& of = dice.one_of(cases);
      const StudyOutcome outcome = check_study(of, dice, own);
      if (!outcome.failure.empty()) {
        ++failed;
        const std::lock_guard lock(printing);
        std::cout << fmt::format("study {}: {}\n  {}\n", number, outcome.command, outcome.failure) << std::flush;
      }
      fs::remove_all(own);
    }
  };
  std::vector<std::jthread> threads;
  for (int worker = 0; worker < workers; ++worker) threads.emplace_back(work);
  threads.clear();
  std::cout << fmt::format("{} passed, {} failed\n", count - failed, failed.load());
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace flowslide

int main(int argc, char** argv) {
  using namespace flowslide;
  if (argc < 5) {
    std::cerr << "Usage: random_studies BUILD_FOLDER SOURCE_FOLDER COUNT SEED [WORKERS]\n";
    return 2;
  }
  std::string name = (fs::temp_directory_path() / "studies.XXXXXX").string();
  const fs::path room = ::mkdtemp(name.data());
  ::setenv("FLOWSLIDE_CACHE", (room / "cache").c_str(), 1);
  std::vector<CaseUnderTest> cases;
  for (const char* of : {"fig06_convergence", "fig08_trigger", "fig12_pulse", "fig13_k", "fig14_e0", "speed_error",
                         "open_questions", "study"})
    cases.push_back(case_in(of, argv[1], argv[2], room));
  const int code =
      run_studies(cases, room, std::stoi(argv[3]), std::stoull(argv[4]), argc > 5 ? std::stoi(argv[5]) : 1);
  fs::remove_all(room);
  return code;
}
