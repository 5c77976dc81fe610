# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Installation: check, receive the archive, switch, test, confirm. After every step a complete version can start.

# preflight SETTINGS...: status 0 continue, 1 rejected, 5 another installation runs, 10 nothing to do.
preflight() {
  settings "$@"
  lock_alive "$(cat "$home/lock" 2>/dev/null)" &&
    die -5 "$msg_other_install (process $(cut -d ' ' -f 1 "$home/lock")); wait until it has ended"
  find_problems
  [ "$problems" = 0 ] || die "nothing was changed"
  say "$(uname -m), $(system_name)kernel $(uname -r), $(free_kb) kB free, serial port $(robot_port), installed: $(version_current)"
  if is_done; then
    say "version $version $msg_confirmed; $msg_nothing_to_do"
    exit 10
  fi
  say "autostart by $(autostart_wanted)$(autostart_notes)"
}

# True if this build is installed and confirmed, and no later step was interrupted.
is_done() {
  target=$(folder_for "$version" "$manifest")
  [ "$(version_current)" = "$target" ] && [ ! -e "$home/pending" ] && [ ! -e "$home/lock" ] && [ -x "$home/start" ] &&
    whole "$home/versions/$target" && autostart_is "$(autostart_wanted)" &&
    { [ -n "$(robot_setting controller_user)" ] || user_exists "$usual_user"; }
}

# install_bundle SETTINGS... <ARCHIVE
install_bundle() {
  settings "$@"
  lock
  remove_leftovers
  find_problems
  [ "$problems" = 0 ] || die "nothing was changed"
  # Determined now: later steps check for files that these steps create.
  kind=$(autostart_wanted)
  target=$(folder_for "$version" "$manifest")
  if [ "$(version_current)" = "$target" ] && [ ! -e "$home/pending" ] && whole "$home/versions/$target"; then
    confirmed=1
    # A supervisor that runs already would keep another kind of autostart from starting its own.
    [ "$(autostart_kind)" = "$kind" ] || bring_to_rest
    finish "$target" "$(version_previous)" "$kind"
    return
  fi
  before=$(version_confirmed)
  # Over a version under test: a failure returns to the confirmed one.
  [ "$before" != "$target" ] || [ -s "$home/pending" ] || before=$(version_previous)
  whole "$home/versions/$target" 2>/dev/null || stage "$target"
  switch_to "$target" "$before" "$kind"
}

# stage NAME: unpacks the archive from stdin to versions/NAME: verified first, renamed last.
stage() {
  staging=$home/versions/.staging-$$
  mkdir -p "$home/kept" "$staging/unpacked" || undo_stage "cannot make $staging"
  cat >"$staging/archive.tar.gz" || undo_stage "cannot write the archive; is the disk full?"
  check_archive "$staging/archive.tar.gz"
  # -m: the robot's clock may be years behind.
  gzip -dc "$staging/archive.tar.gz" | (cd "$staging/unpacked" && tar -xmof -) || undo_stage "cannot unpack the archive; is the disk full?"
  reject_unlisted "$staging/archive.tar.gz" "$staging/unpacked"
  # Only root may change programs; no setuid bits.
  chmod -R a-s,u+rwX,go-w,go+rX "$staging/unpacked" || undo_stage "cannot set the rights of the unpacked files"
  whole "$staging/unpacked" || undo_stage "the unpacked files are not what MANIFEST says; is the disk full or worn?"
  rm -f "$staging/archive.tar.gz"
  # An existing folder with this name is incomplete.
  discard "$1"
  sync
  mv -T "$staging/unpacked" "$home/versions/$1" || undo_stage "cannot rename $staging/unpacked"
  rmdir "$staging"
  sync
}

check_archive() {
  bytes=$(wc -c <"$1" | tr -d ' ')
  [ "$bytes" = "$archive_bytes" ] || undo_stage "the connection ended after $bytes of $archive_bytes bytes"
  if [ "$sha256" != - ] && command -v sha256sum >/dev/null 2>&1; then
    digest=$(sha256sum <"$1" | cut -d ' ' -f 1) wanted=$sha256
  else
    digest=$(cksum <"$1" | cut -d ' ' -f 1) wanted=$cksum
  fi
  [ "$digest" = "$wanted" ] || undo_stage "the archive came in damaged (digest $digest instead of $wanted)"
}

# reject_unlisted ARCHIVE FOLDER: rejects files that MANIFEST does not list, and anything but regular files.
reject_unlisted() {
  unlisted=$(gzip -dc "$1" | tar -tf - | awk -v manifest="$2/MANIFEST" '
    BEGIN { while ((getline line <manifest) > 0) { sub(/^[0-9]* [0-9]* /, "", line); known[line] = 1 }; known["MANIFEST"] = 1 }
    { sub(/^\.\//, "") } /\/$/ || $0 == "" || $0 == "." { next } !($0 in known) { print; exit }')
  [ -z "$unlisted" ] || undo_stage "the archive contains $unlisted, $msg_not_in_manifest; rebuild it with './dev build --robot'"
  unlisted=$(cd "$2" && sed 's/^[0-9]* [0-9]* //' MANIFEST | while IFS= read -r path; do
    case /$path/ in */../*) echo "$path" ;; esac
    { [ -f "$path" ] && [ ! -L "$path" ]; } || echo "$path"
  done | sed -n 1p)
  [ -z "$unlisted" ] || undo_stage "$unlisted in the archive is missing or $msg_not_regular; rebuild it with './dev build --robot'"
}

undo_stage() {
  rm -rf "$staging"
  die "$1; nothing was changed, try again"
}
