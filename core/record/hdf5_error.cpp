// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/hdf5_error.hpp"

#include <fmt/format.h>

#include "record/atomic_file.hpp"

namespace flowslide::hdf5 {
namespace {

extern "C" herr_t append_description(unsigned depth, const H5E_error2_t* error, void* text) {
  // The two innermost entries describe the error. The entries above repeat it for each caller.
  if (depth > 1 || error->desc == nullptr) return 0;
  auto& message = *static_cast<std::string*>(text);
  if (!message.empty()) message += ", ";
  message += error->desc;
  return 0;
}

}  // namespace

void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

std::string last_error() {
  std::string message;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, append_description, &message);
  H5Eclear2(H5E_DEFAULT);
  return message.empty() ? "no further reason" : message;
}

hid_t check_written(hid_t id, std::string_view object, std::string_view action) {
  if (id < 0) throw FileError(fmt::format("{}: cannot {}: {}", object, action, last_error()));
  return id;
}

hid_t check_read(hid_t id, std::string_view object, std::string_view action) {
  if (id < 0) throw CorruptFileError(fmt::format("{}: cannot {}: {}", object, action, last_error()));
  return id;
}

}  // namespace flowslide::hdf5
