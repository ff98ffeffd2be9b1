// SPDX-License-Identifier: GPL-2.0-or-later
// Attributes and texts of hdf5.hpp. Strings are UTF-8 of variable length, which h5py returns as str.
#include <fmt/format.h>

#include <stdexcept>

#include "record/hdf5.hpp"
#include "record/hdf5_error.hpp"

namespace flowslide::hdf5 {
namespace {

Handle string_type() {
  Handle type(check_written(H5Tcopy(H5T_C_S1), "HDF5", "create a string type"), H5Tclose);
  check_written(H5Tset_size(type, H5T_VARIABLE), "HDF5", "create a string type");
  check_written(H5Tset_cset(type, H5T_CSET_UTF8), "HDF5", "create a string type");
  return type;
}

Handle scalar() { return {check_written(H5Screate(H5S_SCALAR), "HDF5", "create a scalar"), H5Sclose}; }

std::string terminated(std::string_view text, const std::string& label) {
  if (text.find('\0') != std::string_view::npos)
    throw std::invalid_argument(label + ": a text with a zero byte cannot be stored");
  return std::string(text);
}

void check_scalar(hid_t space, const std::string& label) {
  if (H5Sget_simple_extent_type(space) != H5S_SCALAR) throw CorruptFileError(label + ": a single value was expected");
}

/// Copies a string that HDF5 allocated, and frees it.
std::string taken(char* text) {
  std::string result = text == nullptr ? "" : text;
  H5free_memory(text);
  return result;
}

/// An attribute of an object. `label` names it in messages.
struct AttributeName {
  hid_t object;
  const std::string& name;
  std::string label;
};

void write_attribute(const AttributeName& at, hid_t type, const void* value) {
  const Handle space = scalar();
  const Handle attribute(check_written(H5Acreate2(at.object, at.name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                                       at.label, "create it"),
                         H5Aclose);
  check_written(H5Awrite(attribute, type, value), at.label, "write it");
}

/// Reads one value as `memory_type`. Throws CorruptFileError unless the stored type is of the class `expected`.
void read_attribute(const AttributeName& at, H5T_class_t expected, hid_t memory_type, void* value) {
  const Handle attribute(check_read(H5Aopen(at.object, at.name.c_str(), H5P_DEFAULT), at.label, "open it"), H5Aclose);
  const Handle space(check_read(H5Aget_space(attribute), at.label, "read its shape"), H5Sclose);
  check_scalar(space, at.label);
  const Handle type(check_read(H5Aget_type(attribute), at.label, "read its type"), H5Tclose);
  if (H5Tget_class(type) != expected || (expected == H5T_STRING && H5Tis_variable_str(type) <= 0))
    throw CorruptFileError(at.label + ": a value of an unexpected type");
  check_read(H5Aread(attribute, memory_type, value), at.label, "read it");
}

}  // namespace

void Object::set_attribute(const std::string& name, std::string_view text) {
  const std::string label = label_ + "@" + name;
  const std::string value = terminated(text, label);
  const char* const pointer = value.c_str();
  write_attribute({handle_, name, label}, string_type(), &pointer);
}

void Object::set_attribute(const std::string& name, std::int64_t value) {
  write_attribute({handle_, name, label_ + "@" + name}, H5T_STD_I64LE, &value);
}

void Object::set_attribute(const std::string& name, double value) {
  write_attribute({handle_, name, label_ + "@" + name}, H5T_IEEE_F64LE, &value);
}

bool Object::has_attribute(const std::string& name) const { return H5Aexists(handle_, name.c_str()) > 0; }

std::string Object::text_attribute(const std::string& name) const {
  char* text = nullptr;
  read_attribute({handle_, name, label_ + "@" + name}, H5T_STRING, string_type(), &text);
  return taken(text);
}

std::int64_t Object::integer_attribute(const std::string& name) const {
  std::int64_t value = 0;
  read_attribute({handle_, name, label_ + "@" + name}, H5T_INTEGER, H5T_NATIVE_INT64, &value);
  return value;
}

double Object::number_attribute(const std::string& name) const {
  double value = 0.0;
  read_attribute({handle_, name, label_ + "@" + name}, H5T_FLOAT, H5T_NATIVE_DOUBLE, &value);
  return value;
}

Dataset Group::write_text(const std::string& name, std::string_view text) {
  const std::string label = label_ + "/" + name;
  const std::string value = terminated(text, label);
  const char* const pointer = value.c_str();
  const Handle space = scalar();
  const Handle type = string_type();
  const Handle properties(check_written(H5Pcreate(H5P_DATASET_CREATE), label, "create properties"), H5Pclose);
  H5Pset_obj_track_times(properties, 0);
  const hid_t id = H5Dcreate2(handle_, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  Dataset dataset(Handle(check_written(id, label, "create the text"), H5Dclose), label);
  check_written(H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &pointer), label, "write it");
  return dataset;
}

std::string Group::read_text(const std::string& name) const {
  const Dataset text = dataset(name);
  const Handle space(check_read(H5Dget_space(text.id()), text.label(), "read its shape"), H5Sclose);
  check_scalar(space, text.label());
  const Handle type(check_read(H5Dget_type(text.id()), text.label(), "read its type"), H5Tclose);
  if (H5Tis_variable_str(type) <= 0) throw CorruptFileError(text.label() + ": a text was expected");
  char* content = nullptr;
  check_read(H5Dread(text.id(), string_type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &content), text.label(), "read it");
  return taken(content);
}

}  // namespace flowslide::hdf5
