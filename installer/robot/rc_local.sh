# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Adds our block to /etc/rc.local and removes it again, byte for byte. Files in $home/kept:
#   rc.local.original   original, with mode, owner and time      rc.local.absent   no original
#   rc.local.ours       written version                          rc.local.next     version to be written

# Target of the link, even if it does not exist yet.
rc_local_file() { readlink -f "$etc/rc.local" || echo "$etc/rc.local"; }

rc_local_is_ours() { cmp -s "$1" "$home/kept/rc.local.ours" || cmp -s "$1" "$home/kept/rc.local.next"; }

# rc_local_put STARTS: updates the block. Writes nothing if it is up to date.
rc_local_put() {
  file=$(rc_local_file)
  kept=$home/kept
  mkdir -p "$kept" || return
  # >>> transaction
  rc_local_keep || return
  rc_local_new "$1" >"$kept/rc.local.new-$$" || return
  mv -f "$kept/rc.local.new-$$" "$kept/rc.local.next" || return
  cmp -s "$kept/rc.local.next" "$file" && [ -x "$file" ] || rc_local_replace || return
  mv -f "$kept/rc.local.next" "$kept/rc.local.ours" || return
  # <<< transaction
}

# Saves the original; saves it again if the file was edited since.
rc_local_keep() {
  if rc_local_is_ours "$file" && { [ -f "$kept/rc.local.original" ] || [ -f "$kept/rc.local.absent" ]; }; then return; fi
  if [ ! -e "$file" ]; then
    rm -f "$kept/rc.local.original"
    : >"$kept/rc.local.absent"
    return
  fi
  was_executable=1
  [ -x "$file" ] || was_executable=0
  cp -p "$file" "$kept/rc.local.new-$$" || return
  if rc_local_touched "$file"; then
    rc_local_without "$file" >"$kept/rc.local.new-$$" || return
    if [ -f "$kept/rc.local.original" ] && [ ! -x "$kept/rc.local.original" ]; then was_executable=0; fi
  fi
  [ "$was_executable" = 1 ] || chmod a-x "$kept/rc.local.new-$$" || return
  mv -f "$kept/rc.local.new-$$" "$kept/rc.local.original" && rm -f "$kept/rc.local.absent" && sync
}

rc_local_new() {
  if [ -f "$kept/rc.local.absent" ]; then
    rc_local_with /dev/null "$1" 1
  elif [ -x "$kept/rc.local.original" ]; then
    rc_local_with "$kept/rc.local.original" "$1" 1
  else
    rc_local_with "$kept/rc.local.original" "$1" 0
  fi
}

# Atomic replacement with the same owner; executable, otherwise it does not run at boot.
rc_local_replace() {
  if [ -e "$file" ]; then cp -p "$file" "$file.new-$$" || return; fi
  cat "$kept/rc.local.next" >"$file.new-$$" && chmod a+rx "$file.new-$$" && sync && mv -f "$file.new-$$" "$file" && sync
}

# rc_local_restore: restores the original, or removes only our changes if the file was edited since.
rc_local_restore() {
  file=$(rc_local_file)
  kept=$home/kept
  if [ ! -f "$file" ] || ! rc_local_touched "$file"; then
    rm -f "$kept"/rc.local.*
    return 0
  fi
  # >>> transaction
  rm -f "$file".new-[0-9]*
  rc_local_original >"$kept/rc.local.how" || return
  [ ! -f "$file.new-$$" ] || sync
  if [ -f "$file.new-$$" ]; then mv -f "$file.new-$$" "$file"; else rm -f "$file"; fi
  sync
  say "$(cat "$kept/rc.local.how")"
  rm -f "$kept"/rc.local.*
  # <<< transaction
}

# Creates FILE.new-PID, or no file if there was none before; prints what was done.
rc_local_original() {
  if rc_local_is_ours "$file" && [ -f "$kept/rc.local.absent" ]; then
    echo "$etc/rc.local removed: it did not exist before"
  elif rc_local_is_ours "$file" && [ -f "$kept/rc.local.original" ]; then
    cp -p "$kept/rc.local.original" "$file.new-$$" || return
    echo "$etc/rc.local restored, byte for byte"
  else
    cp -p "$file" "$file.new-$$" && rc_local_without "$file" >"$file.new-$$" || return
    if [ -f "$kept/rc.local.original" ] && [ ! -x "$kept/rc.local.original" ]; then chmod a-x "$file.new-$$"; fi
    echo "$etc/rc.local was edited since the installation: only our changes are removed"
  fi
}

# Problems, checked before any change.
check_rc_local() {
  file=$(rc_local_file)
  [ -d "$(dirname "$file")" ] || { problem "$etc/rc.local points to $file, which cannot be created" && return; }
  [ -e "$file" ] || return 0
  [ -f "$file" ] || { problem "$etc/rc.local is not a file; correct it, or use --autostart none" && return; }
  rc_text=$(rc_local_without "$file")
  opening=$(printf '%s\n' "$rc_text" | sed -n '1{s/\r$//;p;}')
  case $opening in
    '#!'*sh | '#!'*'sh '*) ;;
    '#!'*) problem "$etc/rc.local is not a shell script ($opening); use --autostart none and start /opt/darwinop/start from it" ;;
  esac
  if sh -n "$file" 2>/dev/null && ! printf '%s\n' "$rc_text" | rc_local_disable | sh -n 2>/dev/null; then
    problem "$etc/rc.local starts another program for the robot in a way that cannot be disabled without breaking the file; put '#' before that line and install again: $(rc_local_others "$file")"
  fi
}
