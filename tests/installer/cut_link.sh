#!/usr/bin/env bash
# A ProxyCommand of ssh whose link breaks: cut_link.sh BYTES HOST PORT [FILE]
# The client's first BYTES go through, then both directions are cut. What went through is appended to FILE.
exec 3<>"/dev/tcp/$2/$3" || exit
trap : HUP TERM  # ssh sends one when it is done; then, too, nothing of the link may stay open
cat <&3 &
stdbuf -o0 head -c "$1" | tee -a "${4:-/dev/null}" >&3
kill $! 2>/dev/null
