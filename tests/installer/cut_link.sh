#!/usr/bin/env bash
# An ssh ProxyCommand that drops the connection: cut_link.sh BYTES HOST PORT [FILE]
# Forwards the client's first BYTES, then closes both directions. Forwarded bytes are appended to FILE.
exec 3<>"/dev/tcp/$2/$3" || exit
trap : HUP TERM  # ssh sends one at its end; then nothing of the connection may stay open either
cat <&3 &
stdbuf -o0 head -c "$1" | tee -a "${4:-/dev/null}" >&3
kill $! 2>/dev/null
