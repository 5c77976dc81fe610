# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Text of /etc/rc.local with and without our block. No side effects. `$text_rc_local` is the block.
#
# The block is right after the #! line, before any `exit 0`, sleep or failing line of the robot. Lines that start the
# ROBOTIS demo, or the default controller of Webots' installation, are disabled in place; the `:` keeps an enclosing if or
# loop valid.

# rc_local_without FILE: the text without our changes, even if it was edited.
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

# rc_local_with FILE STARTS RAN: FILE has no block. STARTS 0: only disables the others.
# RAN 0: the file was not executable, so its lines did not run at boot and must not run now.
rc_local_with() {
  opening=$(sed -n '1{s/\r$//;p;}' "$1")
  case $opening in
    '#!'*) printf '%s\n' "$opening" && rc_local_block "$@" '' && sed 1d "$1" | rc_local_disable ;;
    *) printf '#!/bin/sh\n' && rc_local_block "$@" '# the #! line above is new, too' && rc_local_disable <"$1" ;;
  esac
}

# The template with @NOTES@ replaced by notes on the changes.
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

# rc_local_disable <TEXT: disables command lines (joined at a trailing \) that run one of them. Keeps lines that only open
# an if, loop or case.
rc_local_disable() {
  awk '
    function runs(all, folder, program) {
      folder = "/Linux/project/" folder
      return index(all, folder "/" program) || (index(all, folder) && index(all, "./" program))
    }
    function group(  i, all, hit) {
      for (i = 1; i <= n; i++) all = all line[i] "\n"
      hit = runs(all, "demo", "demo") || runs(all, "webots", "default")
      if (all ~ /^[ \t]*#/) hit = 0
      if (all ~ /^[ \t]*(if|elif|while|until|for|case)[ \t]/ && all !~ /[ \t;](fi|done|esac)[ \t\r\n;&]/) hit = 0
      for (i = 1; i <= n; i++) print (hit ? ": # darwinop-rt disabled: " : "") line[i]
      n = 0
    }
    { line[++n] = $0 }
    !/\\$/ || (n == 1 && /^[ \t]*#/) { group() }
    END { if (n) group() }'
}

# Lists in one line what would be disabled in FILE; empty: nothing.
rc_local_others() {
  rc_local_without "$1" | rc_local_disable | sed -n 's/^: # darwinop-rt disabled: *//p' | tr -d '\r' | tr '\n' ';' | sed 's/;$//'
}

rc_local_touched() { [ -f "$1" ] && grep -q -e '^# >>> darwinop-rt' -e '^: # darwinop-rt disabled: ' "$1"; }
