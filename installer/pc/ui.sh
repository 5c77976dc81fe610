# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# User interface: messages on stderr, password prompt, quoting for the remote shell.

# Ignores an environment variable of this name.
terminal_state=
changing=

program="darwinop install"
error_mark=  # prefix of error messages for --progress
say() { printf '%s\n' "$program: $*" >&2; }

# die [-CODE] MESSAGE: exits with code 1, or CODE.
die() {
  code=1
  case $1 in -[0-9]*) code=${1#-}; shift ;; esac
  say "$error_mark$*"
  exit "$code"
}

# quote WORD...: quotes words for a shell; newlines are preserved.
quote() {
  for word in "$@"; do
    printf "'"
    # The dot preserves trailing newlines, which $( ) removes.
    word=$(printf '%s.' "$word" | sed "s/'/'\\\\''/g")
    printf "%s' " "${word%.}"
  done
}

on_terminal() { [ -t 2 ] && (: </dev/tty) 2>/dev/null; }

# Ctrl-C ends this program after cleanup; a second one must not interrupt the cleanup.
end_on_signals() {
  trap 'interrupted 130' INT
  trap 'interrupted 143' TERM HUP
}

# The robot does not notice; it completes a switch of versions that has started.
interrupted() { # STATUS
  trap '' INT TERM HUP
  [ -z "${changing:-}" ] || say "interrupted; $msg_completes, an incomplete archive changes nothing. Check with --status"
  [ "$action" != remote ] || say "$msg_interrupted"
  exit "$1"
}

# DARWINOP_PASSWORD is removed from the environment: make, compilers and controllers' Makefiles must not see it.
take_password() {
  unset password
  [ -z "${DARWINOP_PASSWORD+x}" ] || password=$DARWINOP_PASSWORD
  unset DARWINOP_PASSWORD
}

# need_password WHY: sets $password, prompting once on the terminal.
need_password() {
  [ -z "${password+x}" ] || return 0
  [ "$progress" = 0 ] || die "$1 needs a password, and none was given"
  on_terminal || die "$1 needs a password and there is no terminal for a prompt; set DARWINOP_PASSWORD, or copy a key to the robot with 'ssh-copy-id $target'"
  printf '%s' "Password of $target ($1): " >/dev/tty
  terminal_state=$(stty -g </dev/tty)
  stty -echo </dev/tty
  IFS= read -r password </dev/tty || password=
  restore_terminal
  printf '\n' >/dev/tty
}

restore_terminal() {
  [ -z "${terminal_state:-}" ] || stty "$terminal_state" </dev/tty
  terminal_state=
}
