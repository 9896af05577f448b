# shellcheck shell=bash
# Clean rooms: minimal Debian systems made for one proof, in a folder of their own, and thrown away. A change root keeps
# the host's files out, and namespaces of its own keep its processes and mounts from outliving it: when a command in a
# room ends or is killed, so do all that it has started. Of the host nothing gets in but what is put there on purpose, its
# resolver, its proxies and apt's own settings. To be sourced after app/setup.sh.

: "${root:?app/setup.sh is sourced first}"
room=""                  # the folder of the room that is open
rooms_kept=no            # whether rooms stay when they are closed
rooms_opened=0           # so far, so that one that stays is in nobody's way
newcomer=/home/newcomer  # the home of a user without rights, in the room
running=""               # the process that runs in namespaces of its own
log=""                   # what it says, where that is kept back

# require_rooms: ends with 77, the exit status that means "cannot be tried here", and a line that says why. Installs what
# rooms are made with; where that fails, so does the script.
require_rooms() {
  if ((EUID != 0)); then
    say "a clean room is a system of its own, which takes root to make: run this as root, or with sudo"
    exit 77
  fi
  if ! unshare --mount --pid --fork true 2>/dev/null; then
    say "a clean room takes namespaces of its own, and this system (a container?) does not let root make them"
    exit 77
  fi
  install_packages "$root/tests/room_packages.txt"
}

# in_namespaces WORD...: unshare's words, and what runs in namespaces of its own. It runs beside this shell, which would
# heed no signal as long as it stood in front: so the room is closed at once when this program is told to end. It is a
# job, since what else runs in the background has to ignore interrupts, and the tests there interrupt programs.
in_namespaces() {
  local status=0
  set -m
  unshare --mount --pid --ipc --fork --kill-child "$@" </dev/null &
  running=$!
  set +m
  wait "$running" || status=$?
  running=""
  return "$status"
}

# stop_running: ends all that runs there.
stop_running() {
  [[ -n $running ]] || return 0
  local first
  read -r first _ 2>/dev/null <"/proc/$running/task/$running/children" || true
  # When the first process of its namespaces is killed, all others are gone before unshare is told.
  kill -KILL ${first:+"$first"} 2>/dev/null || kill -KILL "$running" 2>/dev/null || true
  wait "$running" 2>/dev/null || true
  running=""
}

# open_room RELEASE: a Debian of that release with apt and git alone, and a user "newcomer" who may do nothing.
open_room() {
  local release=$1 parent=${TMPDIR:-/var/tmp} stale
  for stale in "$parent"/loomlight-room.*; do # of runs that were killed
    [[ -d $stale && ! -e $stale/kept && ! -d /proc/${stale##*.} ]] && rm -rf --one-file-system "$stale"
  done
  need_megabytes 6000 "$parent" "a clean room" || exit 1
  room="$parent/loomlight-room.$release.$((++rooms_opened)).$$"
  trap 'stop_running; close_room; rm -f "$log"' EXIT
  trap 'exit 130' INT
  trap 'exit 143' TERM HUP
  log=$(mktemp)
  local setting settings=()
  while read -r setting; do settings+=("--aptopt=$setting"); done < <(
    apt-config dump --format '%f "%v";%n' Acquire::http Acquire::https Acquire::Retries | grep -v ' "";')
  if ! in_namespaces --mount-proc mmdebstrap --quiet --variant=apt --include=git,ca-certificates "${settings[@]}" \
    --customize-hook="cp /etc/resolv.conf \"\$1/etc/resolv.conf\"" "$release" "$room" >"$log" 2>&1; then
    say "a room of $release could not be made: $(reason_of_apt "$log")"
    exit 1
  fi
  rm -f "$log"
  {
    echo "newcomer:x:1000:1000:Newcomer:$newcomer:/bin/bash" >>"$room/etc/passwd"
    echo "newcomer:x:1000:" >>"$room/etc/group"
    echo "newcomer:*:20000:0:99999:7:::" >>"$room/etc/shadow"
    echo "127.0.0.1 localhost $(hostname)" >"$room/etc/hosts"
    mkdir -p "$room$newcomer"
    chown 1000:1000 "$room$newcomer"
  }
}

close_room() {
  [[ -d $room ]] || return 0
  if [[ $rooms_kept == yes ]]; then
    touch "$room/kept"
    say "kept for a look: chroot $room"
  else
    rm -rf --one-file-system "$room"
  fi
  room=""
}

# in_room USER SCRIPT: a shell script run there by root or newcomer, from the user's home. Its processes end with it.
in_room() { enter_room network "" "$@"; }
# in_room_offline USER SCRIPT: likewise, but no network is there.
in_room_offline() { enter_room offline "" "$@"; }
# in_room_full FOLDERS USER SCRIPT: likewise, with little space left on the disks of these folders.
in_room_full() { enter_room network "$@"; }

enter_room() { # network|offline FOLDERS USER SCRIPT
  local full=$2 user=$3 script=$4 home=/root spec=0:0 more=()
  [[ $1 != offline ]] || more=(--net)
  [[ $user == root ]] || home=$newcomer spec=1000:1000
  local variable environment=("HOME=$home" "USER=$user" LANG=C.UTF-8 TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  for variable in http_proxy https_proxy no_proxy; do
    [[ -z ${!variable-} ]] || environment+=("$variable=${!variable}")
  done
  # shellcheck disable=SC2016
  in_namespaces --mount-proc="$room/proc" "${more[@]}" bash -c '
      set -e
      room=$1 spec=$2 home=$3 script=$4 full=$5
      shift 5
      for device in null zero full random urandom tty; do
        touch "$room/dev/$device"
        mount --bind "/dev/$device" "$room/dev/$device"
      done
      mount --rbind /sys "$room/sys"
      mkdir -p "$room/dev/shm"
      mount -t tmpfs -o mode=1777 shm "$room/dev/shm"
      mkdir -p "$room/dev/pts"
      mount -t devpts -o newinstance,ptmxmode=0666,mode=0620 devpts "$room/dev/pts"
      ln -sfn pts/ptmx "$room/dev/ptmx"
      for folder in $full; do
        mkdir -p "$room$folder"
        mount -t tmpfs -o size=8m,mode=1777 full "$room$folder"
      done
      exec chroot --userspec="$spec" "$room" env -i "$@" bash -euo pipefail -c "cd $home; $script"
    ' bash "$room" "$spec" "$home" "$script" "$full" "${environment[@]}"
}

# clone_into_room: this tree's commit as the newcomer gets it, with its history and nothing that is not committed.
clone_into_room() {
  git -C "$root" bundle create --quiet "$room$newcomer/loomlight.bundle" HEAD
  in_room newcomer 'git -c init.defaultBranch=main clone --quiet --config advice.detachedHead=false loomlight.bundle loomlight && rm -f loomlight.bundle'
}

# expect STATUS TEXT WHAT COMMAND...: runs the command; where it ends with another status, or says nothing that matches
# the extended regular expression TEXT, its output is shown and 1 returned.
expect() { expect_said anything "$@"; }
# expect_refusal STATUS TEXT WHAT COMMAND...: likewise, and that line is all it says, but for one of what it installs.
expect_refusal() { expect_said line "$@"; }

expect_said() { # anything|line STATUS TEXT WHAT COMMAND...
  local kind=$1 status=$2 text=$3 what=$4 began=$SECONDS ended=0 as_it_should=yes
  shift 4
  log=$(mktemp)
  "$@" >"$log" 2>&1 || ended=$?
  [[ $ended == "$status" ]] || as_it_should=no
  [[ -z $text ]] || grep -qE "$text" "$log" || as_it_should=no
  [[ $kind == anything || $(grep -cv '^loomlight: installing ' "$log") == 1 ]] || as_it_should=no
  if [[ $as_it_should == no ]]; then
    tail -n 40 "$log" >&2
    [[ $kind == anything ]] || what+=", in one line"
    what+=": ended with $ended (expected $status) or did not say /$text/"
  else
    what+=": as it should ($((SECONDS - began)) s)"
  fi
  rm -f "$log"
  say "$(basename "$room" | cut -d. -f2): $what"
  [[ $as_it_should == yes ]]
}
