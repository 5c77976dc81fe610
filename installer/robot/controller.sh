# shellcheck shell=sh
# Controllers on the robot: receiving one, making it the default, stopping what runs, logs. Running: controller_run.sh.
#
# controllers/NAME is a link to .sent-XXXXXX/NAME, so that a new one takes the old one's place in one step, and what
# runs keeps its files until it has ended.

need_runtime() {
  [ -x "$home/current/bin/darwinop-run" ] || die "darwinop is not on this robot yet. Install it first: darwinop install"
}

# receive_controller NAME KILOBYTES CKSUM BYTES <archive.tar.gz
receive_controller() {
  need_runtime
  lock
  controllers=$home/controllers
  mkdir -p "$controllers" || die "cannot make $controllers"
  tidy_controllers
  need_space "$2" $(($4 / 1024))
  staging=$(mktemp -d "$controllers/.staging-XXXXXX") || die "cannot write into $controllers"
  unpack_controller "$@" || {
    rm -rf "$staging"
    die "$1 was not changed"
  }
  sent=$controllers/.sent-${staging##*.staging-}
  { chmod 755 "$staging" && mv "$staging" "$sent"; } || die "cannot rename $staging; $1 was not changed"
  # A folder that somebody made by hand stands in the way of the link.
  if [ -d "$controllers/$1" ] && [ ! -L "$controllers/$1" ]; then
    mv "$controllers/$1" "$controllers/$1.by-hand-$$" || die "cannot move $controllers/$1 away"
    say "$controllers/$1 was put there by hand; it is now $1.by-hand-$$"
  fi
  # The name on the way is hidden, as no controller's is.
  { ln -s "${sent##*/}/$1" "$controllers/.link-$$" && mv -T -f "$controllers/.link-$$" "$controllers/$1"; } ||
    die "cannot link $controllers/$1; $1 was not changed"
  sync
  tidy_controllers
  say "$1 is there, $2 kB"
}

# Into $staging. What comes is looked at before it is used: the link may have been cut.
unpack_controller() { # NAME KILOBYTES CKSUM BYTES
  mkdir "$staging/$1" && cat >"$staging/.archive" || return 1
  [ "$(cksum <"$staging/.archive")" = "$3 $4" ] || {
    say "the link was cut: $(wc -c <"$staging/.archive") of $4 bytes came. Send it again"
    return 1
  }
  # -m: the robot's clock may be years behind.
  (cd "$staging/$1" && gzip -dc ../.archive | tar -xmof -) && rm "$staging/.archive" &&
    chmod -R a-s,u+rwX,go-w "$staging/$1" && own "$staging/$1" && [ -x "$staging/$1/$1" ]
}

# need_space KILOBYTES...: while unpacking, archive and files are there, and a full disk harms more than us.
need_space() {
  needed=20480
  for part in "$@"; do needed=$((needed + part)); done
  free=$(free_kb)
  [ "${free:-0}" -ge "$needed" ] ||
    die "the robot's disk is too full: ${free:-0} kB are free, $needed kB are needed. Remove what is not needed from $home/controllers"
}

# Removes what interrupted sendings left, and controllers that were replaced and run no more.
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
is_in_use() { ls -l /proc/[0-9]*/exe /proc/[0-9]*/cwd 2>/dev/null | grep -qF -e "-> $1/"; }

supervisor() { "$home/current/bin/darwinop-supervisor" "$@"; }
supervisor_runs() { supervisor --status >/dev/null 2>&1; }

# make_default NAME: what starts at every boot.
make_default() {
  need_runtime
  lock
  [ -x "$home/controllers/$1/$1" ] || die "there is no controller $1 on this robot; send it with --controller"
  point "$home/default" "controllers/$1" || die "cannot link $home/default; the default controller is the one before"
  sync
  say "$1 is the default controller now: it starts at every boot"
  say "at boot the start pose is checked first; a robot that does not sit in it stays still, with the reason in the log (--logs)"
  if is_running; then
    say "$(sed -n 3p "$home/running") goes on running now; $1 starts at the next boot"
  elif driver=$(robot_driver) && [ -n "$driver" ] && is_from_elsewhere "$driver"; then
    say "a window on a PC drives this robot (process $driver) and goes on; $1 starts at the next boot"
  elif supervisor_runs; then
    say "it starts now, too: mind your fingers"
    supervisor --restart-controller || die "$1 could not be started now; look at --logs, or switch the robot off and on"
  else
    say "no supervisor runs on the robot; $1 starts when the robot is switched on again"
  fi
}

# make_no_default: nothing starts at boot. One that --run started goes on.
make_no_default() {
  need_runtime
  lock
  before=$(readlink "$home/default") || {
    say "there is no default controller; nothing to do"
    return
  }
  rm -f "$home/default" || die "cannot remove $home/default; the default controller is the one before"
  sync
  say "${before##*/} no longer starts at boot; it stays on the robot"
  if supervisor_runs && ! is_running; then
    supervisor --stop-controller || die "it could not be stopped. Hold the robot and press MODE for a moment"
  fi
}

# The default controller and one that --run started; both end tidily. Nothing running is no error.
stop_controllers() {
  need_runtime
  stop_sent_controller
  stop_driving_window
  if supervisor_runs; then
    supervisor --stop-controller || die "the default controller could not be stopped. Hold the robot and press MODE for a moment"
    say "the default controller is stopped; it starts again at the next boot"
  fi
}

# show_logs FOLLOW: both logs, each under its name. With FOLLOW = 1 until stdin ends.
show_logs() {
  need_runtime
  for log in controller supervisor; do
    if [ "$1" = 1 ] || [ -f "$home/log/$log.log" ]; then set -- "$@" "$home/log/$log.log"; fi
  done
  [ $# -gt 1 ] || die "there is no log yet: nothing was started on this robot since darwinop was installed"
  follow=$1
  shift
  if [ "$follow" = 0 ]; then
    tail -n 200 "$@"
    return
  fi
  exec 3<&0 </dev/null
  # A log that is too long becomes a new file: -F goes on with that.
  tail -n 200 -F "$@" 3<&- &
  tail_pid=$!
  while read -r _; do :; done <&3
  kill "$tail_pid"
}
