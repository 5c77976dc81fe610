# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Switch between versions, for install and rollback. Interrupted at any line, the next boot starts either the old or the
# new version: `pending` names the version to return to until the self-test has passed.
# One command per line between the markers: the tests kill the program before each of them.

made_robot_ini=0
confirmed=0    # 1: the target was confirmed before this run and may drive the robot: nothing is taken back
keep_target=0  # 1: the version under test stays installed if it fails, since it existed before

# switch_to NAME BEFORE AUTOSTART: both versions are complete in versions/; BEFORE may be -, or NAME if
# it replaces a version under test.
switch_to() {
  target=$1 before=$2 kind=$3
  # >>> transaction
  bring_to_rest
  end_other_programs
  mkdir -p "$home/kept" || back_out "cannot write into $home"
  echo "$kind" | put "$home/kept/autostart" || back_out "cannot write to $home; check for a full disk"
  echo "$before" | put "$home/pending" || back_out "cannot write to $home; check for a full disk"
  place_start || back_out "cannot write $home/start; is the disk full?"
  place_robot_ini || back_out "cannot write $home/robot.ini; is the disk full?"
  sync
  point "$home/current" "versions/$target" || back_out "cannot change $home/current"
  sync
  self_test || back_out "the self-test of version $target failed: see above"
  still_pending || back_out "$msg_started_meanwhile"
  # A confirmed version that replaces one under test keeps its own.
  [ "$before" = "$target" ] || echo "$before" | put "$home/previous" || back_out "cannot write to $home; check for a full disk"
  rm -f "$home/pending"
  sync
  # <<< transaction
  finish "$target" "$before" "$kind"
}

# False if $home/start ran during the self-test and took the version back.
still_pending() { [ -s "$home/pending" ] && [ "$(version_current)" = "$target" ]; }

# finish NAME BEFORE AUTOSTART: steps after the confirmation. If interrupted, a rerun repeats them.
finish() {
  target=$1 before=$2 kind=$3
  # >>> transaction
  place_start || back_out "cannot write $home/start; is the disk full?"
  make_user || back_out "the user $usual_user for controllers could not be made: see above"
  own_controllers
  echo "$kind" | put "$home/kept/autostart" || back_out "cannot write to $home; check for a full disk"
  autostart_set "$kind" || back_out "the autostart could not be set up"
  discard_others "$target" "$(version_previous)"
  sync
  end_other_programs
  start_supervisor
  # <<< transaction
  say "version $target $msg_confirmed"
}

# back_out REASON: restores and starts the previous version; without one, removes everything.
back_out() {
  say "$1"
  [ "$confirmed" = 0 ] || die "version $target $msg_stays; correct this and install it again"
  if [ "$before" = - ]; then
    leave_nothing
    die "version $target removed; the robot is as before${others_ended:+, but what was ended runs again only after the next boot}"
  fi
  # >>> transaction
  point "$home/current" "versions/$before"
  sync
  rm -f "$home/pending"
  [ "$keep_target" = 1 ] || [ "$before" = "$target" ] || discard "$target"
  sync
  start_supervisor
  # <<< transaction
  die -4 "reverted to version $before"
}

# Undoes a failed first installation in the order of uninstall: autostart first.
leave_nothing() {
  # >>> transaction
  autostart_remove
  rm -f "$home/current"
  rm -f "$home/start"
  rm -f "$home/pending"
  rm -f "$home/previous"
  [ "$made_robot_ini" = 0 ] || rm -f "$home/robot.ini"
  discard "$target"
  # <<< transaction
}

place_start() {
  [ -x "$home/start" ] && [ "$(cat "$home/start")" = "$text_start" ] && return
  printf '%s\n' "$text_start" | put "$home/start" 755
}

# Created only if missing: the file belongs to the user. --port is written to a new one.
place_robot_ini() {
  [ ! -e "$home/robot.ini" ] || return 0
  made_robot_ini=1
  default_ini=$home/versions/$target/share/darwinop/robot.ini
  [ -s "$default_ini" ] && with_port "$port" <"$default_ini" | put "$home/robot.ini"
}

# with_port DEVICE <INI: sets the port, even if the line is commented out or missing.
with_port() {
  [ -n "$1" ] || { cat && return; }
  awk -v port="$1" 'function set() { print "port = " port; done = 1 }
    /^[ \t]*\[/ { if (here && !done) set(); here = ($0 ~ /^[ \t]*\[Robot\]/) }
    here && !done && /^[ \t;#]*port[ \t]*=/ { set(); next }
    { print }
    END { if (!done) { if (!here) print "[Robot]"; set() } }'
}
