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

/// The part of HDF5 that results need, without its handles. Files live in memory: they are written and read in one
/// piece by the caller, so that a full disk or a damaged file is met before HDF5 is. All errors are CorruptFileError
/// when reading and FileError when writing, with the file, the object and HDF5's own words.
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

/// What groups and datasets have in common: attributes, and a name for messages.
class Object {
 public:
  void set_attribute(const std::string& name, std::string_view text);   ///< UTF-8; h5py gives str
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
  /// Makes this one-dimensional array an axis that others can be attached to.
  void make_scale(const std::string& name);
  /// Names `scale` as the axis of dimension 0.
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
  std::vector<std::string> names() const;  ///< of its groups and datasets, in the order of their creation

  /// Creates an array, row-major. T: double, std::uint32_t, std::uint8_t. Throws std::invalid_argument if the number of
  /// values is not the product of `shape`.
  template <typename T>
  Dataset write(const std::string& name, std::span<const T> values, const Shape& shape);
  Dataset write(const std::string& name, double value);
  Dataset write_text(const std::string& name, std::string_view text);

  /// Throws if it is missing, of another type or of another shape; an extent of `any` fits every length.
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
  /// An empty file; `path` serves only messages.
  static File create(const std::string& path);
  /// The file whose bytes are `image`. The image is copied.
  static File open(std::string_view image, const std::string& path);

  Group& root() { return root_; }
  const Group& root() const { return root_; }
  /// The bytes of the file as they belong on disk.
  std::string image() const;

 private:
  File(Handle handle, const std::string& path);
  Handle handle_;
  std::string path_;
  Group root_;
};

}  // namespace flowslide::hdf5
