# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# The text of /etc/rc.local with and without our block. Pure: files in, text out. `$text_rc_local` is the block.
#
# The block comes first, right after the #! line, so that an `exit 0`, a sleep or a failing line of the robot's own
# does not keep it from running. Lines that start the ROBOTIS demo are made harmless where they are; the `:` keeps an
# if or a loop around them valid.

# rc_local_without FILE: the text as if we had never been there, also when somebody edited it meanwhile.
rc_local_without() {
  awk '
    function rest(  i) { for (i = 1; i <= held; i++) if (hold[i] !~ /\/opt\/darwinop\/start/) print hold[i] }
    function first() { if (has_first && !drop) print first_line; has_first = 0 }
    /^# >>> darwinop-rt/ && !inside { inside = 1; held = 0; next }
    inside && /^# <<< darwinop-rt/ { inside = 0; held = 0; next }
    inside { if (/^# the #! line above is new/) drop = (NR > 1 && has_first); hold[++held] = $0; next }
    { sub(/^: # darwinop-rt disabled: /, "") }
    NR == 1 { first_line = $0; has_first = 1; next }
    { first(); print }
    END { first(); if (inside) rest() }' "$1"
}

# rc_local_with FILE STARTS RAN: FILE has no block. STARTS 0: something else starts us, only the demo is disabled.
# RAN 0: the file was not executable, so its lines did not run at boot; they shall not begin to.
rc_local_with() {
  opening=$(sed -n '1{s/\r$//;p;}' "$1")
  case $opening in
    '#!'*) printf '%s\n' "$opening" && rc_local_block "$@" '' && sed 1d "$1" | rc_local_disable ;;
    *) printf '#!/bin/sh\n' && rc_local_block "$@" '# the #! line above is new, too' && rc_local_disable <"$1" ;;
  esac
}

# The template, with notes on what was changed for @NOTES@.
rc_local_block() {
  printf '%s\n' "$text_rc_local" | while IFS= read -r line; do
    case $line in
      @NOTES@)
        [ -z "$4" ] || printf '%s\n' "$4"
        rc_local_disable <"$1" | sed -n 's/^: # darwinop-rt disabled: /# disabled below: /p'
        ;;
      '# <<< '*)
        [ "$3" = 1 ] || printf '%s\n' 'exit 0  # the file was not executable before: what follows did not run at boot, and still does not'
        printf '%s\n' "$line"
        ;;
      */opt/darwinop/start*) [ "$2" = 0 ] || printf '%s\n' "$line" ;;
      *) printf '%s\n' "$line" ;;
    esac
  done
}

# rc_local_disable <TEXT: command lines, put together over a \ at the end, that run the ROBOTIS demo. A line that only
# opens an if, a loop or a case stays.
rc_local_disable() {
  awk '
    function group(  i, all, hit) {
      for (i = 1; i <= n; i++) all = all line[i] "\n"
      hit = all ~ /\/Linux\/project\/demo\/demo/ || (all ~ /\/Linux\/project\/demo/ && all ~ /\.\/demo/)
      if (all ~ /^[ \t]*#/) hit = 0
      if (all ~ /^[ \t]*(if|elif|while|until|for|case)[ \t]/ && all !~ /[ \t;](fi|done|esac)[ \t\r\n;&]/) hit = 0
      for (i = 1; i <= n; i++) print (hit ? ": # darwinop-rt disabled: " : "") line[i]
      n = 0
    }
    { line[++n] = $0 }
    !/\\$/ || (n == 1 && /^[ \t]*#/) { group() }
    END { if (n) group() }'
}

# Names in one line what would be disabled in FILE; empty when nothing.
rc_local_demo() {
  rc_local_without "$1" | rc_local_disable | sed -n 's/^: # darwinop-rt disabled: *//p' | tr -d '\r' | tr '\n' ';' | sed 's/;$//'
}

rc_local_touched() { [ -f "$1" ] && grep -q -e '^# >>> darwinop-rt' -e '^: # darwinop-rt disabled: ' "$1"; }
