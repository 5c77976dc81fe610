# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# What the user sees and types: sentences on stderr, one question for the password, quoting for the other shell.

# Not what the environment happens to call so.
terminal_state=
changing=

program="darwinop install"
error_mark=  # before what went wrong, for a program that reads us
say() { printf '%s\n' "$program: $*" >&2; }

# die [-CODE] SENTENCE: ends with code 1, or CODE.
die() {
  code=1
  case $1 in -[0-9]*) code=${1#-}; shift ;; esac
  say "$error_mark$*"
  exit "$code"
}

# quote WORD...: the words so that a shell reads them back as they are. A newline stays a newline.
quote() {
  for word in "$@"; do
    printf "'"
    # The dot keeps newlines at the end, which $( ) would cut.
    word=$(printf '%s.' "$word" | sed "s/'/'\\\\''/g")
    printf "%s' " "${word%.}"
  done
}

on_terminal() { [ -t 2 ] && (: </dev/tty) 2>/dev/null; }

# Ctrl-C ends this program once it has tidied up; a second one must not end the tidying.
end_on_signals() {
  trap 'interrupted 130' INT
  trap 'interrupted 143' TERM HUP
}

# The robot hears nothing of it: what it had begun to switch it completes.
interrupted() { # STATUS
  trap '' INT TERM HUP
  [ -z "${changing:-}" ] || say "ended here, but the robot completes what it has begun; an archive that has not all come changes nothing. Look with --status"
  [ "$action" != remote ] || say "ended here; the robot was not told to do anything yet"
  exit "$1"
}

# DARWINOP_PASSWORD becomes a variable of this shell alone: make, compilers and controllers' Makefiles do not see it.
take_password() {
  unset password
  [ -z "${DARWINOP_PASSWORD+x}" ] || password=$DARWINOP_PASSWORD
  unset DARWINOP_PASSWORD
}

# need_password WHY: sets $password, asked for once on the terminal.
need_password() {
  [ -z "${password+x}" ] || return 0
  [ "$progress" = 0 ] || die "$1 needs a password, and none was given"
  on_terminal || die "$1 needs a password and there is no terminal to ask on; set DARWINOP_PASSWORD, or copy a key to the robot with 'ssh-copy-id $target'"
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
