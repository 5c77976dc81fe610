# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# What an ssh that failed said, as a sentence with what to do; and the algorithms of 2009.

# explain_ssh: ends the program with the sentence for $connection/said.
explain_ssh() {
  host=${target#*@}
  if said "REMOTE HOST IDENTIFICATION HAS CHANGED"; then
    die "$host has another host key than last time; if the robot was set up anew, or another robot has this address now, run 'ssh-keygen -R $(known_name)' and try again; if not, somebody may stand between you and the robot"
  elif said "Host key verification failed" || said "host key is known"; then
    host_key_told=
    tell_host_key
    [ -z "$host_key" ] || [ -z "$host_key_told" ] || die "$host has another key$host_key_told than $host_key; nobody logged in. Is it the right robot?"
    die "$host is not known to this machine yet$host_key_told; check the network, then say 'yes' on a terminal, or add --new-host"
  elif said "Could not resolve hostname"; then
    die "there is no host '$host'; give the address as user@host, for instance darwin@192.168.123.1"
  elif said "Connection refused"; then
    die "$host is there but takes no ssh connection; is sshd running, and is the port right (-p)?"
  elif said "timed out" || said "No route to host" || said "Network is unreachable"; then
    die "$host does not answer; is the robot switched on, and the cable or WLAN connected? Over the cable it is 192.168.123.1"
  elif said "no matching" || said "Unable to negotiate"; then
    die "this ssh and the one on $host have no algorithm in common, not even with the old ones: $(last_said)"
  elif said "Connection closed" || said "Connection reset" || said "kex_exchange_identification"; then
    die "$host ended the connection before the login; wait a minute and try again, or look at its /var/log/auth.log"
  fi
  die "ssh to $target failed: $(last_said)"
}

said() { grep -q "$1" "$connection/said"; }
last_said() { grep . "$connection/said" | tail -n 1 | tr -d '\r'; }

# The name under which ssh keeps the key: [host]:port when the port is not 22.
known_name() {
  known=$(sed -n 's/^.*ssh-keygen -f .* -R ["'\'']*\([^"'\'']*\)["'\'']*.*$/\1/p' "$connection/said" | tr -d '\r' | head -n 1)
  printf '%s\n' "${known:-$host}"
}

# Options for sshd of 2009 (OpenSSH 5.1), as words for eval. Only what this ssh still knows: naming others is an error.
legacy_ssh_options() {
  legacy_option KexAlgorithms + kex diffie-hellman-group14-sha1 diffie-hellman-group1-sha1
  legacy_option HostKeyAlgorithms + key ssh-rsa ssh-dss
  # No '+': a newer server in old clothes announces rsa-sha2 and then refuses it.
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
