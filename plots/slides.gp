# SPDX-License-Identifier: GPL-2.0-or-later
# What the figures of slides share, loaded after style.gp: columns of their tables (SI units).

# <point>.dat, one slide over time.
time = 1; displacement = 2; velocity = 3; shear_strain = 4; shear_stress = 6; normal_stress = 7; pore_pressure = 9
driving_stress = 10; inertial_number = 14; global_inertial_number = 15

# <slide>_over_<abscissa>.dat, its replicates: of each quantity the median, and behind it the lowest and the highest.
# The abscissa comes first; time and the quantities before it move up by one. `over_x` is for any abscissa but time.
over_time(quantity) = 2 + 3 * (quantity - 2)
over_x(quantity, abscissa) = 2 + 3 * (quantity < abscissa ? quantity - 1 : quantity - 2)

set style fill transparent solid 0.22 noborder
