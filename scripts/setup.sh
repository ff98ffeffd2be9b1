# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# Set-up that ./check and ./reproduce share: packages, configuration, build. Sourced. Sets `root`.

unset CDPATH   # with it, cd prints the folder
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# awk, printf and sort use a decimal point in every locale of the user.
export LC_ALL=C.UTF-8

# Each rank uses one thread. Runs and ranks share the cores, so no rank is bound to a core.
export OMP_NUM_THREADS=1
# Large pages: samples of 70 400 grains run 1.1 to 1.2 times as fast; smaller ones run as before (docs/performance.md).
export GLIBC_TUNABLES=${GLIBC_TUNABLES:-glibc.malloc.hugetlb=1}
export OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_rmaps_base_oversubscribe=1
if ((EUID == 0)); then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

say() { printf '%s\n' "$*" >&2; }
die() { say "$1"; exit "${2:-2}"; }

# Prepared samples go to the folder of the project, not to the current folder.
export FLOWSLIDE_CACHE=${FLOWSLIDE_CACHE:-$root/cache}

# packages: prints the packages of these lists, one per line.
package_lists=("$root/packages.txt")
packages() { cat "${package_lists[@]}" | sed -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d'; }

missing_packages() {
  local package
  while read -r package; do
    # shellcheck disable=SC2016  # dpkg-query expands it
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || printf '%s\n' "$package"
  done < <(packages)
}

# quietly WHAT LOG COMMAND...: runs COMMAND with its output in LOG. Shows the output too if CI=true. If COMMAND fails,
# shows the last 40 lines and exits with 1.
quietly() {
  local what=$1 log=$2
  shift 2
  say "flowslide: $what"
  mkdir -p "$(dirname "$log")"
  if [[ ${CI-} == true ]]; then
    "$@" 2>&1 | tee "$log" >&2 && return 0
  else
    "$@" >"$log" 2>&1 && return 0
    tail -n 40 "$log" >&2
  fi
  die "flowslide: '$what' failed; see $log" 1
}

install_packages() {
  local missing as_root=()
  command -v dpkg-query >/dev/null || die \
    "flowslide: this is not Debian: install the packages of packages.txt, then run: cmake --workflow --preset release" 1
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0

  local install=(apt-get install -y --no-install-recommends "${missing[@]}")
  if ((EUID != 0)); then
    as_root=(sudo -n)
    if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null; then
      say "flowslide: Debian packages are missing, and this user cannot install them without a password. Run as root:"
      die "  apt-get update && ${install[*]}" 1
    fi
  fi
  local quiet=(env DEBIAN_FRONTEND=noninteractive) options=(-q -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0)
  quietly "apt-get update" "$root/build/apt.log" "${as_root[@]}" "${quiet[@]}" apt-get "${options[@]}" update </dev/null
  quietly "install Debian packages: ${missing[*]}" "$root/build/apt.log" "${as_root[@]}" "${quiet[@]}" "${install[@]}" "${options[@]}" </dev/null
}

# build PRESET [TARGET...]: configures and builds the targets (default: all) into build/PRESET. A lock lets one build run
# at a time.
build() {
  local preset=$1
  shift
  (($#)) || set -- all
  mkdir -p "$root/build"
  (
    flock 9
    cd "$root" || exit
    quietly "configure (preset $preset)" "$root/build/$preset-configure.log" cmake --preset "$preset"
    quietly "build into build/$preset (minutes when new)" "$root/build/$preset-build.log" cmake --build --preset "$preset" --target "$@"
  ) 9>"$root/build/.lock"
}

# set_up PRESET [TARGET...]: installs missing packages and builds.
set_up() {
  install_packages
  build "$@"
}
