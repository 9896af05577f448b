# shellcheck shell=bash
# Jobs of a script that end when it does. While a shell waits for what stands in front it hears of no signal, and what a
# script starts in the background hears of no interrupt: so each job is a group of processes of its own, which is told to
# end when the script is. To be sourced.

# begin COMMAND...: starts it; nobody is there to answer it.
begin() {
  set -m
  "$@" </dev/null &
  set +m
}

# in_front COMMAND...: starts it, and ends as it does.
in_front() {
  begin "$@"
  wait "$!"
}

# shellcheck disable=SC2317 # it is reached by the trap
end_jobs() {
  local group
  for group in $(jobs -p); do kill -TERM -- "-$group" 2>/dev/null || true; done
  wait
}
trap end_jobs EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP
