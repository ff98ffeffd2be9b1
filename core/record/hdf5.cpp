// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/hdf5.hpp"

#include <fmt/format.h>
#include <hdf5_hl.h>

#include <stdexcept>

#include "record/hdf5_error.hpp"

namespace flowslide::hdf5 {
namespace {

template <typename T>
hid_t file_type();
template <>
hid_t file_type<double>() { return H5T_IEEE_F64LE; }
template <>
hid_t file_type<std::uint32_t>() { return H5T_STD_U32LE; }
template <>
hid_t file_type<std::uint8_t>() { return H5T_STD_U8LE; }

template <typename T>
hid_t memory_type();
template <>
hid_t memory_type<double>() { return H5T_NATIVE_DOUBLE; }
template <>
hid_t memory_type<std::uint32_t>() { return H5T_NATIVE_UINT32; }
template <>
hid_t memory_type<std::uint8_t>() { return H5T_NATIVE_UINT8; }

/// Number of elements; the largest std::uint64_t if it overflows.
std::uint64_t count(const Shape& shape) {
  std::uint64_t product = 1;
  for (const auto extent : shape)
    if (__builtin_mul_overflow(product, extent, &product)) return ~std::uint64_t{0};
  return product;
}

Handle dataspace(const Shape& shape, const std::string& label) {
  const std::vector<hsize_t> extents(shape.begin(), shape.end());
  const hid_t id = extents.empty() ? H5Screate(H5S_SCALAR)
                                   : H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
  return {check_written(id, label, "describe its shape"), H5Sclose};
}

/// Properties without times: equal content then gives equal bytes.
Handle creation_properties(hid_t kind) {
  Handle properties(check_written(H5Pcreate(kind), "HDF5", "create properties"), H5Pclose);
  H5Pset_obj_track_times(properties, 0);
  return properties;
}

/// "(800, 3)"
std::string text(const Shape& shape) {
  std::string list;
  for (const auto extent : shape)
    list += (list.empty() ? "" : ", ") + (extent == Group::any ? std::string("any") : fmt::to_string(extent));
  return "(" + list + ")";
}

bool fits(const Shape& shape, const Shape& expected) {
  if (shape.size() != expected.size()) return false;
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (expected[i] != Group::any && shape[i] != expected[i]) return false;
  return true;
}

}  // namespace

Handle::Handle(Handle&& other) noexcept
    : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(std::exchange(other.close_, nullptr)) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

Handle::~Handle() {
  if (close_ != nullptr && id_ >= 0) close_(id_);
}

Shape Dataset::shape() const {
  const Handle space(check_read(H5Dget_space(handle_), label_, "read its shape"), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  check_read(rank, label_, "read its shape");
  std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
  check_read(H5Sget_simple_extent_dims(space, extents.data(), nullptr), label_, "read its shape");
  return {extents.begin(), extents.end()};
}

void Dataset::make_scale(const std::string& name) {
  check_written(H5DSset_scale(handle_, name.c_str()), label_, "make it a dimension scale");
}

void Dataset::attach_scale(const Dataset& scale) {
  check_written(H5DSattach_scale(handle_, scale.id(), 0), label_, "attach its dimension scale");
}

Group Group::create_group(const std::string& name) {
  const std::string label = label_ + "/" + name;
  const Handle properties = creation_properties(H5P_GROUP_CREATE);
  H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const hid_t id = H5Gcreate2(handle_, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT);
  return {Handle(check_written(id, label, "create the group"), H5Gclose), label};
}

Group Group::group(const std::string& name) const {
  const std::string label = label_ + "/" + name;
  return {Handle(check_read(H5Gopen2(handle_, name.c_str(), H5P_DEFAULT), label, "open the group"), H5Gclose), label};
}

Dataset Group::dataset(const std::string& name) const {
  const std::string label = label_ + "/" + name;
  const hid_t id = H5Dopen2(handle_, name.c_str(), H5P_DEFAULT);
  return {Handle(check_read(id, label, "open the dataset"), H5Dclose), label};
}

bool Group::has(const std::string& name) const { return H5Lexists(handle_, name.c_str(), H5P_DEFAULT) > 0; }

std::vector<std::string> Group::names() const {
  H5G_info_t info{};
  check_read(H5Gget_info(handle_, &info), label_, "list its members");
  std::vector<std::string> names(info.nlinks);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto name_of = [&](char* buffer, std::size_t size) {
      const auto length = H5Lget_name_by_idx(handle_, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, buffer, size,
                                             H5P_DEFAULT);
      return static_cast<std::size_t>(check_read(length, label_, "list its members"));
    };
    names[i].resize(name_of(nullptr, 0));
    name_of(names[i].data(), names[i].size() + 1);
  }
  return names;
}

template <typename T>
Dataset Group::write(const std::string& name, std::span<const T> values, const Shape& shape) {
  const std::string label = label_ + "/" + name;
  if (count(shape) != values.size())
    throw std::invalid_argument(fmt::format("{}: {} values for shape {}", label, values.size(), text(shape)));
  const Handle space = dataspace(shape, label);
  const Handle properties = creation_properties(H5P_DATASET_CREATE);
  const hid_t id = H5Dcreate2(handle_, name.c_str(), file_type<T>(), space, H5P_DEFAULT, properties, H5P_DEFAULT);
  Dataset dataset(Handle(check_written(id, label, "create the dataset"), H5Dclose), label);
  if (!values.empty())
    check_written(H5Dwrite(id, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), label, "write it");
  return dataset;
}

Dataset Group::write(const std::string& name, double value) {
  return write<double>(name, std::span<const double>(&value, 1), {});
}

template <typename T>
std::vector<T> Group::read(const std::string& name, const Shape& expected) const {
  const Dataset array = dataset(name);
  const Shape shape = array.shape();
  if (!fits(shape, expected))
    throw CorruptFileError(fmt::format("{}: shape {} instead of {}", array.label(), text(shape), text(expected)));
  const Handle type(check_read(H5Dget_type(array.id()), array.label(), "read its type"), H5Tclose);
  if (H5Tequal(type, file_type<T>()) <= 0) throw CorruptFileError(array.label() + ": numbers of an unexpected type");
  if (H5Dget_storage_size(array.id()) / sizeof(T) != count(shape))
    throw CorruptFileError(array.label() + ": its numbers are missing");
  std::vector<T> values(count(shape));
  if (!values.empty())
    check_read(H5Dread(array.id(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), array.label(),
               "read it");
  return values;
}

double Group::read_number(const std::string& name) const { return read<double>(name, {}).front(); }

template Dataset Group::write(const std::string&, std::span<const double>, const Shape&);
template Dataset Group::write(const std::string&, std::span<const std::uint32_t>, const Shape&);
template Dataset Group::write(const std::string&, std::span<const std::uint8_t>, const Shape&);
template std::vector<double> Group::read(const std::string&, const Shape&) const;
template std::vector<std::uint32_t> Group::read(const std::string&, const Shape&) const;
template std::vector<std::uint8_t> Group::read(const std::string&, const Shape&) const;

}  // namespace flowslide::hdf5
