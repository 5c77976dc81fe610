# shellcheck shell=sh
# Progress: a bar on stderr for users; with --progress, lines on file descriptor 3 for programs:
#   progress NUMBER OF FRACTION NAME      "progress 4 5 0.420 sending 4312 kB"; FRACTION is - if unknown

progress=0
phase_number=0
phase_count=0

begin_progress() {
  (: >&3) 2>/dev/null || wrong_usage "--progress $msg_no_descriptor 3"
  progress=1
  error_mark="error: "
  trap : PIPE  # the reader may close at any time; cleanup must still run
}

# phase NAME: starts the next of $phase_count phases.
phase() {
  phase_number=$((phase_number + 1))
  phase_name=$*
  report_phase -
}

report_phase() { # FRACTION
  [ "$progress" = 0 ] || printf 'progress %d %d %s %s\n' "$phase_number" "$phase_count" "$1" "$phase_name" 2>/dev/null >&3
}

# send_with_progress FILE BYTES NEXT: writes the file to stdout, then starts the phase NEXT. Without a terminal: one line
# before and one after.
send_with_progress() {
  kb=$((($2 + 1023) / 1024))
  if ! [ -t 2 ]; then
    say "sending $kb kB"
    if [ "$progress" = 1 ]; then send_in_blocks "$1"; else cat "$1"; fi && say "sent" && phase "$3"
    return
  fi
  send_in_blocks "$1" && printf '\n' >&2 && phase "$3"
}

send_in_blocks() { # FILE
  began=$(date +%s)
  block_kb=64
  sent=0
  # dd on a file reads whole blocks, so their number gives the progress.
  while [ "$sent" -lt "$kb" ]; do
    dd bs="${block_kb}k" count=1 2>/dev/null || return
    sent=$((sent + block_kb))
    [ "$sent" -le "$kb" ] || sent=$kb
    report_phase "$(printf '%d.%03d' $((sent / kb)) $((sent % kb * 1000 / kb)))"
    ! [ -t 2 ] || draw_progress "$sent" "$kb" $(($(date +%s) - began))
  done <"$1"
}

# draw_progress SENT OF SECONDS: 30 marks wide.
draw_progress() {
  seconds=$3
  [ "$seconds" -gt 0 ] || seconds=1
  marks=$(($1 * 30 / ($2 > 0 ? $2 : 1)))
  bar=$(printf '%*s' "$marks" '' | tr ' ' '#')
  printf '\r  [%-30s] %3d %%  %d kB/s ' "$bar" $(($1 * 100 / ($2 > 0 ? $2 : 1))) $(($1 / seconds)) >&2
}
