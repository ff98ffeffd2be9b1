// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/liggghts_engine.hpp"

#include <atom.h>
#include <atom_vec.h>
#include <compute.h>
#include <domain.h>
#include <fmt/format.h>
#include <force.h>
#include <integrate.h>
#include <lammps.h>
#include <modify.h>
#include <mpi.h>
#include <output.h>
#include <pair.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "dem/liggghts/c_locale.hpp"
#include "dem/liggghts/commands.hpp"
#include "dem/liggghts/pair_histories.hpp"
#include "dem/liggghts/steering_fix.hpp"
#include "dem/source_hashes.hpp"
#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

std::vector<ContactHistory> gather(const std::vector<ContactHistory>& mine, MPI_Comm communicator) {
  const int bytes = static_cast<int>(mine.size() * sizeof(ContactHistory));
  int ranks = 1;
  MPI_Comm_size(communicator, &ranks);
  std::vector<int> counts(ranks), offsets(ranks);
  MPI_Allgather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
  int total = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    offsets[rank] = total;
    total += counts[rank];
  }
  std::vector<ContactHistory> all(total / sizeof(ContactHistory));
  MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.data(), counts.data(), offsets.data(), MPI_BYTE, communicator);
  std::sort(all.begin(), all.end(), [](const ContactHistory& a, const ContactHistory& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return all;
}

Vector3 fold(const Cell& cell, Vector3 position) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!cell.periodic[axis]) continue;
    const double length = cell.lengths()[axis];
    position[axis] -= length * std::floor((position[axis] - cell.lower[axis]) / length);
    if (position[axis] >= cell.upper[axis]) position[axis] = cell.lower[axis];
  }
  return position;
}

/// LIGGGHTS has no sheared periodic images, and this adapter does not compress a periodic z axis.
void refuse_sliding_faces(const Cell& cell, const BoundaryMotion& motion) {
  const bool slides = cell.shear_offset != 0.0 || cell.shear_velocity != 0.0;
  const bool moves = motion.bottom_velocity != Vector3::Zero() || motion.top_velocity != Vector3::Zero();
  if (slides || (cell.periodic[2] && moves))
    throw EngineError("LIGGGHTS neither shears nor compresses a cell across periodic faces along z; choose --engine "
                      "native, or a sample with glued layers");
}

}  // namespace

LiggghtsEngine::LiggghtsEngine(std::filesystem::path log, SeparatedHistory separated, MPI_Comm communicator)
    : log_(std::move(log)), separated_(separated), communicator_(communicator) {
  ensure_mpi();
}
LiggghtsEngine::~LiggghtsEngine() = default;

void LiggghtsEngine::load(const Assembly& assembly, const EngineSettings& settings) {
  refuse_sliding_faces(assembly.cell, {});
  const CLocale decimal_point;
  settings_ = settings;
  motion_ = {};
  grains_ = assembly.size();
  instance_.reset();
  instance_ = std::make_unique<LiggghtsInstance>(log_, communicator_);
  for (const std::string& line : setup_commands(assembly, settings, separated_)) instance_->command(line);
  create_grains(assembly);
  for (const std::string& line : grain_commands()) instance_->command(line);
  install_steering(assembly.cell);
  restore(assembly);
}

void LiggghtsEngine::create_grains(const Assembly& assembly) {
  instance_->enter("creating grains");
  LAMMPS_NS::LAMMPS& lammps = **instance_;
  LAMMPS_NS::Atom& atom = *lammps.atom;
  const LAMMPS_NS::Domain& domain = *lammps.domain;
  for (std::size_t k = 0; k < assembly.size(); ++k) {
    Vector3 position = fold(assembly.cell, assembly.position[k]);
    bool mine = true;
    for (int axis = 0; axis < 3; ++axis)
      mine = mine && position[axis] >= domain.sublo[axis] && position[axis] < domain.subhi[axis];
    if (!mine) continue;
    const int i = atom.nlocal;
    atom.avec->create_atom(atom_type(assembly.role[k]), position.data());
    const double radius = assembly.radius[k];
    atom.tag[i] = static_cast<int>(k) + 1;
    atom.radius[i] = radius;
    atom.density[i] = settings_.material.density;
    atom.rmass[i] = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * settings_.material.density;
    Vector3::Map(atom.v[i]) = assembly.velocity[k];
    Vector3::Map(atom.omega[i]) = assembly.spin[k];
    for (int m = 0; m < lammps.modify->nfix; ++m)
      if (lammps.modify->fix[m]->create_attribute) lammps.modify->fix[m]->set_arrays(i);
  }
  LAMMPS_NS::bigint count = atom.nlocal;
  MPI_Allreduce(&count, &atom.natoms, 1, MPI_LMP_BIGINT, MPI_SUM, instance_->communicator());
  if (atom.natoms != static_cast<LAMMPS_NS::bigint>(assembly.size()))
    throw EngineError(fmt::format("{} of {} grains lie outside the cell; every centre must be inside its planes",
                                  assembly.size() - atom.natoms, assembly.size()));
  atom.nghost = 0;
  atom.map_init();
  atom.map_set();
}

void LiggghtsEngine::install_steering(const Cell& cell) {
  LAMMPS_NS::Modify& modify = *(*instance_)->modify;
  char id[] = "steering";
  const int place = modify.find_fix(id);
  // A fix style cannot be registered from outside the library, but the list of fixes is public. The steering fix
  // replaces the placeholder of grain_commands().
  delete modify.fix[place];
  steering_ = new SteeringFix(&**instance_, cell, settings_);
  modify.fix[place] = steering_;
  modify.fmask[place] = steering_->setmask();
}

void LiggghtsEngine::restore(const Assembly& assembly) {
  instance_->enter("setting up the first step");
  LAMMPS_NS::LAMMPS& lammps = **instance_;
  lammps.update->whichflag = 1;
  lammps.init();
  lammps.update->integrate->setup();
  lammps.update->first_update = 1;
  lammps.output->next = std::numeric_limits<LAMMPS_NS::bigint>::max();
  // The set-up has evaluated forces with the velocities of the full step. Restores the histories and forces of the last
  // step.
  write_histories(lammps, settings_.material.contact_law, assembly.contacts);
  LAMMPS_NS::Atom& atom = *lammps.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    const std::size_t k = static_cast<std::size_t>(atom.tag[i] - 1);
    Vector3::Map(atom.f[i]) = assembly.force[k];
    Vector3::Map(atom.torque[i]) = assembly.torque[k];
  }
}

void LiggghtsEngine::set(const EngineSettings& settings) {
  if (!(settings_.material == settings.material)) {  // LIGGGHTS caches the properties of the material
    const BoundaryMotion motion = motion_;
    load(save(), settings);
    move(motion);
    return;
  }
  settings_ = settings;
  LAMMPS_NS::LAMMPS& lammps = **instance_;
  lammps.update->dt = settings.time_step;
  for (int m = 0; m < lammps.modify->nfix; ++m) lammps.modify->fix[m]->reset_dt();
  steering_->set(settings);
}

void LiggghtsEngine::move(const BoundaryMotion& motion) {
  refuse_sliding_faces(steering_->cell(), motion);
  motion_ = motion;
  steering_->move(motion);
}

void LiggghtsEngine::run(std::int64_t steps) {
  constexpr std::int64_t most_at_once = 1'000'000'000;
  for (; steps > 0; steps -= most_at_once) advance(static_cast<int>(std::min(steps, most_at_once)));
}

void LiggghtsEngine::advance(int steps) {
  const CLocale decimal_point;
  instance_->enter(fmt::format("running {} steps", steps));
  LAMMPS_NS::Update& update = *(*instance_)->update;
  update.nsteps = steps;
  update.firststep = update.beginstep = update.ntimestep;
  update.laststep = update.endstep = update.ntimestep + steps;
  // Requests the virial of the pairs at the last step, for the lateral stresses.
  char pressure[] = "pair_virial";
  LAMMPS_NS::Modify& modify = *(*instance_)->modify;
  modify.compute[modify.find_compute(pressure)]->addstep(update.laststep);
  // Runs without a new set-up, which in the command `run 1000` costs several steps.
  update.integrate->run(steps);
}

CellStress LiggghtsEngine::cell_stress() const {
  if (steering_->cell().periodic[2])
    throw EngineError(
        "LIGGGHTS does not tell the shear stress of a cell that is periodic along z; choose --engine native");
  StressSums sums = steering_->sums();
  sums.pair_virial_x = (*instance_)->force->pair->virial[0];
  sums.pair_virial_y = (*instance_)->force->pair->virial[1];
  static_assert(sizeof(StressSums) == 17 * sizeof(double), "summed over the ranks as numbers in a row");
  MPI_Allreduce(MPI_IN_PLACE, &sums, 17, MPI_DOUBLE, MPI_SUM, instance_->communicator());
  return stress_of(sums, steering_->cell());
}

Cell LiggghtsEngine::cell() const { return steering_->cell(); }

std::uint64_t LiggghtsEngine::count_grains() const {
  std::uint64_t count = steering_->grains_inside();
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_UINT64_T, MPI_SUM, instance_->communicator());
  return count;
}

Assembly LiggghtsEngine::save() const {
  const LAMMPS_NS::Atom& atom = *(*instance_)->atom;
  constexpr std::size_t width = 17;  // five vectors, radius, role
  std::vector<double> table(grains_ * width, 0.0);
  for (int i = 0; i < atom.nlocal; ++i) {
    double* row = &table[static_cast<std::size_t>(atom.tag[i] - 1) * width];
    int column = 0;
    for (double** array : {atom.x, atom.v, atom.omega, atom.f, atom.torque})
      for (int axis = 0; axis < 3; ++axis) row[column++] = array[i][axis];
    row[15] = atom.radius[i];
    row[16] = atom.type[i];
  }
  MPI_Allreduce(MPI_IN_PLACE, table.data(), static_cast<int>(table.size()), MPI_DOUBLE, MPI_SUM,
                instance_->communicator());

  Assembly assembly;
  assembly.cell = steering_->cell();
  assembly.resize(grains_);
  for (std::size_t k = 0; k < grains_; ++k) {
    const double* row = &table[k * width];
    if (row[16] == 0.0)
      throw EngineError(fmt::format("grain {} left the cell: the time step {} s may be too large, or the boundaries "
                                    "move too fast; log: {}", k, settings_.time_step, log_.string()));
    assembly.position[k] = fold(assembly.cell, Vector3::Map(row));
    assembly.velocity[k] = Vector3::Map(row + 3);
    assembly.spin[k] = Vector3::Map(row + 6);
    assembly.force[k] = Vector3::Map(row + 9);
    assembly.torque[k] = Vector3::Map(row + 12);
    assembly.radius[k] = row[15];
    assembly.role[k] = role_of(static_cast<int>(row[16]));
  }
  assembly.contacts = gather(read_histories(**instance_, settings_.material.contact_law), instance_->communicator());
  return assembly;
}

std::string LiggghtsEngine::version() const {
  return fmt::format("{} (adapter {})", FLOWSLIDE_LIGGGHTS_VERSION, source_hashes::liggghts);
}

}  // namespace flowslide
