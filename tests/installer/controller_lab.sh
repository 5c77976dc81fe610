# shellcheck shell=bash disable=SC2034,SC2154  # some names are read by the scenarios, others set by robot.sh
# Fixture of the controller scenarios: a robot with a runtime, and an empty library to compile against, so that only a
# cross compiler is needed. Sourced by controller_*.sh.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/robot.sh"
# shellcheck source=controller_sources.sh
. "$HERE/controller_sources.sh"

command -v i686-linux-gnu-g++ >/dev/null || die "not on this machine: i686-linux-gnu-g++. Install: g++-i686-linux-gnu"

# Runs until SIGINT, then takes time to end, like a kneeling robot.
until_stopped='
  signal(SIGINT, stop); puts("walking"); fflush(stdout);
  while (!stopped) usleep(20000);
  puts("kneeling"); fflush(stdout); usleep(1500000);
  puts("done"); FILE* ended = fopen("/tmp/ended", "w"); fputs("done\n", ended); fclose(ended); return 7;'

# A runtime as installed by `darwinop install`, from the fake bundle's scripts.
put_runtime() {
  local home=$ROBOT/opt/darwinop version=0.1.0+fake
  mkdir -p "$home/versions"
  fake_bundle_folder $version 1 "$home/versions/$version"
  ln -s "versions/$version" "$home/current"
  printf '#!/bin/sh\nexec /opt/darwinop/current/share/darwinop/boot\n' >"$home/start"
  i686-linux-gnu-g++ -static -x c++ - -o "$home/current/bin/darwinop-run" <<'RUN'
// Forwards Ctrl-C and reports the controller's exit like the real one; without a robot.
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
pid_t child = 0;
void handOn(int signal) { kill(child, signal); }
int main(int count, char** arguments) {
  if (count < 5 || std::string{arguments[2]} != "runtime" || std::string{arguments[4]} != "--") return 2;
  const std::string folder = arguments[3], program = folder + strrchr(arguments[3], '/');
  child = fork();
  if (child == 0) {
    signal(SIGINT, SIG_DFL);
    arguments[4] = arguments[3];
    execv(program.c_str(), arguments + 4);
    _exit(127);
  }
  signal(SIGINT, handOn);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
RUN
  chmod 755 "$home/start"
}

start_runtime() {
  chroot "$ROBOT" /opt/darwinop/start </dev/null >/dev/null 2>&1 &
  wait_for "$ROBOT/run/booted" .
}

# start_install ARGS...: as in a terminal: its own process group for Ctrl-C, separate stdout and stderr.
start_install() {
  : >"$LAB/stdout"  # of the previous scenario
  env --default-signal=INT DARWINOP_PASSWORD="$password" setsid "$installer" "$@" </dev/null >"$LAB/stdout" 2>"$LAB/stderr" &
  install_pid=$!
}

# wait_install [SECONDS]: sets $status.
wait_install() {
  local tries=0
  while kill -0 "$install_pid" 2>/dev/null; do
    [ $((tries += 1)) -lt $((${1:-20} * 50)) ] || fail "the installer does not end: $(cat "$LAB/stderr")"
    sleep 0.02
  done
  status=0
  wait "$install_pid" || status=$?
  cat "$LAB/stdout" "$LAB/stderr" >>"$LAB/history"
}

# wait_for FILE PATTERN [SECONDS]
wait_for() {
  local tries=0
  until grep -qE -- "$2" "$1" 2>/dev/null; do
    [ $((tries += 1)) -lt $((${3:-15} * 50)) ] || { cat "$LAB/stdout" "$LAB/stderr" || true; fail "no '$2' in $1"; }
    sleep 0.02
  done
}

# An unplugged cable: no close on either side. The PC's ssh is stopped, then killed so that its script can end.
silence_link() {
  local master
  master=$(pgrep -f 'ssh.* -M .*-N' | head -1)
  [ -n "$master" ] || fail "no ssh master found"
  kill -STOP "$master"
  (sleep 18; kill -KILL "$master") &
}

# Every robot has a runtime here.
eval "$(declare -f robot_new | sed '1s/robot_new/bare_robot_new/')"
robot_new() {
  bare_robot_new "$@"
  put_runtime
  make_sdk "$LAB/sdk"
  export DARWINOP_ROBOT_SDK=$LAB/sdk
}
