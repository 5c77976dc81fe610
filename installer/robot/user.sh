# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# User account of controllers, remote server and monitor, and the group with access to the runtime
# (docs/run-on-the-robot.md). $home/kept/user lists which of the two we created; uninstall removes only those.

usual_user=darwinop

# robot_setting KEY: from [Robot] of robot.ini; empty if missing.
robot_setting() {
  awk -v key="$1" '{ sub(/\r$/, "") } /^[ \t]*\[/ { here = (tolower($0) ~ /^[ \t]*\[robot\]/) }
    here && tolower($0) ~ "^[ \t]*" key "[ \t]*[=:]" { sub(/^[^=:]*[=:][ \t]*/, ""); sub(/[ \t]*[;#].*$/, ""); sub(/[ \t]*$/, ""); gsub(/^"|"$/, ""); print; exit }' \
    "$home/robot.ini" 2>/dev/null
}

user_exists() { grep -q "^$1:" "$etc/passwd"; }
group_exists() { grep -q "^$1:" "$etc/group"; }

# User that runs controllers; empty: root.
controller_user() {
  named=$(robot_setting controller_user)
  named=${named:-$usual_user}
  if [ "$named" != root ] && user_exists "$named"; then echo "$named"; fi
}

has_useradd() { command -v useradd >/dev/null 2>&1 && command -v groupadd >/dev/null 2>&1; }

# make_user: idempotent. Does nothing if robot.ini names a user.
make_user() {
  [ -z "$(robot_setting controller_user)" ] || return 0
  if user_exists $usual_user && group_exists $usual_user; then return 0; fi
  mkdir -p "$home/kept" || return
  [ -f "$home/kept/user" ] || {
    group_exists $usual_user || echo group
    user_exists $usual_user || echo user
  } | put "$home/kept/user" || return
  # Groups of camera, sound and keyboard devices.
  devices=
  for group in video audio input; do
    if group_exists $group; then devices="$devices,$group"; fi
  done
  if has_useradd; then make_user_with_tools; else make_user_by_hand; fi || return
  say "$msg_created_user $usual_user: controllers, remote server and monitor run as it, not as root"
  return 0  # even if the message cannot be written because the PC has disconnected
}

make_user_with_tools() {
  group_exists $usual_user || groupadd -r $usual_user || return
  user_exists $usual_user || useradd -r -M -d /nonexistent -s /bin/false -c 'darwinop-rt controllers' -g $usual_user \
    ${devices:+-G "${devices#,}"} $usual_user
}

# For systems without useradd. '*' disables the password, so no line in /etc/shadow is needed.
make_user_by_hand() {
  id=999
  while grep -q "^[^:]*:[^:]*:$id:" "$etc/passwd" "$etc/group"; do id=$((id - 1)); done
  if group_exists $usual_user; then
    id_of_group=$(sed -n "s/^$usual_user:[^:]*:\([0-9]*\):.*/\1/p" "$etc/group")
  else
    id_of_group=$id
    # Complete before it is written: in a pipe, `put` would not see that awk has failed.
    lines=$(awk -F: -v OFS=: -v devices="$devices," -v user=$usual_user '
      index(devices, "," $1 ",") { $4 = $4 ($4 == "" ? "" : ",") user } { print }' "$etc/group") || return
    printf '%s\n' "$lines" "$usual_user:x:$id:" | put "$etc/group" || return
  fi
  user_exists $usual_user && return
  lines=$(cat "$etc/passwd") || return
  printf '%s\n' "$lines" "$usual_user:*:$id:$id_of_group:darwinop-rt controllers:/nonexistent:/bin/false" | put "$etc/passwd"
}

# Removes only what we created.
remove_user() {
  [ -f "$home/kept/user" ] || return 0
  for made in user group; do
    if ! grep -q -x $made "$home/kept/user" || ! "${made}_exists" $usual_user; then continue; fi
    # userdel also removes the group of the same name.
    if has_useradd; then "${made}del" $usual_user >/dev/null 2>&1; else remove_by_hand $made; fi ||
      say "cannot remove the $made $usual_user; end its processes, then run: sudo ${made}del $usual_user"
  done
  rm -f "$home/kept/user"
}

remove_by_hand() { # user|group
  case $1 in
    user) base=passwd lines=$(sed "/^$usual_user:/d" "$etc/passwd") || return ;;
    group) base=group lines=$(sed "/^$usual_user:/d; s/,$usual_user\$//; s/:$usual_user\$/:/" "$etc/group") || return ;;
  esac
  printf '%s\n' "$lines" | put "$etc/$base"
}

# own FOLDER: changes the owner of FOLDER and its contents to the controller's user. Other users must have no access
# meanwhile: a link to a file of root could be inserted.
own() {
  owner=$(controller_user)
  [ -z "$owner" ] || chown -R -h "$owner:" "$1"
}

# Controllers received by an older version belong to root.
own_controllers() {
  [ -n "$(controller_user)" ] || return 0
  for sent in "$home"/controllers/.sent-*; do
    if [ ! -d "$sent" ] || [ -L "$sent" ]; then continue; fi
    for folder in "$sent"/*; do
      # shellcheck disable=SC2012  # a number in the third column
      if [ ! -d "$folder" ] || [ -L "$folder" ] || [ "$(ls -l -d -n "$folder" | awk '{ print $3 }')" != 0 ]; then continue; fi
      chmod 700 "$sent"
      own "$folder"
      chmod 755 "$sent"
    done
  done
  return 0
}
