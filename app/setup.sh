# shellcheck shell=bash
# What app/run and tests/run share: installing the packages that are missing, configuring, building. To be sourced.
# Everything is said on stderr: stdout belongs to the program.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/.build/release"

say() { printf 'loomlight: %s\n' "$*" >&2; }

# install_packages LIST...: the packages named in these files, where they are not installed yet.
install_packages() {
  local package missing=()
  if ! command -v dpkg-query >/dev/null; then
    say "no dpkg here; going on, and expecting what these files list: $*"
    return
  fi
  while read -r package; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
  done < <(sed 's/#.*//; /^[[:space:]]*$/d' "$@")
  ((${#missing[@]})) || return 0

  local as_root=()
  local by_hand="missing packages; please run: apt-get install --no-install-recommends ${missing[*]}"
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      say "$by_hand"
      return 1
    fi
    as_root=(sudo)
    [[ -t 0 ]] || as_root+=(-n) # nobody is there to type a password
    if ! "${as_root[@]}" true 2>/dev/null; then
      say "$by_hand"
      return 1
    fi
  fi
  say "installing ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0)
  if ! { "${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; } </dev/null >&2; then
    say "$by_hand"
    return 1
  fi
}

# As many compilers as there are cores, but no more than memory holds: the largest files take up to 2 GB each.
build_jobs() {
  local cores memory_kb jobs
  cores=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  jobs=$((memory_kb / (2 * 1024 * 1024)))
  ((jobs < cores)) || jobs=$cores
  ((jobs > 0)) || jobs=1
  echo "$jobs"
}

# configure TESTS: ON also builds the tests; OFF leaves a tree that is already configured as it is.
configure() {
  if [[ $1 == OFF && -f $build/build.ninja ]]; then return; fi
  local log="$build/configure.log"
  mkdir -p "$build"
  if ! cmake -S "$root" --preset release -DLOOMLIGHT_TESTS="$1" >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    say "configuring failed"
    return 1
  fi
}

# build_targets TARGET...: silent where nothing is to be done.
build_targets() {
  local jobs
  jobs=$(build_jobs)
  [[ -x $build/app/loomlight ]] || say "building with $jobs jobs, this takes a few minutes the first time"
  if ! NINJA_STATUS='[%f/%t] ' ninja -C "$build" -j "$jobs" "$@" </dev/null 2>&1 |
    sed -u '/no work to do/d; /Re-checking globbed/d; /Entering directory/d' >&2; then
    say "building failed"
    return 1
  fi
}
