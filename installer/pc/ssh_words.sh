# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Explains ssh errors with a remedy; options for the algorithms of 2009.

# explain_ssh: exits with the message for $connection/said.
explain_ssh() {
  host=${target#*@}
  if said "REMOTE HOST IDENTIFICATION HAS CHANGED"; then
    die "$host has $msg_other_key than last time; if the robot was reinstalled or another robot has this address, run 'ssh-keygen -R $(known_name)' and try again; otherwise this may be a man-in-the-middle attack"
  elif said "Host key verification failed" || said "host key is known"; then
    host_key_text=
    report_host_key
    [ -z "$host_key" ] || [ -z "$host_key_text" ] || die "$host $msg_has_other_key$host_key_text than $host_key; not logged in. Check that this is the right robot"
    die "$host $msg_unknown_host$host_key_text; check the network, then say 'yes' on a terminal, or add --new-host"
  elif said "Could not resolve hostname"; then
    die "unknown host '$host'; specify the address as user@host, for example darwin@192.168.123.1"
  elif said "Connection refused"; then
    port_option=-p
    [ "$action" != remote ] || port_option=--ssh-port  # of darwinop run and window
    die "$host $msg_refuses; check that sshd runs, and the port ($port_option)"
  elif said "timed out" || said "No route to host" || said "Network is unreachable"; then
    die "$host does not answer; check that the robot is on and the cable or WLAN connected. Its address over the cable is 192.168.123.1"
  elif said "no matching" || said "Unable to negotiate"; then
    die "this ssh and the one on $host have no algorithm in common, not even with the old ones: $(last_said)"
  elif said "Connection closed" || said "Connection reset" || said "kex_exchange_identification"; then
    die "$host closed the connection before the login; wait a minute and try again, or see its /var/log/auth.log"
  fi
  die "ssh to $target failed: $(last_said)"
}

said() { grep -q "$1" "$connection/said"; }
last_said() { grep . "$connection/said" | tail -n 1 | tr -d '\r'; }

# Name of the key in known_hosts: [host]:port if the port is not 22.
known_name() {
  known=$(sed -n 's/^.*ssh-keygen -f .* -R ["'\'']*\([^"'\'']*\)["'\'']*.*$/\1/p' "$connection/said" | tr -d '\r' | head -n 1)
  printf '%s\n' "${known:-$host}"
}

# Options for sshd of 2009 (OpenSSH 5.1), as words for eval. Only algorithms that this ssh supports: others are an error.
legacy_ssh_options() {
  legacy_option KexAlgorithms + kex diffie-hellman-group14-sha1 diffie-hellman-group1-sha1
  legacy_option HostKeyAlgorithms + key ssh-rsa ssh-dss
  # No '+': a newer server with old settings announces rsa-sha2 and then rejects it.
  legacy_option PubkeyAcceptedKeyTypes '' key ssh-rsa
  legacy_option Ciphers + cipher aes128-cbc 3des-cbc aes256-cbc
  legacy_option MACs + mac hmac-md5 hmac-sha1
}

# legacy_option NAME SIGN QUERY ALGORITHM...
legacy_option() {
  option=$1 sign=$2 query=$3 list=
  shift 3
  for algorithm in "$@"; do
    if ssh -Q "$query" 2>/dev/null | grep -qx "$algorithm"; then list=$list${list:+,}$algorithm; fi
  done
  [ -z "$list" ] || quote -o "$option=$sign$list"
}
