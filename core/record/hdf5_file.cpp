// SPDX-License-Identifier: GPL-2.0-or-later
// Files of hdf5.hpp: HDF5's "core" driver without a backing store.
#include <fmt/format.h>

#include <atomic>

#include "record/hdf5.hpp"
#include "record/hdf5_error.hpp"

namespace flowslide::hdf5 {
namespace {

constexpr std::size_t growth = std::size_t{1} << 20;  // bytes by which a file in memory grows

Handle memory_driver(const std::string& path) {
  silence();
  Handle access(check_written(H5Pcreate(H5P_FILE_ACCESS), path, "create properties"), H5Pclose);
  check_written(H5Pset_fapl_core(access, growth, false), path, "choose the memory driver");
  return access;
}

/// A new name for each file: HDF5 confuses two open files in memory that have the same name.
std::string unique_name() {
  static std::atomic<std::uint64_t> count{0};
  return fmt::format("flowslide memory file {}", count++);
}

}  // namespace

File::File(Handle handle, const std::string& path)
    : handle_(std::move(handle)), path_(path),
      root_(Handle(check_read(H5Gopen2(handle_, "/", H5P_DEFAULT), path, "open the root group"), H5Gclose),
            path + ":") {}

File File::create(const std::string& path) {
  const Handle access = memory_driver(path);
  const Handle properties(check_written(H5Pcreate(H5P_FILE_CREATE), path, "create properties"), H5Pclose);
  H5Pset_obj_track_times(properties, 0);
  H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const hid_t id = H5Fcreate(unique_name().c_str(), H5F_ACC_TRUNC, properties, access);
  return {Handle(check_written(id, path, "create the file"), H5Fclose), path};
}

File File::open(std::string_view image, const std::string& path) {
  if (image.empty()) throw CorruptFileError(path + ": the file is empty");
  const Handle access = memory_driver(path);
  // HDF5 copies the image and does not change it, but its interface lacks the const.
  check_read(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()), path, "take its bytes");
  const hid_t id = H5Fopen(unique_name().c_str(), H5F_ACC_RDONLY, access);
  return {Handle(check_read(id, path, "open it as HDF5"), H5Fclose), path};
}

std::string File::image() const {
  check_written(H5Fflush(handle_, H5F_SCOPE_GLOBAL), path_, "complete the file");
  const auto size = check_written(H5Fget_file_image(handle_, nullptr, 0), path_, "measure the file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  check_written(H5Fget_file_image(handle_, bytes.data(), bytes.size()), path_, "copy the file");
  return bytes;
}

}  // namespace flowslide::hdf5
