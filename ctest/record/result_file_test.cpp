// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/result_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "damage.hpp"
#include "example.hpp"
#include "full_disk.hpp"
#include "record/hdf5.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

TEST(ResultFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const auto result = example_result();
  write_result(folder / "run.h5", result);
  EXPECT_EQ(folder.entries(), 1);
  const auto read = read_result(folder / "run.h5");
  EXPECT_EQ(read.configuration, result.configuration);
  EXPECT_EQ(read.configuration_hash, result.configuration_hash);
  EXPECT_EQ(read.identity, "point name = e0=0.790\n");
  ASSERT_EQ(read.inputs.size(), 1);
  EXPECT_EQ(read.inputs[0].name, "loading");
  EXPECT_EQ(read.inputs[0].file, "quake.txt");
  EXPECT_EQ(content_of(read.inputs[0]), content_of(result.inputs[0]));
  EXPECT_EQ(read.series.column("shear_stress").values, result.series.column("shear_stress").values);
  ASSERT_EQ(read.metrics.size(), 2);
  EXPECT_EQ(read.metrics[0].value, 1234.5);
  ASSERT_EQ(read.parameters.size(), 1);
  EXPECT_EQ(read.parameters[0].name, "hydraulic_conductivity");
  EXPECT_EQ(read.parameters[0].value, 2e-5);
  ASSERT_EQ(read.windows.size(), 2);
  EXPECT_EQ(read.windows[1].axis.name, "displacement");
  EXPECT_EQ(read.windows[1].column("shear_stress").values, result.windows[1].column("shear_stress").values);
  const auto &from = read.provenance, &expected = result.provenance;
  EXPECT_EQ(from.git_revision, expected.git_revision);
  EXPECT_EQ(from.case_name, "fig03_undrained");
  EXPECT_EQ(from.point, "e0=0.790");
  EXPECT_EQ(from.command_line, expected.command_line);
  EXPECT_EQ(from.start_time, expected.start_time);
  EXPECT_EQ(from.seed, -9007199254740993);
  EXPECT_EQ(from.mpi_ranks, 2);
  EXPECT_EQ(from.replicate, 3);
  EXPECT_EQ(from.sample, "loose 3f2a");
  EXPECT_EQ(from.predicted_seconds, 60.0);
  EXPECT_EQ(from.processor_seconds, 75.0);
}

TEST(ResultFile, ReadsFilesThatDoNotSayWhatTheyCost) {
  auto file = hdf5::File::create("before.h5");
  write_result(file.root(), example_result());
  H5Adelete(file.root().id(), "processor_seconds");
  EXPECT_TRUE(std::isnan(read_result(file.root()).provenance.processor_seconds));
}

TEST(ResultFile, ReadsFilesThatDoNotSayWhatWentIn) {
  auto file = hdf5::File::create("before.h5");
  write_result(file.root(), example_result());
  H5Ldelete(file.root().id(), "identity", H5P_DEFAULT);
  H5Ldelete(file.root().id(), "inputs", H5P_DEFAULT);
  EXPECT_EQ(read_result(file.root()).identity, "");
  EXPECT_TRUE(read_result(file.root()).inputs.empty());
}

TEST(ResultFile, KeepsInputTablesWithTheirUnits) {
  const TemporaryFolder folder;
  write_result(folder / "run.h5", example_result());
  const auto file = hdf5::File::open(read_file(folder / "run.h5"), "run.h5");
  const auto loading = file.root().group("inputs").group("loading");
  EXPECT_EQ(loading.dataset("time").text_attribute("units"), "s");
  EXPECT_EQ(loading.dataset("stress_change").text_attribute("units"), "Pa");
  EXPECT_EQ(loading.read<double>("stress_change", {hdf5::Group::any}), (std::vector{0.0, 500.0}));
}

TEST(ResultFile, HasTheRootAttributesThatReadersLookFor) {
  const TemporaryFolder folder;
  write_result(folder / "run.h5", example_result());
  // Opened as other programs do: the file as it is, with the seal behind it.
  const auto file = hdf5::File::open(read_file(folder / "run.h5"), "run.h5");
  for (const char* name :
       {"code_version", "git_revision", "git_state", "compiler", "compiler_flags", "build_type", "engine",
        "engine_version", "host", "command_line", "start_time", "paper_doi", "case", "point", "figure", "scale",
        "configuration_hash"})
    EXPECT_NO_THROW(file.root().text_attribute(name)) << name;
  for (const char* name : {"mpi_ranks", "seed", "replicate"})
    EXPECT_NO_THROW(file.root().integer_attribute(name)) << name;
  EXPECT_EQ(file.root().dataset("configuration").text_attribute("hash"), "abc123");
}

TEST(ResultFile, CanBeOpenedFromDiskByHdf5Alone) {
  const TemporaryFolder folder;
  write_result(folder / "run.h5", example_result());
  const hdf5::Handle file(H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  ASSERT_GE(file, 0);
  const hdf5::Handle column(H5Dopen2(file, "series/normal_stress", H5P_DEFAULT), H5Dclose);
  EXPECT_GE(column, 0);
}

TEST(ResultFile, IsNotOverwrittenUnlessTold) {
  const TemporaryFolder folder;
  auto result = example_result();
  write_result(folder / "run.h5", result);
  const auto before = read_file(folder / "run.h5");
  result.configuration = "other";
  EXPECT_THROW(write_result(folder / "run.h5", result), FileError);
  EXPECT_TRUE(read_file(folder / "run.h5") == before);
  write_result(folder / "run.h5", result, IfExists::replace);
  EXPECT_EQ(read_result(folder / "run.h5").configuration, "other");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(ResultFile, IsNotWrittenWithABadNumberOrOnAFullDisk) {
  const TemporaryFolder folder;
  auto result = example_result();
  {
    const FullDisk full(2000);
    EXPECT_THROW(write_result(folder / "run.h5", result), FileError);
  }
  result.series.columns[0].values[4] = std::nan("");
  EXPECT_THROW(write_result(folder / "run.h5", result), std::invalid_argument);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(ResultFile, DamageIsFound) {
  const TemporaryFolder folder;
  write_result(folder / "run.h5", example_result());
  expect_damage_found(folder / "run.h5", [&] { read_result(folder / "run.h5"); });
}

TEST(ResultFile, AnotherProgramsFileIsRefused) {
  const TemporaryFolder folder;
  auto file = hdf5::File::create("run.h5");
  write_atomically(folder / "run.h5", file.image());
  EXPECT_THROW(read_result(folder / "run.h5"), CorruptFileError);
  EXPECT_THROW(read_result(folder / "none.h5"), FileError);
}

}  // namespace
}  // namespace flowslide
