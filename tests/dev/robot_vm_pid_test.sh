#!/usr/bin/env bash
# robot_vm_pid_test.sh own|foreign: tools/robot-vm.sh signals a process only if its pid file and the process are its user's,
# the file is not a link, and the process is one that it started. `foreign` needs root, which can become another user.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
folder=$(mktemp -d)
process=
clean_up() {
  [ -z "$process" ] || kill -KILL "$process" 2>/dev/null || :
  rm -rf "$folder"
}
trap clean_up EXIT
export ROBOT_VM=$folder/vm
mkdir "$ROBOT_VM"

wrong() {
  echo "robot-vm: $*" >&2
  exit 1
}
runs() { kill -0 "$process" 2>/dev/null; }
robot_vm() { "$root/tools/robot-vm.sh" "$@" >"$folder/out" 2>&1; }

# nobody_is_signalled CASE: none of the commands that end machine and virtual robot, or ask the latter, touches the process.
nobody_is_signalled() {
  local command
  for command in kill stop reset joints; do
    robot_vm "$command" || :
    runs || wrong "$1: '$command' signalled process $process: $(cat "$folder/out")"
  done
  ! robot_vm status || wrong "$1: it says that the machine runs"
}

# pid_files FILE: as those of machine and virtual robot.
pid_files() { for name in qemu robot; do "$@" "$ROBOT_VM/$name.pid"; done; }

case ${1:-} in
  own)
    sleep 600 &
    process=$!
    echo "$process" >"$folder/elsewhere"
    pid_files ln -s "$folder/elsewhere"
    nobody_is_signalled "a link"
    rm "$ROBOT_VM"/*.pid
    pid_files cp "$folder/elsewhere"
    nobody_is_signalled "another program with the number of one that has ended"
    kill -KILL "$process"
    rm "$ROBOT_VM"/*.pid
    bash -c 'exec -a "machine with $1/disk" sleep 600' - "$ROBOT_VM" &
    process=$!
    echo "$process" >"$folder/elsewhere"
    pid_files cp "$folder/elsewhere"
    until tr '\0' ' ' <"/proc/$process/cmdline" | grep -q disk; do sleep 0.05; done
    robot_vm status || wrong "a file of its own is not believed: $(cat "$folder/out")"
    robot_vm kill || wrong "$(cat "$folder/out")"
    ! runs || wrong "a process of its own was not ended"
    ;;
  foreign)
    [ "$(id -u)" = 0 ] || { echo "robot-vm: only root can become another user" >&2 && exit 77; }
    sleep 600 &
    process=$!
    echo "$process" >"$folder/elsewhere"
    chown 65534 "$folder/elsewhere"
    pid_files cp -p "$folder/elsewhere"
    nobody_is_signalled "a file of another user"
    kill -KILL "$process"
    rm "$ROBOT_VM"/*.pid
    setpriv --reuid=65534 --clear-groups sleep 600 &
    process=$!
    until [ "$(stat -c %u "/proc/$process")" = 65534 ]; do sleep 0.01; done
    echo "$process" >"$folder/elsewhere"
    chown 0 "$folder/elsewhere"
    pid_files cp "$folder/elsewhere"
    nobody_is_signalled "a process of another user"
    ;;
  *)
    sed -n '2,3s/^# //p' "$0" >&2
    exit 2
    ;;
esac
