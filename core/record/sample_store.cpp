// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sample_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "record/assembly_group.hpp"
#include "record/hdf5.hpp"
#include "record/read_finite.hpp"
#include "record/sealed_file.hpp"
#include "record/series_group.hpp"

namespace flowslide {
namespace {

constexpr const char* sample_remedy = "delete it, and the sample will be prepared again";
constexpr std::string_view failure_mark = "failed: ";

bool is_there(const std::filesystem::path& path) {
  std::error_code failure;  // after an error the file counts as present; reading it then reports the reason
  return std::filesystem::exists(path, failure) || failure;
}

}  // namespace

SampleStore::SampleStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

void SampleStore::make_folder() const {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw FileError(fmt::format("cannot create the folder of samples {}: {}; choose one that you may write",
                                folder_.string(), error.message()));
}

std::filesystem::path SampleStore::path(const std::string& key) const {
  const bool plain = std::ranges::all_of(key, [](unsigned char c) { return std::isalnum(c) != 0; });
  if (key.empty() || !plain)
    throw std::invalid_argument(fmt::format("'{}' is no key of a sample: letters and digits only", key));
  return folder_ / (key + ".h5");
}

bool SampleStore::has(const std::string& key) const { return is_there(path(key)); }

bool SampleStore::has_failure(const std::string& key) const { return is_there(failure_path(key)); }

std::optional<StoredSample> SampleStore::find(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  const auto file_path = path(key);
  const std::string image = read_sealed(file_path, sample_remedy);
  try {
    const auto file = hdf5::File::open(image, file_path.string());
    const auto& root = file.root();
    if (root.text_attribute("key") != key)
      throw CorruptFileError(fmt::format("{} holds the sample of another key", file_path.string()));
    return StoredSample{root.read_text("recipe"), read_assembly(root, "assembly"), read_metrics(root, "metrics")};
  } catch (const CorruptFileError& error) {
    throw CorruptFileError(fmt::format("{}; {}", error.what(), sample_remedy));
  }
}

void SampleStore::put(const std::string& key, const StoredSample& sample) const {
  const auto file_path = path(key);
  auto file = hdf5::File::create(file_path.string());
  auto& root = file.root();
  root.set_attribute("key", key);
  root.write_text("recipe", sample.recipe);
  write_assembly(root, "assembly", sample.assembly);
  if (const std::string flaw = flaw_of(sample.assembly); !flaw.empty())
    throw std::invalid_argument("a sample cannot be kept: " + flaw);
  write_metrics(root, "metrics", sample.metrics);
  make_folder();
  write_sealed(file_path, file.image(), IfExists::replace);
}

std::filesystem::path SampleStore::failure_path(const std::string& key) const {
  return path(key).replace_extension(".failed");
}

std::optional<FailedSample> SampleStore::find_failure(const std::string& key) const {
  if (!has_failure(key)) return std::nullopt;
  const auto file_path = failure_path(key);
  const std::string text = read_sealed(file_path, sample_remedy), first_line = key + "\n";
  const std::size_t mark = text.find(failure_mark);
  if (!text.starts_with(first_line) || mark == std::string::npos)
    throw CorruptFileError(fmt::format("{} holds the failure of another key; {}", file_path.string(), sample_remedy));
  return FailedSample{text.substr(first_line.size(), mark - first_line.size()),
                      text.substr(mark + failure_mark.size())};
}

void SampleStore::put_failure(const std::string& key, const FailedSample& failure) const {
  make_folder();
  write_sealed(failure_path(key), fmt::format("{}\n{}{}{}", key, failure.recipe, failure_mark, failure.reason),
               IfExists::replace);
}

std::filesystem::path SampleStore::lock_path(const std::string& key) const {
  return path(key).replace_extension(".lock");
}

std::optional<FileLock> SampleStore::try_lock(const std::string& key) const {
  make_folder();
  return FileLock::try_lock(lock_path(key));
}

std::string SampleStore::holder(const std::string& key) const { return FileLock::holder(lock_path(key)); }

}  // namespace flowslide
