# Shell functions that scripts/demo and scripts/test share: install what is missing, configure, build.
# To be sourced by bash with `root` set to the project's folder.

say() { printf '%s\n' "$*"; }

# package_list FILE: packages of scripts/FILE, without comments.
package_list() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$root/scripts/$1"; }

# install_missing_packages [FILE]: installs the packages of scripts/FILE (default: packages.txt) that are not there yet;
# touches nothing if there are none.
install_missing_packages() {
  local list=${1:-packages.txt}
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    say "This is not a Debian system, so nothing is installed. Isolume needs what these Debian 12 packages hold:" >&2
    package_list "$list" >&2
    return 0
  fi
  local missing=() package
  for package in $(package_list "$list"); do
    if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then missing+=("$package"); fi
  done
  if [ ${#missing[@]} -eq 0 ]; then return 0; fi
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "error: these packages are missing, and this is neither root nor is there sudo; as root, run:" >&2
      say "  apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# How many compilers may run at once: one per core, but no more than memory holds.
build_jobs() {
  local mib_per_compiler=1500  # the largest translation units, those of OpenVDB, take that much
  local cores available
  cores=$(nproc)
  available=$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo 2>/dev/null || true)
  local fitting=$((${available:-$mib_per_compiler} / mib_per_compiler))
  local jobs=$((cores < fitting ? cores : fitting))
  say $((jobs > 1 ? jobs : 1))
}

# configure_and_build [-DOPTION=VALUE...] TARGETS...: preset release, into build/release.
configure_and_build() {
  cd "$root"
  local options=()
  while [[ ${1:-} == -D* ]]; do
    options+=("$1")
    shift
  done
  cmake --preset release "${options[@]}"
  local jobs
  jobs=$(build_jobs)
  cmake --build --preset release --parallel "$jobs" --target "$@"
}
