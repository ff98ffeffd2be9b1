# SPDX-License-Identifier: GPL-2.0-or-later
# docker build -t flowslide . && docker run --rm -v "$PWD/results:/root/flowslide/results" flowslide ./reproduce fig03
# Without a container engine, scripts/clean_room --dockerfile runs its RUN lines, with its ENV, in a bare Debian 12.
FROM debian:12
WORKDIR /root/flowslide
# The user of a container is root, whom Open MPI refuses without these. Ranks share the cores that the container has.
ENV OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1
ENV OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_rmaps_base_oversubscribe=1
COPY packages.txt .
RUN apt-get update && sed 's/#.*//' packages.txt | xargs apt-get install -y --no-install-recommends && rm -rf /var/lib/apt/lists/*
COPY . .
RUN ./reproduce --build
CMD ["./reproduce"]
