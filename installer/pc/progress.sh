# shellcheck shell=sh
# Writing a file to stdout with a progress bar on stderr; without a terminal, one line before and one after.

# send_with_progress FILE BYTES
send_with_progress() {
  kb=$((($2 + 1023) / 1024))
  if ! [ -t 2 ]; then
    say "sending $kb kB"
    cat "$1" && say "sent"
    return
  fi
  began=$(date +%s)
  block_kb=64
  sent=0
  # dd on a file reads whole blocks, so their number tells how far we are.
  while [ "$sent" -lt "$kb" ]; do
    dd bs="${block_kb}k" count=1 2>/dev/null || return
    sent=$((sent + block_kb))
    [ "$sent" -le "$kb" ] || sent=$kb
    draw_progress "$sent" "$kb" $(($(date +%s) - began))
  done <"$1"
  printf '\n' >&2
}

# draw_progress SENT OF SECONDS: 30 marks wide.
draw_progress() {
  seconds=$3
  [ "$seconds" -gt 0 ] || seconds=1
  marks=$(($1 * 30 / ($2 > 0 ? $2 : 1)))
  bar=$(printf '%*s' "$marks" '' | tr ' ' '#')
  printf '\r  [%-30s] %3d %%  %d kB/s ' "$bar" $(($1 * 100 / ($2 > 0 ? $2 : 1))) $(($1 / seconds)) >&2
}
