#!/usr/bin/env bash
# mpi.sh N PROGRAM [ARGUMENT...]: the program in N processes on this machine, for any user and any number of
# cores. Nothing leaves the machine: no ssh, no network but loopback.
set -euo pipefail
count=$1
shift
export OMPI_MCA_plm=isolated                          # no other host, no search for ssh
export OMPI_MCA_oob_tcp_if_include=lo                 # processes connect to mpirun over loopback
export OMPI_MCA_btl=self,vader                        # and exchange messages in shared memory,
export OMPI_MCA_btl_vader_single_copy_mechanism=none  # as containers forbid one process to read another
export OMPI_MCA_hwloc_base_binding_policy=none
as_root=()
[ "$(id -u)" != 0 ] || as_root=(--allow-run-as-root)
exec mpirun "${as_root[@]}" --oversubscribe -n "$count" "$@"
