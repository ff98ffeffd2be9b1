// SPDX-License-Identifier: GPL-2.0-or-later
#include "peers/yade_input.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/liggghts/commands.hpp"

namespace flowslide {

std::string yade_script(const PeerSample& sample, const PeerSteps& steps, const std::string& table,
                        const std::string& forces) {
  const Material& m = sample.material;
  const Cell& cell = sample.assembly.cell;
  const TypicalContact typical = typical_contact(sample);
  // YADE has a cell that is periodic in x, y and z. The margin along z keeps the images apart.
  std::string text = fmt::format(
      "import time\n"
      "O.periodic = True\n"
      "O.cell.setBox({:.17g}, {:.17g}, {:.17g})\n"
      "grain = O.materials.append(FrictMat(young={:.17g}, poisson={:.17g}, frictionAngle={:.17g}, density={:.17g}))\n",
      cell.lengths().x(), cell.lengths().y(), (1.0 + 2.0 * box_margin) * cell.height(), m.youngs_modulus,
      m.poisson_ratio, std::atan(m.sliding_friction), m.density);
  text += fmt::format(
      "for line in open('{}'):\n"
      "    if line.startswith('#'):\n"
      "        continue\n"
      "    role, radius, *rest = line.split()\n"
      "    x = [float(word) for word in rest]\n"
      "    body = sphere(x[0:3], float(radius), material=grain)\n"
      "    body.state.vel, body.state.angVel = x[3:6], x[6:9]\n"
      "    body.mask = {{'0': 1, '1': 3, '2': 5}}[role]\n"
      "    if role != '0':\n"
      "        body.state.blockedDOFs = 'xyzXYZ'\n"
      "    O.bodies.append(body)\n",
      table);
  // betan and betas are fractions of 2 sqrt(S m*). Bending moments have one stiffness, and the cap eta (R_1 + R_2)/2
  // F_n.
  const double dashpot = 0.5 * dashpot_coefficient(typical.pair);
  text += fmt::format(
      "O.engines = [\n"
      "    ForceResetter(),\n"
      "    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist={:.17g}, avoidSelfInteractionMask=6),\n"
      "    InteractionLoop(\n"
      "        [Ig2_Sphere_Sphere_ScGeom(avoidGranularRatcheting=False)],\n"
      "        [Ip2_FrictMat_FrictMat_MindlinPhys(betan={:.17g}, betas={:.17g}, krot={:.17g}, ktwist=0, "
      "eta={:.17g})],\n"
      "        [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),\n"
      "    NewtonIntegrator(damping=0, gravity=(0, 0, 0)),\n"
      "]\n",
      0.5 * peer_skin_share * 2.0 * sample.assembly.smallest_radius(), dashpot, dashpot, typical.rolling_stiffness,
      0.5 * m.rolling_friction);
  // The first step is so short that no spring is loaded by it.
  text += fmt::format(
      "O.dt = 1e-20\n"
      "O.step()\n"
      "with open('{}', 'w') as out:\n"
      "    for body in O.bodies:\n"
      "        out.write('%d %.17g %.17g %.17g\\n' % (body.id + 1, *O.forces.f(body.id)))\n"
      "O.dt = {:.17g}\n"
      "O.run({}, True)\n"
      "start = time.perf_counter()\n"
      "O.run({}, True)\n"
      "print('flowslide: %d steps in %.9g s' % ({}, time.perf_counter() - start), flush=True)\n",
      forces, sample.time_step, steps.before, steps.timed, steps.timed);
  return text;
}

}  // namespace flowslide
