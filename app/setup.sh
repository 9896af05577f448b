# shellcheck shell=bash
# What app/run, tests/run and the gates share: installing the packages that are missing, configuring, building. To be
# sourced. Everything is said on stderr: stdout belongs to the program.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
use_preset() { # NAME: the configure preset of CMakePresets.json that the functions below build
  preset=$1
  build="$root/.build/$preset"
}
use_preset release

say() { printf 'loomlight: %s\n' "$*" >&2; }

# missing_packages LIST...: those named in these files that are not installed, one a line.
missing_packages() {
  local package
  while read -r package; do
    # A word for each architecture that has it.
    [[ " $(dpkg-query -W -f='${db:Status-Status} ' "$package" 2>/dev/null) " == *" installed "* ]] || printf '%s\n' "$package"
  done < <(sed 's/#.*//; s/[[:space:]]*$//; /^$/d' "$@")
}

# install_packages LIST...: the packages named in these files, where they are not installed yet. Where that cannot be
# done, one line says why and which command does it.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "no dpkg here; going on, and expecting what these files list: $*"
    return
  fi
  local missing=()
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0

  local by_hand="please run, as root: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      say "packages are missing, and installing them takes root or sudo; $by_hand"
      return 1
    fi
    as_root=(sudo)
    [[ -t 0 ]] || as_root+=(-n) # nobody is there to type a password
    if ! "${as_root[@]}" true 2>/dev/null; then
      say "packages are missing, and sudo does not let this user install them; $by_hand"
      return 1
    fi
  fi
  say "installing ${missing[*]}"
  local log updating apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -qq -o Dpkg::Use-Pty=0)
  log=$(mktemp)
  updating=$(mktemp)
  # A list that cannot be brought up to date may still do; whether it does is for the installation to say.
  "${apt[@]}" update </dev/null >"$updating" 2>&1 || true
  if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null >"$log" 2>&1; then
    # A source that is dead is the reason only where a package is not in the lists that there are.
    ! grep -qE 'Unable to locate package|no installation candidate' "$log" || cat "$updating" >>"$log"
    say "the packages could not be installed ($(reason_of_apt "$log")); $by_hand"
    rm -f "$log" "$updating"
    return 1
  fi
  rm -f "$log" "$updating"
}

# reason_of_apt LOG: why it failed, in a few words.
reason_of_apt() {
  if grep -qE 'Temporary failure resolving|Could not resolve|Could not connect|Network is unreachable' "$1"; then
    echo "no network, or none that reaches the packages"
  elif grep -qE 'No space left|enough free space' "$1" || has_no_room "$(dirname "$1")"; then
    echo "the disk is full"
  elif grep -q 'Unable to locate package' "$1"; then
    echo "not known here: $(sed -n 's/.*Unable to locate package //p' "$1" | paste -sd ' '); Debian 12 and 13 have them"
  else
    sed -n 's/^E: //p' "$1" | head -n 1 | grep . || echo "apt-get failed"
  fi
}

# free_megabytes FOLDER: what its disk has left; of the nearest folder above that exists.
free_megabytes() {
  local folder=$1
  while [[ ! -d $folder ]]; do folder=$(dirname "$folder"); done
  df --output=avail -BM "$folder" | tail -n 1 | tr -dc 0-9 # names of disks may have blanks
}

# has_no_room FOLDER: whether its disk is so full that what is written there is lost.
has_no_room() { (($(free_megabytes "$1") < 1)); }

# is_full FOLDER: whether its disk has so little left that what was just being built there ended for want of it.
is_full() { (($(free_megabytes "$1") < 50)); }

# need_megabytes N FOLDER WHAT: says it in a line where the disk of the folder has less left.
need_megabytes() {
  local free
  free=$(free_megabytes "$2")
  if ((free < $1)); then
    say "not enough space on the disk of $2: $3 takes about $1 MB, $free MB are free"
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

# build_megabytes TESTS: what the preset's build takes, with tests (ON) or without, and some to spare. With all tests 440
# were measured of checked and 1150 of tsan. An object of asan is 5.6 times as large as one of tsan, and one of debug 17
# times as large as one of checked.
build_megabytes() {
  case $preset/$1 in
    asan/ON) echo 6000 ;;
    debug/ON) echo 4500 ;;
    tsan/ON | asan/OFF | debug/OFF | fuzz/OFF) echo 1500 ;;
    */ON) echo 800 ;;
    *) echo 500 ;;
  esac
}

# afresh: what to do where the folder of a build is of no use any more.
afresh() { echo "please remove that folder and try again: rm -r $(printf %q "$build")"; }

# configure TESTS: ON also builds the tests; OFF leaves a tree that is already configured as it is.
configure() {
  local configured_for=""
  [[ ! -f $build/CMakeCache.txt ]] || configured_for=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
  if [[ -n $configured_for && ! $configured_for -ef $root ]]; then
    say "$build builds what is in $configured_for, where this tree was before it was moved or copied; $(afresh)"
    return 1
  fi
  if [[ $1 == OFF && -f $build/build.ninja ]]; then return; fi
  if [[ ! -f $build/build.ninja ]]; then
    need_megabytes "$(build_megabytes "$1")" "$build" "building" || return 1
  fi
  local log="$build/configure.log"
  mkdir -p "$build"
  if ! cmake -S "$root" --preset "$preset" -DLOOMLIGHT_TESTS="$1" >"$log" 2>&1 </dev/null; then
    cat "$log" >&2 || true # a full disk may have kept it from being begun
    if is_full "$build"; then
      say "configuring failed: the disk of $build is full"
    elif [[ -f $build/build.ninja ]]; then
      say "configuring failed; where the system has changed since it last succeeded, $(afresh)"
    else
      say "configuring failed"
    fi
    return 1
  fi
}

# build_targets TARGET...: silent where nothing is to be done.
build_targets() {
  local jobs said
  jobs=$(build_jobs)
  [[ -x $build/app/loomlight ]] || say "building with $jobs jobs, this takes a few minutes the first time"
  if ! said=$(NINJA_STATUS='[%f/%t] ' ninja -C "$build" -j "$jobs" "$@" </dev/null 2>&1 |
    sed -u '/no work to do/d; /Re-checking globbed/d; /Entering directory/d; w /dev/stderr'); then
    if is_full "$build"; then
      say "building failed: the disk of $build is full"
    elif [[ $said == *"no known rule to make it"* || $said == *"CMake Error"* ]]; then
      say "building failed; where the system has changed since $build was made, $(afresh)"
    else
      say "building failed"
    fi
    return 1
  fi
}
