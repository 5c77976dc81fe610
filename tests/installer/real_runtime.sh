# shellcheck shell=bash disable=SC2034,SC2154  # some names are read by the scenarios, others set by robot.sh
# The real i686 programs on the robot. Sourced after robot.sh by who needs a loop that turns.

# What ./dev build --robot has made; DARWINOP_ROBOT_BUILD names another place.
robot_build=${DARWINOP_ROBOT_BUILD:-$SOURCE/build/robot}

put_real_runtime() {
  local home=$ROBOT/opt/darwinop
  [ -x "$robot_build/bundle/bin/darwinop-supervisor" ] || fail "no runtime in $robot_build/bundle; run: ./dev build --robot"
  rm -rf "$home"
  mkdir -p "$home/versions" "$home/log"
  cp -r "$robot_build/bundle" "$home/versions/real"
  ln -s versions/real "$home/current"
  install -m 755 "$SOURCE/installer/start" "$home/start"
  echo 'darwinop:x:998:997::/nonexistent:/bin/false' >>"$ROBOT/etc/passwd"
  echo 'darwinop:x:997:' >>"$ROBOT/etc/group"
}

# expect_user UID PATTERN: every process on the robot whose command line matches has that user's rights, and there is one.
expect_user() {
  local process found=0
  for process in $(robot_processes); do
    tr '\0' ' ' 2>/dev/null <"/proc/$process/cmdline" | grep -qE -- "$2" || continue
    found=1
    [ "$(awk '/^Uid:/ { print $2, $3, $4, $5 }' "/proc/$process/status")" = "$1 $1 $1 $1" ] ||
      fail "$2 (process $process) has the rights of user $(awk '/^Uid:/ { print $3 }' "/proc/$process/status"), not of $1"
  done
  [ $found = 1 ] || fail "nothing runs that is called $2"
}

supervisor_says() { chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-supervisor --status; }
runtime_says() { chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-runtime --status; }
