# SPDX-License-Identifier: GPL-2.0-or-later
# docker build -t flowslide . && docker run --rm -v "$PWD/results:/root/flowslide/results" flowslide ./reproduce fig03
# Without a container engine, scripts/clean_room --dockerfile runs its RUN lines in a bare Debian 12.
FROM debian:12
WORKDIR /root/flowslide
COPY packages.txt .
RUN apt-get update && sed 's/#.*//' packages.txt | xargs apt-get install -y --no-install-recommends && rm -rf /var/lib/apt/lists/*
COPY . .
RUN ./reproduce --build
CMD ["./reproduce"]
