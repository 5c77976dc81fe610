# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Taking everything away again, also what a killed installation left.

uninstall() {
  settings "$@"
  autostart_touched || [ -e "$home" ] || { say "nothing is installed on this robot; nothing to do" && return; }
  if [ "$dry_run" = 1 ]; then
    say "would remove $home ($(du -s -k "$home" 2>/dev/null | cut -f 1) kB, with robot.ini, controllers and logs)"
    ! autostart_touched || say "would take the autostart ($(autostart_kind)) away and restore $etc/rc.local"
    return
  fi
  lock
  [ ! -f "$home/kept/autostart" ] || say "removing version $(version_current)"
  show_own_settings
  # >>> transaction
  bring_to_rest
  autostart_leftovers
  autostart_remove || die "the autostart could not be taken away; nothing else was removed, try again"
  sync
  rm -f "$home/start"
  rm -f "$home/current"
  rm -f "$home/default"
  rm -rf "$home/versions"
  rm -rf "$home/controllers"
  rm -rf "$home/log"
  remove_all
  # <<< transaction
  say "everything is removed; the robot is as before the installation"
}

# Offsets take an evening to find: what somebody wrote into robot.ini is said before it goes.
show_own_settings() {
  own=$(grep -v -x -F -f "$home/current/share/darwinop/robot.ini" "$home/robot.ini" 2>/dev/null) || return 0
  say "robot.ini goes, too. These lines of it were not as delivered; copy them if you need them again:"
  printf '%s\n' "$own" | sed 's/^/    /' >&2
}

# The rest, the list of folders that we made last of all.
remove_all() {
  remove_user
  made=$(cat "$home/kept/made" 2>/dev/null) || made=
  for rest in "$home"/* "$home"/.[!.]* "$home"/kept/*; do
    case $rest in "$home/kept" | "$home/kept/made" | "$home/lock") ;; *) rm -rf "$rest" ;; esac
  done
  rmdir_made "$made"
  rm -rf "$home/kept"
  # The lock last, and only an empty folder after it: another installation may begin at once.
  rm -f "$home/lock"
  rmdir "$home" 2>/dev/null
  rmdir_made "$made"
  sync
}

# The deepest first, as they were made from the top. Folders with something of others in them stay.
rmdir_made() {
  printf '%s\n' "$1" | sed '1!G;h;$!d' | while IFS= read -r folder; do
    [ -z "$folder" ] || rmdir "$folder" 2>/dev/null
  done
  return 0
}

# Where nothing came to be installed, nothing of us stays: called when the lock is given back.
tidy() {
  [ "$(version_current)" = - ] && [ ! -e "$home/start" ] && [ ! -e "$home/pending" ] && ! autostart_touched || return 0
  rmdir "$home/versions" "$home/controllers" 2>/dev/null
  for rest in "$home"/* "$home"/.[!.]*; do
    case ${rest##*/} in kept | lock | '*' | '.[!.]*') ;; *) return 0 ;; esac
  done
  remove_all
}
