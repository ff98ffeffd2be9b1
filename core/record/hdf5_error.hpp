// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <hdf5.h>

#include <string>
#include <string_view>

namespace flowslide::hdf5 {

/// Stops HDF5 from printing its errors: they are thrown instead.
void silence();

/// What HDF5 says about the last failed call, innermost first; forgets it.
std::string last_error();

/// Return `id`, a result of HDF5; throw FileError or CorruptFileError if it is negative.
hid_t check_written(hid_t id, std::string_view object, std::string_view action);
hid_t check_read(hid_t id, std::string_view object, std::string_view action);

}  // namespace flowslide::hdf5
