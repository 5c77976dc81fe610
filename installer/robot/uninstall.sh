# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Uninstallation, including leftovers of an interrupted installation.

uninstall() {
  settings "$@"
  autostart_touched || [ -e "$home" ] || { say "$msg_nothing_installed on this robot; $msg_nothing_to_do" && return; }
  if [ "$dry_run" = 1 ]; then
    say "would remove $home ($(du -s -k "$home" 2>/dev/null | cut -f 1) kB, with robot.ini, controllers and logs)"
    ! autostart_touched || say "would remove the autostart ($(autostart_kind)) and restore $etc/rc.local"
    return
  fi
  lock
  [ ! -f "$home/kept/autostart" ] || say "removing version $(version_current)"
  show_own_settings
  # >>> transaction
  bring_to_rest
  autostart_leftovers
  autostart_remove || die "cannot remove the autostart; nothing else was removed, try again"
  sync
  rm -f "$home/start"
  rm -f "$home/current"
  rm -f "$home/default"
  rm -rf "$home/versions"
  rm -rf "$home/controllers"
  rm -rf "$home/log"
  remove_all
  # <<< transaction
  say "everything removed; the robot is as before the installation"
}

# Prints changed settings of robot.ini before removing it: offsets are laborious to determine.
show_own_settings() {
  [ -s "$home/robot.ini" ] || return 0
  if [ -f "$home/current/share/darwinop/robot.ini" ]; then
    own=$(grep -v -x -F -f "$home/current/share/darwinop/robot.ini" "$home/robot.ini") || return 0
  else
    own=$(cat "$home/robot.ini")  # no defaults to compare with: an installation was interrupted
  fi
  say "removing robot.ini. These lines $msg_differ; copy them if you need them again:"
  printf '%s\n' "$own" | sed 's/^/    /' >&2
}

# Everything else; the list of created folders last.
remove_all() {
  remove_user
  made=$(cat "$home/kept/made" 2>/dev/null) || made=
  for rest in "$home"/* "$home"/.[!.]* "$home"/kept/*; do
    case $rest in "$home/kept" | "$home/kept/made" | "$home/lock") ;; *) rm -rf "$rest" ;; esac
  done
  rmdir_made "$made"
  rm -rf "$home/kept"
  # The lock last, followed only by an empty folder: another installation may start at once.
  rm -f "$home/lock"
  rmdir "$home" 2>/dev/null
  rmdir_made "$made"
  sync
}

# Deepest first. Folders with other content stay.
rmdir_made() {
  printf '%s\n' "$1" | sed '1!G;h;$!d' | while IFS= read -r folder; do
    [ -z "$folder" ] || rmdir "$folder" 2>/dev/null
  done
  return 0
}

# Called at the release of the lock: removes our folders if nothing was installed.
tidy() {
  [ "$(version_current)" = - ] && [ ! -e "$home/start" ] && [ ! -e "$home/pending" ] && ! autostart_touched || return 0
  rmdir "$home/versions" "$home/controllers" 2>/dev/null
  for rest in "$home"/* "$home"/.[!.]*; do
    case ${rest##*/} in kept | lock | '*' | '.[!.]*') ;; *) return 0 ;; esac
  done
  remove_all
}
