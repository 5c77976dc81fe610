# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# The PC that drives this robot: its heartbeats, its answers, and what ends when it has gone.

remote_link=    # folder for communication between the parts
remote_leave=0  # 1: the PC has disconnected, or SIGTERM
remote_ears='' remote_watch=''

# From here on any end also ends the server and reports the robot's state.
attend_pc() {
  trap 'end_remote' EXIT
  trap 'leave_remote' TERM INT
  remote_link=$(mktemp -d /dev/shm/darwinop-remote-XXXXXX 2>/dev/null || mktemp -d) || die "cannot create a temporary folder"
  read_heartbeats &
  remote_ears=$!
  watch_pc &
  remote_watch=$!
  exec 3<&-
}

read_heartbeats() {
  exec <&3 3<&- >/dev/null
  trap - TERM INT
  count=0
  while IFS= read -r line; do
    count=$((count + 1))
    echo "$count" >"$remote_link/beats"
    [ -z "$line" ] || { echo "$line" >"$remote_link/answer.new" && mv -f "$remote_link/answer.new" "$remote_link/answer"; }
  done
  kill -TERM $$ 2>/dev/null
}

# An unplugged cable does not close the connection.
watch_pc() {
  exec 3<&- >/dev/null
  trap - TERM INT
  quiet_s=0 last=
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    seen=
    read -r seen 2>/dev/null <"$remote_link/beats"
    if [ "$seen" = "$last" ]; then quiet_s=$((quiet_s + 1)); else quiet_s=0 last=$seen; fi
    [ "$quiet_s" -lt "$patience_s" ] || {
      say "no heartbeat from the PC for $patience_s s: stopping"
      kill -TERM $$
      return
    }
  done
  rm -rf "$remote_link"
}

# On SIGTERM: runs after the foreground command, so the present step is completed.
leave_remote() {
  remote_leave=1
  [ -z "$remote_server" ] || end_server
}

end_if_requested() { [ "$remote_leave" = 0 ] || exit 130; }

ask_pc() { # QUESTION -> answer
  rm -f "$remote_link/answer"
  echo "$1"
  until [ -s "$remote_link/answer" ]; do
    end_if_requested
    nap
  done
  read -r answer <"$remote_link/answer"
}
