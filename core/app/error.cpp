// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/error.hpp"

#include <cstdio>
#include <filesystem>

#include "record/atomic_file.hpp"

namespace flowslide {
namespace {

int end_with(ExitCode code, const char* message, int rank) {
  if (code == ExitCode::numerical_failure && rank > 0) {
    std::fprintf(stderr, "flowslide: rank %d: %s\n", rank, message);
  } else if (rank == 0) {
    std::fprintf(stderr, "flowslide: %s\n", message);
  }
  std::fflush(stderr);
  return to_int(code);
}

}  // namespace

int run_main(const std::function<int()>& body, int rank) noexcept {
  std::fflush(stdout);
  try {
    return body();
  } catch (const FinishedEarly& finished) {
    if (rank == 0) std::fputs(finished.what(), stdout);
    std::fflush(stdout);
    return to_int(ExitCode::ok);
  } catch (const Stopped& stopped) {
    return end_with(stopped.code(), stopped.what(), rank);
  } catch (const ConfigurationError& error) {
    return end_with(ExitCode::configuration, error.what(), rank);
  } catch (const FileError& error) {
    return end_with(ExitCode::configuration, error.what(), rank);
  } catch (const std::filesystem::filesystem_error& error) {
    return end_with(ExitCode::configuration, error.what(), rank);
  } catch (const std::invalid_argument& error) {
    return end_with(ExitCode::configuration, error.what(), rank);
  } catch (const std::domain_error& error) {
    return end_with(ExitCode::configuration, error.what(), rank);
  } catch (const std::bad_alloc&) {
    return end_with(ExitCode::numerical_failure, "out of memory: use fewer grains or a larger machine", rank);
  } catch (const std::exception& error) {
    return end_with(ExitCode::numerical_failure, error.what(), rank);
  } catch (...) {
    return end_with(ExitCode::numerical_failure, "stopped by an exception of unknown type (a defect: report it)", rank);
  }
}

}  // namespace flowslide
