// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <hdf5.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "record/atomic_file.hpp"

/// The part of HDF5 that results need. Files are in memory, and the caller writes and reads them in one piece: a full
/// disk or a damaged file is thus found before HDF5 acts. Reading throws CorruptFileError, and writing throws
/// FileError. The message gives the file, the object and the message of HDF5.
namespace flowslide::hdf5 {

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle();
  operator hid_t() const { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

using Shape = std::vector<std::uint64_t>;  ///< empty for a scalar

/// Base of groups and datasets: attributes, and a label for messages.
class Object {
 public:
  void set_attribute(const std::string& name, std::string_view text);   ///< UTF-8; h5py reads it as str
  void set_attribute(const std::string& name, const char* text) { set_attribute(name, std::string_view(text)); }
  void set_attribute(const std::string& name, std::int64_t value);
  void set_attribute(const std::string& name, int value) { set_attribute(name, std::int64_t{value}); }
  void set_attribute(const std::string& name, double value);
  bool has_attribute(const std::string& name) const;
  std::string text_attribute(const std::string& name) const;
  std::int64_t integer_attribute(const std::string& name) const;
  double number_attribute(const std::string& name) const;

  hid_t id() const { return handle_; }
  const std::string& label() const { return label_; }  ///< "<file>:<path inside>"

 protected:
  Object(Handle handle, std::string label) : handle_(std::move(handle)), label_(std::move(label)) {}
  Handle handle_;
  std::string label_;
};

/// An array in a file.
class Dataset : public Object {
 public:
  Shape shape() const;
  /// Makes this one-dimensional array a dimension scale, the axis of other arrays.
  void make_scale(const std::string& name);
  /// Makes `scale` the axis of dimension 0 of this array.
  void attach_scale(const Dataset& scale);

 private:
  friend class Group;
  using Object::Object;
};

/// A group, or the root of a file.
class Group : public Object {
 public:
  Group create_group(const std::string& name);
  Group group(const std::string& name) const;
  Dataset dataset(const std::string& name) const;
  bool has(const std::string& name) const;
  std::vector<std::string> names() const;  ///< names of its groups and datasets, in order of creation

  /// Creates an array, row-major. T is double, std::uint32_t or std::uint8_t. Throws std::invalid_argument if the
  /// number of values is not the product of `shape`.
  template <typename T>
  Dataset write(const std::string& name, std::span<const T> values, const Shape& shape);
  Dataset write(const std::string& name, double value);
  Dataset write_text(const std::string& name, std::string_view text);

  /// Reads an array, row-major. Throws CorruptFileError if it is missing or of another type or shape. An extent of
  /// `any` matches every length.
  template <typename T>
  std::vector<T> read(const std::string& name, const Shape& expected) const;
  double read_number(const std::string& name) const;
  std::string read_text(const std::string& name) const;

  static constexpr std::uint64_t any = ~std::uint64_t{0};

 private:
  friend class File;
  using Object::Object;
};

/// An HDF5 file in memory.
class File {
 public:
  /// An empty file. `path` appears only in messages.
  static File create(const std::string& path);
  /// The file with the bytes `image`, which are copied. `path` appears only in messages.
  static File open(std::string_view image, const std::string& path);

  Group& root() { return root_; }
  const Group& root() const { return root_; }
  /// The bytes of the file, as they are to be written to disk.
  std::string image() const;

 private:
  File(Handle handle, const std::string& path);
  Handle handle_;
  std::string path_;
  Group root_;
};

}  // namespace flowslide::hdf5
