#!/usr/bin/env bash
# The sandbox of the systemd unit: as docs/run-on-the-robot.md describes it, accepted by systemd, and the programs work with
# its file system, capabilities and no-new-privileges.
# shellcheck disable=SC2154  # robot.sh sets what is read here
. "$(dirname "$(readlink -f "$0")")/robot.sh"

unit=$SOURCE/installer/darwinop.service.template

# value KEY: of the unit's only line with it.
value() {
  [ "$(grep -c "^$1=" "$unit")" = 1 ] || fail "the unit needs one line $1="
  sed -n "s/^$1=//p" "$unit"
}

scenario_installed_unit_is_the_template_and_systemd_accepts_it() {
  local v1 installed exposure said; v1=$(fake_bundle 0.1.0+a)
  run_install --autostart systemd --bundle "$v1"
  expect_status 0
  installed=$ROBOT/etc/systemd/system/darwinop.service
  diff "$unit" "$installed" || fail "another unit was installed"
  [ -x /usr/bin/systemd-analyze ] || skip "systemd-analyze is not installed (Debian package systemd)"
  sed "s|^ExecStart=.*|ExecStart=/bin/true|" "$installed" >"$LAB/darwinop.service"
  said=$(systemd-analyze verify "$LAB/darwinop.service" 2>&1) || fail "systemd does not accept the unit: $said"
  [ -z "$said" ] || fail "systemd says: $said"
  exposure=$(sed -n 's/.*exposure \([0-9]*\)\.\([0-9]\) of 10.*/\1\2/p' "$SOURCE/docs/run-on-the-robot.md")
  systemd-analyze security --offline=true --threshold="$exposure" "$LAB/darwinop.service" >"$LAB/exposure" ||
    fail "more exposed than docs/run-on-the-robot.md says: $(tail -n 1 "$LAB/exposure")"
}

# Any of these makes systemd 247 refuse the serial device.
scenario_unit_says_nothing_about_devices() {
  ! grep -E '^(ProtectClock|PrivateDevices|DeviceAllow|DevicePolicy)=' "$unit" || fail "an older systemd would refuse devices"
}

# Each documented restriction, and what the loop needs.
scenario_unit_has_the_documented_restrictions() {
  local line group
  while read -r line; do
    [ "$(value "${line%%=*}")" = "${line#*=}" ] || fail "the unit lacks $line"
  done <<'END'
ProtectSystem=strict
ReadWritePaths=/opt/darwinop
PrivateTmp=yes
NoNewPrivileges=yes
ProtectKernelModules=yes
ProtectKernelTunables=yes
RestrictNamespaces=yes
RestrictSUIDSGID=yes
MemoryDenyWriteExecute=yes
KillMode=process
Restart=on-failure
RestartPreventExitStatus=4
LimitRTPRIO=99
LimitMEMLOCK=infinity
END
  for group in @mount @module @debug @reboot @raw-io; do
    case " $(value SystemCallFilter | sed 's/^~/ /') " in *" $group "*) ;; *) fail "the unit allows $group" ;; esac
  done
  case $(value CapabilityBoundingSet) in *SYS_ADMIN* | *SYS_PTRACE* | *SYS_MODULE* | *SYS_RAWIO*) fail "too many capabilities" ;; esac
}

# in_sandbox COMMAND...: read-only system except /opt/darwinop, private /tmp, the unit's capabilities, no new privileges.
in_sandbox() {
  unshare --mount --propagation private bash -euc '
    mount -t tmpfs tmpfs /opt
    mkdir /opt/darwinop
    mount --bind "$1" /opt/darwinop
    mount -o remount,ro /opt
    mount -o remount,bind,ro /
    mount -t tmpfs tmpfs /tmp
    ! touch /opt/x /var/x 2>/dev/null
    bounding=$2
    shift 2
    exec setpriv --no-new-privs --bounding-set "$bounding" "$@"' - \
    "$LAB/home" "-all$(value CapabilityBoundingSet | tr '[:upper:]' '[:lower:]' | sed 's/cap_/+/g; s/ *+/,+/g')" "$@"
}

scenario_programs_drive_and_rest_the_robot_in_the_sandbox() {
  local home=$LAB/home tries=0 asked
  export DARWINOP_RUNTIME_NAME=darwinop-sandbox-test
  asked="$DARWINOP_BIN/darwinop-supervisor"
  mkdir -p "$home/controllers/hello"
  cp "$DARWINOP_BIN/../controllers/01_hello_head/01_hello_head" "$home/controllers/hello/hello"
  ln -s controllers/hello "$home/default"
  printf '[Robot]\nport = /opt/darwinop/port\ncontroller_user = nobody\ngroup = nogroup\n' >"$home/robot.ini"
  "$DARWINOP_BIN/darwinop-virtual-robot" --link "$home/port" >"$LAB/virtual-robot" 2>&1 &
  until [ -L "$home/port" ] || [ $((tries += 1)) -ge 200 ]; do sleep 0.05; done
  in_sandbox "$asked" --home /opt/darwinop >"$LAB/said" 2>&1 &
  supervisor=$!
  tries=0
  until grep -q 's  neck [+-]0\.[1-9]' "$home/log/controller.log" 2>/dev/null; do
    [ $((tries += 1)) -lt 600 ] || fail "no controller drives: $(cat "$LAB/said" "$home/log/"* 2>&1)"
    sleep 0.05
  done
  grep -q '^Uid:[[:space:]]*65534' "/proc/$("$asked" --status | sed -n 's/^controller .*pid \([0-9]*\),.*/\1/p')/status" ||
    fail "the controller is not run as another user"
  "$asked" --stop || fail "the robot was not brought to rest: $(cat "$LAB/said")"
  wait "$supervisor" || fail "the supervisor ended with $?: $(cat "$LAB/said")"
  kill %1
}

run_scenarios "$@"
