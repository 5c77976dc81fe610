# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# The switch from one version to another, for install and rollback. Cut at any line, either the old or the new version
# is what the next boot starts: `pending` says where to go back to until the self-test has passed.
# One command a line between the markers: the tests kill the program before each of them.

made_robot_ini=0
confirmed=0
keep_target=0  # 1: what was tried stays when it fails, as it lay there before

# switch_to NAME BEFORE AUTOSTART: both versions lie whole in versions/; BEFORE may be -.
switch_to() {
  target=$1 before=$2 kind=$3
  # >>> transaction
  bring_to_rest
  end_demo
  mkdir -p "$home/kept" || back_out "cannot write into $home"
  echo "$kind" | put "$home/kept/autostart" || back_out "cannot write into $home; is the disk full?"
  echo "$before" | put "$home/pending" || back_out "cannot write into $home; is the disk full?"
  place_start || back_out "cannot write $home/start; is the disk full?"
  place_robot_ini || back_out "cannot write $home/robot.ini; is the disk full?"
  sync
  point "$home/current" "versions/$target" || back_out "cannot change $home/current"
  sync
  self_test || back_out "the self-test of version $target failed: see above"
  echo "$before" | put "$home/previous" || back_out "cannot write into $home; is the disk full?"
  rm -f "$home/pending"
  sync
  confirmed=1
  # <<< transaction
  finish "$target" "$before" "$kind"
}

# finish NAME BEFORE AUTOSTART: what comes after the confirmation. Cut here, a rerun does it again.
finish() {
  target=$1 before=$2 kind=$3
  confirmed=1
  # >>> transaction
  place_start || back_out "cannot write $home/start; is the disk full?"
  make_user || back_out "the user $usual_user for controllers could not be made: see above"
  own_controllers
  echo "$kind" | put "$home/kept/autostart" || back_out "cannot write into $home; is the disk full?"
  autostart_set "$kind" || back_out "the autostart could not be set up"
  discard_others "$target" "$before"
  sync
  start_supervisor
  # <<< transaction
  say "version $target is installed and confirmed"
}

# back_out REASON: the version before comes back and runs; without one, the robot is as it was.
back_out() {
  say "$1"
  if [ "$before" = - ] || [ "$before" = "$target" ]; then
    [ "$before" != "$target" ] || die "version $target stays installed; mend this and install again"
    leave_nothing
    die "version $target is removed again; the robot is as before${demo_ended:+, but the ROBOTIS demo runs again only after the next start}"
  fi
  # >>> transaction
  point "$home/current" "versions/$before"
  sync
  rm -f "$home/pending"
  [ "$keep_target" = 1 ] || discard "$target"
  sync
  start_supervisor
  # <<< transaction
  die -4 "version $before is back"
}

# A first installation that failed. The order is that of uninstall: first what starts things.
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

# Only where there is none: the file is the user's. --port goes into the new one.
place_robot_ini() {
  [ ! -e "$home/robot.ini" ] || return 0
  made_robot_ini=1
  default_ini=$home/versions/$target/share/darwinop/robot.ini
  [ -s "$default_ini" ] && with_port "$port" <"$default_ini" | put "$home/robot.ini"
}

# with_port DEVICE <INI: sets the port, also where the line is commented out or missing.
with_port() {
  [ -n "$1" ] || { cat && return; }
  awk -v port="$1" 'function set() { print "port = " port; done = 1 }
    /^[ \t]*\[/ { if (here && !done) set(); here = ($0 ~ /^[ \t]*\[Robot\]/) }
    here && !done && /^[ \t;#]*port[ \t]*=/ { set(); next }
    { print }
    END { if (!done) { if (!here) print "[Robot]"; set() } }'
}
