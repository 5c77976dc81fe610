# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Status of the installation, and rollback.

status() {
  settings "$@"
  now=$(version_current)
  if [ "$now" = - ] && [ ! -e "$home" ]; then
    echo "version:    none; $msg_nothing_installed"
    return
  fi
  if [ -e "$home/pending" ]; then
    echo "version:    $now ($msg_not_confirmed; the next start returns to $(sed 's/^-$/none/' "$home/pending"))"
  elif [ "$now" = - ]; then
    echo "version:    none (an installation was interrupted; run it again, or uninstall)"
  else
    echo "version:    $now (confirmed)"
  fi
  echo "previous:   $(version_previous | sed 's/^-$/none/')"
  echo "autostart:  $(autostart_kind)"
  echo "supervisor: $(supervisor_state)"
  echo "controller: $(readlink "$home/default" 2>/dev/null | sed 's|.*/||' | grep . || echo none)"
  ! is_running || echo "running:    $(sed -n 3p "$home/running")"
  echo "port:       $(robot_port)"
  echo "disk:       $(du -s -k "$home" | cut -f 1) kB used, $(free_kb) kB free"
  if [ -e "$home/lock" ]; then
    if lock_alive "$(cat "$home/lock")"; then echo "lock:       an installation is running"; else echo "lock:       an installation was interrupted; run it again"; fi
  fi
}

supervisor_state() {
  if [ ! -x "$home/current/bin/darwinop-supervisor" ]; then
    echo none
  else
    "$home/current/bin/darwinop-supervisor" --status 2>&1 </dev/null | sed 's/^supervisor: *//; 2,$s/^/            /'
  fi
}

# roll_back SETTINGS...: switches to the previous version with the steps of an installation. Repeated: switches back,
# unless the first time left a version under test.
roll_back() {
  settings "$@"
  keep_target=1
  if [ ! -e "$home" ]; then die "$msg_nothing_installed on this robot, so there is no previous version"; fi
  target=$(version_previous) before=$(version_current)
  # The version under test is replaced by the confirmed one; no failure may return to what is untested.
  if [ -s "$home/pending" ]; then target=$(cat "$home/pending") before=$target; fi
  if [ "$target" = - ]; then die "there is no previous version; only $(version_current) is installed"; fi
  whole "$home/versions/$target" || die "version $target is damaged; nothing was changed. Install the desired version instead"
  if [ "$dry_run" = 1 ]; then say "would return from $(version_current) to $target" && return; fi
  lock
  remove_leftovers
  kind=$(autostart_wanted)
  say "returning from $(version_current) to $target"
  switch_to "$target" "$before" "$kind"
}
