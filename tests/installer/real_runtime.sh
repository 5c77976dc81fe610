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
}

supervisor_says() { chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-supervisor --status; }
runtime_says() { chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-runtime --status; }
