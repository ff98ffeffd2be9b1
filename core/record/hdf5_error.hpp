// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <hdf5.h>

#include <string>
#include <string_view>

namespace flowslide::hdf5 {

/// Stops HDF5 from printing its errors, which are thrown instead.
void silence();

/// HDF5's messages about the last failed call, innermost first. Clears them.
std::string last_error();

/// Both return `id`, a result of HDF5. If `id` is negative, they throw FileError and CorruptFileError, respectively.
hid_t check_written(hid_t id, std::string_view object, std::string_view action);
hid_t check_read(hid_t id, std::string_view object, std::string_view action);

}  // namespace flowslide::hdf5
