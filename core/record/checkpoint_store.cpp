// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/checkpoint_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "record/sealed_file.hpp"

namespace flowslide {
namespace {

constexpr const char* number_name = "checkpoint";
constexpr const char* checkpoint_remedy = "it is not used";

struct Intact {
  std::int64_t number = 0;
  int place = 0;
  hdf5::File file;
};

/// Opens a checkpoint. Returns an empty optional if the file is absent, or damaged; `complain` is called for damage.
std::optional<Intact> open(const std::filesystem::path& path, int place,
                           const std::function<void(std::string_view)>& complain) {
  if (std::error_code failure; !std::filesystem::exists(path, failure)) return std::nullopt;
  try {
    hdf5::File file = hdf5::File::open(read_sealed(path, checkpoint_remedy), path.string());
    const std::int64_t number = file.root().integer_attribute(number_name);
    if (number < 1) throw CorruptFileError(fmt::format("{}: {} is no number of a checkpoint", path.string(), number));
    return Intact{number, place, std::move(file)};
  } catch (const CorruptFileError& error) {
    complain(error.what());
    return std::nullopt;
  }
}

}  // namespace

CheckpointStore::CheckpointStore(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {}

std::filesystem::path CheckpointStore::path(int place) const {
  return folder_ / fmt::format("{}.checkpoint_{}.h5", name_, place);
}

bool CheckpointStore::empty() const {
  std::error_code failure;
  return !std::filesystem::exists(path(0), failure) && !std::filesystem::exists(path(1), failure);
}

std::optional<std::filesystem::file_time_type> CheckpointStore::last_write() const {
  std::optional<std::filesystem::file_time_type> last;
  for (const int place : {0, 1}) {
    std::error_code failure;
    const auto time = std::filesystem::last_write_time(path(place), failure);
    if (!failure && (!last || time > *last)) last = time;
  }
  return last;
}

void CheckpointStore::put(const std::function<void(hdf5::Group&)>& fill) {
  if (last_ < 0) {
    const auto ignore = [](std::string_view) {};
    last_ = 0;
    for (const int place : {0, 1})
      if (const auto there = open(path(place), place, ignore)) last_ = std::max(last_, there->number);
  }
  const std::int64_t next = last_ + 1;
  const std::filesystem::path file_path = path(static_cast<int>(next % 2));
  auto file = hdf5::File::create(file_path.string());
  file.root().set_attribute(number_name, next);
  fill(file.root());
  write_sealed(file_path, file.image(), IfExists::replace);
  last_ = next;
}

std::int64_t CheckpointStore::read_newest(const std::function<void(const hdf5::Group&)>& read,
                                          const std::function<void(std::string_view)>& complain) const {
  if (empty()) return 0;
  std::vector<Intact> intact;
  for (const int place : {0, 1})
    if (auto there = open(path(place), place, complain)) intact.push_back(std::move(*there));
  std::sort(intact.begin(), intact.end(), [](const Intact& a, const Intact& b) { return a.number > b.number; });
  for (const Intact& checkpoint : intact) {
    try {
      read(checkpoint.file.root());
      return checkpoint.number;
    } catch (const CorruptFileError& error) {
      complain(fmt::format("{}; {}", error.what(), checkpoint_remedy));
    }
  }
  throw CorruptFileError(fmt::format("no checkpoint of {} in {} can be used", name_, folder_.string()));
}

void CheckpointStore::remove() const {
  for (const int place : {0, 1}) {
    std::error_code ignored;
    std::filesystem::remove(path(place), ignored);
  }
}

}  // namespace flowslide
