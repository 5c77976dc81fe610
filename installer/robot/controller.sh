# shellcheck shell=sh
# Controllers on the robot: receive, make default, stop, logs. Run: controller_run.sh, controller_stop.sh.
#
# controllers/NAME is a link to .sent-XXXXXX/NAME, so that a controller is replaced atomically and a running one keeps
# its files.

need_runtime() {
  [ -x "$home/current/bin/darwinop-run" ] || die "darwinop is not installed on this robot. $msg_install_first"
}

# receive_controller NAME KILOBYTES CKSUM BYTES ARCHITECTURE <archive.tar.gz
receive_controller() {
  need_runtime
  [ "$5" = "$(installed_architecture)" ] ||
    die "$1 was built for $5, but the programs on this robot are for $(installed_architecture): run './dev build --robot=$(installed_architecture)' and send it again"
  lock
  controllers=$home/controllers
  mkdir -p "$controllers" || die "cannot create $controllers"
  tidy_controllers
  need_space "$2" $(($4 / 1024))
  staging=$(mktemp -d "$controllers/.staging-XXXXXX") || die "cannot write to $controllers"
  unpack_controller "$@" || {
    rm -rf "$staging"
    die "$1 was not changed"
  }
  sent=$controllers/.sent-${staging##*.staging-}
  { chmod 755 "$staging" && mv "$staging" "$sent"; } || die "cannot rename $staging; $1 was not changed"
  # A manually created folder is moved away.
  if [ -d "$controllers/$1" ] && [ ! -L "$controllers/$1" ]; then
    mv "$controllers/$1" "$controllers/$1.by-hand-$$" || die "cannot move $controllers/$1 away"
    say "$controllers/$1 was not created by darwinop install; renamed to $1.by-hand-$$"
  fi
  # All files are on the disk before the link names them: a power failure would leave an empty program.
  sync
  # The temporary name is hidden; controller names never are.
  { ln -s "${sent##*/}/$1" "$controllers/.link-$$" && mv -T -f "$controllers/.link-$$" "$controllers/$1"; } ||
    die "cannot link $controllers/$1; $1 was not changed"
  sync
  tidy_controllers
  say "$1 is installed, $2 kB"
}

# Into $staging. The archive is verified first: the connection may have been lost.
unpack_controller() { # NAME KILOBYTES CKSUM BYTES
  mkdir "$staging/$1" && cat >"$staging/.archive" || return 1
  [ "$(cksum <"$staging/.archive")" = "$3 $4" ] || {
    say "incomplete transfer: received $(wc -c <"$staging/.archive") of $4 bytes. Send it again"
    return 1
  }
  # -m: the robot's clock may be years behind.
  (cd "$staging/$1" && gzip -dc ../.archive | tar -xmof -) && rm "$staging/.archive" &&
    chmod -R a-s,u+rwX,go-w "$staging/$1" && own "$staging/$1" && [ -x "$staging/$1/$1" ]
}

# need_space KILOBYTES...: archive and files exist together while unpacking; a full disk also harms other programs.
need_space() {
  needed=20480
  for part in "$@"; do needed=$((needed + part)); done
  free=$(free_kb)
  [ "${free:-0}" -ge "$needed" ] ||
    die "the robot's $msg_disk_full: ${free:-0} kB are free, $needed kB are needed. Remove unused controllers from $home/controllers"
}

# Removes leftovers of interrupted transfers, and replaced controllers that do not run.
tidy_controllers() {
  rm -rf "$controllers"/.staging-* "$controllers"/.link-*
  for sent_before in "$controllers"/.sent-*; do
    [ -d "$sent_before" ] || continue
    is_linked "${sent_before##*/}" || is_in_use "$sent_before" || rm -rf "$sent_before"
  done
}

is_linked() { # .sent-XXXXXX
  for link in "$controllers"/*; do
    case $(readlink "$link") in "$1"/*) return 0 ;; esac
  done
  return 1
}

# shellcheck disable=SC2010  # names under /proc are numbers
is_in_use() { # FOLDER; /proc has real paths, and /opt may be a link
  ls -l /proc/[0-9]*/exe /proc/[0-9]*/cwd 2>/dev/null | grep -qF -e "-> $(cd "$1" && pwd -P)/"
}

supervisor() { "$home/current/bin/darwinop-supervisor" "$@"; }
supervisor_runs() { supervisor --status >/dev/null 2>&1; }

# make_default NAME: starts NAME at every boot.
make_default() {
  need_runtime
  lock
  [ -x "$home/controllers/$1/$1" ] || die "controller $1 is not on this robot; send it with --controller"
  point "$home/default" "controllers/$1" || die "cannot link $home/default; the default controller is unchanged"
  sync
  say "$1 is the default controller now: it $msg_every_boot"
  say "at boot it starts only in the start pose; otherwise the robot does not move and the log (--logs) has the reason"
  if is_running; then
    say "$(sed -n 3p "$home/running") keeps running; $1 starts at the next boot"
  elif driver=$(robot_driver) && [ -n "$driver" ] && is_from_elsewhere "$driver"; then
    say "$msg_window_drives (process $driver) and continues; $1 starts at the next boot"
  elif supervisor_runs; then
    say "starting it now: keep clear of the robot"
    supervisor --restart-controller || die "cannot start $1; see --logs, or restart the robot"
  else
    say "no supervisor runs on the robot; $1 starts at the next boot"
  fi
}

# make_no_default: nothing starts at boot. A controller started by --run continues.
make_no_default() {
  need_runtime
  lock
  before=$(readlink "$home/default") || {
    say "$msg_no_default; $msg_nothing_to_do"
    return
  }
  rm -f "$home/default" || die "cannot remove $home/default; the default controller is unchanged"
  sync
  say "${before##*/} no longer starts at boot; it stays on the robot"
  if supervisor_runs && ! is_running; then
    supervisor --stop-controller || die "cannot stop it. Hold the robot and press MODE briefly"
  fi
}

# Stops whatever drives: the default controller, one started by --run, a window, a program started on the robot itself.
# Not an error if none runs. Afterwards nothing drives, or this fails.
stop_controllers() {
  need_runtime
  stop_sent_controller
  stop_driving_window
  if supervisor_runs; then
    supervisor --stop-controller || die "cannot stop the default controller. Hold the robot and press MODE briefly"
    say "the default controller is stopped; it starts again at the next boot"
  fi
  stop_other_driver
}

# show_logs FOLLOW: prints both logs with their names. FOLLOW = 1: until stdin ends.
show_logs() {
  need_runtime
  for log in controller supervisor; do
    if [ "$1" = 1 ] || [ -f "$home/log/$log.log" ]; then set -- "$@" "$home/log/$log.log"; fi
  done
  [ $# -gt 1 ] || die "$msg_no_log: nothing has been started since the installation"
  follow=$1
  shift
  if [ "$follow" = 0 ]; then
    tail -n 200 "$@"
    return
  fi
  exec 3<&0 </dev/null
  # -F follows log rotation.
  tail -n 200 -F "$@" 3<&- &
  tail_pid=$!
  while read -r _; do :; done <&3
  kill "$tail_pid"
}
