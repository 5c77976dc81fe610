# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Autostart at boot: a block in /etc/rc.local, a systemd unit, or none.

unit_file() { echo "$etc/systemd/system/darwinop.service"; }
unit_link() { echo "$etc/systemd/system/multi-user.target.wants/darwinop.service"; }

# rc.local, systemd or none: from the command line, else from the last installation, else as found on the robot.
autostart_wanted() {
  if [ -n "$autostart" ]; then
    echo "$autostart"
  elif [ -s "$home/kept/autostart" ] && [ "$(version_current)" != - ]; then
    cat "$home/kept/autostart"
  elif [ -d /run/systemd/system ]; then
    echo systemd
  else
    echo rc.local
  fi
}

# The present kind.
autostart_kind() {
  if [ -e "$(unit_link)" ]; then
    echo systemd
  elif grep -q '^# >>> darwinop-rt' "$etc/rc.local" 2>/dev/null && grep -q '/opt/darwinop/start' "$etc/rc.local"; then
    echo rc.local
  else
    echo none
  fi
}

# autostart_is KIND: true if autostart_set would change nothing.
autostart_is() {
  [ "$(autostart_kind)" = "$1" ] || return
  case $1 in
    rc.local) [ ! -e "$(unit_file)" ] && [ -x "$etc/rc.local" ] && rc_local_is_ours "$(rc_local_file)" ;;
    systemd) [ "$(cat "$(unit_file)")" = "$text_unit" ] ;;
    none) ! rc_local_touched "$(rc_local_file)" && [ ! -e "$(unit_file)" ] ;;
  esac
}

# autostart_set KIND: sets up the new kind before removing the old one.
autostart_set() {
  case $1 in
    rc.local) rc_local_put 1 && unit_remove ;;
    systemd) unit_put && rc_local_without_start ;;
    none) autostart_remove ;;
    *) return 1 ;;
  esac
}

# With a unit, rc.local is changed only if it starts another program for the robot.
rc_local_without_start() {
  file=$(rc_local_file)
  [ -f "$file" ] || return 0
  if rc_local_touched "$file" || [ -n "$(rc_local_others "$file")" ]; then
    rc_local_restore && if [ -f "$file" ] && [ -n "$(rc_local_others "$file")" ]; then rc_local_put 0; fi
  fi
}

unit_put() {
  # >>> transaction
  make_folder "$etc/systemd/system/multi-user.target.wants" || return
  printf '%s\n' "$text_unit" | put "$(unit_file)" || return
  point "$(unit_link)" "$(unit_file)" || return
  sync
  # <<< transaction
}

unit_remove() {
  [ -e "$(unit_file)" ] || [ -L "$(unit_link)" ] || return 0
  # >>> transaction
  rm -f "$(unit_link)"
  rm -f "$(unit_file)"
  # <<< transaction
  if [ -d /run/systemd/system ] && command -v systemctl >/dev/null 2>&1; then systemctl daemon-reload; fi
}

autostart_remove() {
  unit_remove && rc_local_restore
}

autostart_touched() { rc_local_touched "$(rc_local_file)" || [ -e "$(unit_file)" ] || [ -L "$(unit_link)" ]; }

autostart_leftovers() {
  rm -f "$(rc_local_file)".new-[0-9]* "$(unit_file)".new-[0-9]* "$(unit_link)".new-[0-9]*
}

# Notes for the user before the installation, appended to a message.
autostart_notes() {
  [ "$(autostart_wanted)" != none ] || return 0
  if [ "$(version_current)" != - ] && [ "$(autostart_kind)" = none ]; then
    printf '%s' ", $msg_autostart_again; --autostart none keeps it off"
  fi
  [ -f "$(rc_local_file)" ] || return 0
  others=$(rc_local_others "$(rc_local_file)")
  [ -z "$others" ] || printf '%s' "; disabled in $etc/rc.local: $others"
}

check_autostart() {
  [ "$(autostart_wanted)" = none ] || check_rc_local
}

# make_folder DIR: creates DIR and its parents; new folders are recorded, and uninstall removes them if empty.
make_folder() {
  [ -d "$1" ] || {
    make_folder "$(dirname "$1")" && mkdir -p "$1" && mkdir -p "$home/kept" && echo "$1" >>"$home/kept/made"
  }
}
