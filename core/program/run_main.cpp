// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/run_main.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>
#include <system_error>

#include "configuration/error.hpp"
#include "dem/make_engine.hpp"
#include "record/atomic_file.hpp"
#include "sample/failure.hpp"

namespace flowslide {
namespace {

const char* message_of(const std::exception_ptr& failure) noexcept {
  try {
    std::rethrow_exception(failure);
  } catch (const std::bad_alloc&) {
    return "out of memory: use fewer grains or a larger machine";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception of unknown type";
  }
}

void say(ExitCode code, const char* message, int rank, std::string* unsaid) {
  const bool defect = code == ExitCode::defect;
  if (rank > 0 && !defect && code != ExitCode::numerical_failure) {
    if (unsaid) *unsaid = message;
    return;
  }
  std::fputs("flowslide: ", stderr);
  if (rank > 0) std::fprintf(stderr, "rank %d: ", rank);
  if (defect) std::fputs("this is a defect of the program, not of your input: ", stderr);
  std::fputs(message, stderr);
  if (defect)
    std::fputs("; please report it with the whole command, its configuration files and what --version prints", stderr);
  std::fputs("\n", stderr);
  std::fflush(stderr);
}

/// `code`, or 1 if `code` is 0 or 4 and standard output could not be written completely.
int with_output_written(int code, int rank) {
  if (code != to_int(ExitCode::ok) && code != to_int(ExitCode::claim_not_met)) return code;
  errno = 0;
  std::cout.flush();
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && !std::cout.fail();
  if (written || rank > 0) return code;
  if (errno ==
      0) {  // An earlier write failed. Another one fails for the same reason, and the output is incomplete anyway.
    std::clearerr(stdout);
    if (std::fputc('\n', stdout) != EOF) std::fflush(stdout);
  }
  const char* reason = errno != 0 ? std::strerror(errno) : "writing failed";
  std::fprintf(stderr, "flowslide: standard output cannot be written: %s; what was printed is not complete\n", reason);
  std::fflush(stderr);
  return to_int(ExitCode::output);
}

}  // namespace

ExitCode code_of(const std::exception_ptr& failure) noexcept {
  try {
    std::rethrow_exception(failure);
  } catch (const Stopped& stopped) {
    return stopped.code();
  } catch (const ConfigurationError&) {
    return ExitCode::configuration;
  } catch (const Refused&) {
    return ExitCode::configuration;
  } catch (const FileError&) {
    return ExitCode::configuration;
  } catch (const MissingEngine&) {
    return ExitCode::configuration;
  } catch (const std::system_error&) {
    return ExitCode::configuration;
  } catch (const NumericalFailure&) {
    return ExitCode::numerical_failure;
  } catch (const EngineError&) {
    return ExitCode::numerical_failure;
  } catch (const std::bad_alloc&) {
    return ExitCode::numerical_failure;
  } catch (...) {
    return ExitCode::defect;
  }
}

int run_main(const std::function<int()>& body, int rank, std::string* unsaid) noexcept {
  std::fflush(stdout);
  try {
    return with_output_written(body(), rank);
  } catch (const FinishedEarly& finished) {
    if (rank == 0) std::fputs(finished.what(), stdout);
    return with_output_written(to_int(ExitCode::ok), rank);
  } catch (const FirstRankFailed&) {
    return to_int(code_of(std::current_exception()));
  } catch (...) {
    const std::exception_ptr failure = std::current_exception();
    const ExitCode code = code_of(failure);
    say(code, message_of(failure), rank, unsaid);
    return to_int(code);
  }
}

}  // namespace flowslide
