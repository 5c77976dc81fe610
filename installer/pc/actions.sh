# shellcheck shell=sh disable=SC2154  # variables are shared with the other files
# Actions of the command: calls of functions on the robot.

robot_settings() { quote force="$force" without_robot="$without_robot" port="$port" autostart="$autostart" dry_run="$dry_run"; }

# on_robot FUNCTION [WORDS]: passes the settings as arguments; WORDS are quoted for eval.
on_robot() {
  robot_function=$1
  eval "set -- $(robot_settings)${2:-}"
  robot_run "$robot_function" "$@"
}

install_on_robot() {
  phase_count=$((5 - 2 * dry_run))
  phase "reading the archive"
  if [ -n "$bundle" ]; then open_bundle; else expect_bundle; fi
  connect
  [ -n "$bundle" ] || { find_bundle && open_bundle; }
  say "version $version for $architecture ($((archive_bytes / 1024)) kB) for $target"
  phase "checking the robot"
  status=0
  on_robot preflight "$(bundle_settings)" </dev/null || status=$?
  [ "$status" != 10 ] || exit 0
  end_unless_well "$status"
  if [ "$dry_run" = 1 ]; then
    say "all checks passed; without --dry-run version $version would be installed into /opt/darwinop/versions"
    exit 0
  fi
  status=0
  changing=1
  phase "sending $archive_kb kB"
  send_with_progress "$bundle" "$archive_bytes" "switching over on the robot" | on_robot install_bundle "$(bundle_settings)" || status=$?
  end_unless_well "$status"
}

other_action() {
  phase_count=2
  connect
  phase "$action on the robot"
  [ "$action" = status ] || [ "$dry_run" = 1 ] || changing=1
  status=0
  on_robot "$1" </dev/null || status=$?
  end_unless_well "$status"
}

# The robot's program reports its own exit codes; the others are reported here.
end_unless_well() {
  case $1 in
    0) return ;;
    1 | 3 | 4 | 5) exit "$1" ;;
    255) die "the connection to $target $msg_lost; the robot completes the present step and runs either the old or the new version. Check with --status, then try again" ;;
    *) die "the program on $target was interrupted (status $1); the robot runs either the old or the new version. Run the same command again to complete it" ;;
  esac
}
