# shellcheck shell=sh disable=SC2034  # what is set here is read by the other files
# Command line: one variable with a default for each option.

action=install       # install, uninstall, status, rollback, controller, remote
target=darwin@192.168.123.1
dry_run=0
force=0
without_robot=0
port=
autostart=           # empty: as found on the robot
bundle=
new_host=0
ssh_options=         # words quoted for eval
controller_dir=
controller_action=   # send, run, make-default, no-default, stop, logs
controller_arguments= # words quoted for eval
logs_follow=0
passed=0             # 1: there was a --

usage() {
  cat <<'END'
usage: darwinop install [OPTIONS] [USER@HOST]
       darwinop install --controller DIR [--run | --make-default] [OPTIONS] [USER@HOST] [-- ARGUMENTS...]
       darwinop install --stop | --no-default | --logs [-f] [OPTIONS] [USER@HOST]

Installs darwinop-rt on a robot over ssh (default darwin@192.168.123.1; an OP2 has robotis@...), or sends a controller.
Everything is checked before anything changes; a version that fails its self-test is reverted automatically.

  --dry-run              check everything and print what would be done; with --controller: build only
  --status               print what is installed and running
  --rollback             return to the previous version
  --uninstall            remove everything and restore /etc/rc.local
  --force                install an older version over a newer one; continue if the supervisor does not stop;
                         with --run: start in any pose (hold the robot)
  --without-robot        without a serial device: no self-test, and the supervisor is not started
  --port DEVICE          serial device of the CM-730, for a new robot.ini (default /dev/ttyUSB0)
  --autostart KIND       rc.local, systemd or none (default: as on the robot)
  --bundle FILE          archive to install (default: the newest of ./dev build --robot)
  --controller DIR       build the controller in DIR and send it with its data files
    --run                and run it; Ctrl-C stops it safely; its arguments after --
    --make-default       and start it at every boot
  --no-default           start no controller at boot; stop the default controller safely
  --stop                 stop whatever drives the robot, safely; the default one starts again at the next boot
  --logs [-f]            print the robot's logs; -f follows them
  --remote [--picture 160x120]   remote control until stdin ends; used by darwinop run --robot tcp://USER@HOST
  --remote --window      servers for the robot window until stdin ends; used by darwinop window
  --new-host             accept the host key of an unknown robot without asking
  --host-key SHA256:...  accept it if it has this fingerprint
  --progress             machine-readable progress on file descriptor 3; errors are marked
  -p PORT, -i KEY, -o OPTION, -F FILE   as for ssh

A password is asked for once, or taken from DARWINOP_PASSWORD. Example: darwinop install --dry-run darwin@192.168.123.1
Exit code: 0 done, 1 rejected or failed without change, 2 wrong usage, 3 start pose is not safe,
4 failed and reverted to the previous version, 5 another installation is running.
END
}

wrong_usage() {
  say "$error_mark$*; see 'darwinop install --help'"
  exit 2
}

parse_arguments() {
  have_target=0
  while [ $# -gt 0 ]; do
    case $1 in
      --port | --autostart | --bundle | --controller | --picture | --tell | --host-key | -p | -i | -o | -F) [ $# -ge 2 ] || wrong_usage "$1 needs a value" ;; # keep-word
    esac
    case $1 in
      -h | --help) usage && exit 0 ;;
      --dry-run) dry_run=1 ;;
      --status | --rollback | --uninstall) set_action "${1#--}" ;;
      --force) force=1 ;;
      --without-robot) without_robot=1 ;;
      --port) port=$2 && shift ;;
      --autostart) autostart=$2 && shift ;;
      --bundle) bundle=$2 && shift ;;
      --controller) set_action controller && controller_dir=$2 && shift ;;
      --run | --make-default) set_controller_action "${1#--}" ;;
      --stop | --no-default | --logs) set_action controller && set_controller_action "${1#--}" ;;
      --remote) set_action remote ;;
      --picture) picture=$2 && shift ;;
      --tell) notify_pid=$2 && shift ;; # keep-word
      --window) window=1 ;;
      -f) logs_follow=1 ;;
      --new-host) new_host=1 ;;
      --host-key) host_key=$2 && shift ;;
      --progress) begin_progress ;;
      -p | -i | -o | -F) ssh_options="$ssh_options$(quote "$1" "$2")" && shift ;;
      --) shift && controller_arguments=$(quote "$@") && set -- -- && passed=1 ;;
      -*) wrong_usage "unknown option $1" ;;
      *)
        [ $have_target = 0 ] || wrong_usage "more than one robot: $target, $1"
        target=$1 have_target=1
        ;;
    esac
    shift
  done
  check_arguments
}

set_action() {
  [ "$action" = install ] || wrong_usage "--$action and --$1 cannot be combined"
  action=$1
}

set_controller_action() {
  [ -z "$controller_action" ] || wrong_usage "--$controller_action and --$1 cannot be combined"
  controller_action=$1
}

check_arguments() {
  case $target in
    -* | *[!A-Za-z0-9@._:%-]* | *@ | @* | '') wrong_usage "'$target' is not user@host" ;;
    *@*) ;;
    *) target=darwin@$target ;;
  esac
  case $autostart in '' | rc.local | systemd | none) ;; *) wrong_usage "--autostart requires rc.local, systemd or none, not '$autostart'" ;; esac
  case $port in
    '' | /dev/?*) ;;
    *) wrong_usage "--port requires a device such as /dev/ttyUSB0, not '$port'" ;;
  esac
  case $port in *[!A-Za-z0-9/._:-]*) wrong_usage "--port requires a device such as /dev/ttyUSB0, not '$port'" ;; esac
  [ "$logs_follow" = 0 ] || [ "$controller_action" = logs ] || wrong_usage "-f requires --logs"
  case $dry_run:$controller_action in 1:stop | 1:no-default) wrong_usage "--dry-run cannot be combined with --$controller_action" ;; esac
  check_host_key
  [ -z "$picture$notify_pid" ] || [ "$action" = remote ] || wrong_usage "--picture and --tell require --remote" # keep-word
  [ "$window" = 0 ] || [ "$action:$picture" = remote: ] || wrong_usage "--window requires --remote and excludes --picture"
  check_picture
  case $action:$controller_action in
    controller:run) ;;
    controller:stop | controller:no-default | controller:logs) [ -z "$controller_dir" ] || wrong_usage "--$controller_action cannot be combined with --controller" ;;
    controller:) controller_action=send ;;
    controller:*) ;;
    *:?*) wrong_usage "--$controller_action requires --controller" ;;
  esac
  [ "$passed" = 0 ] || [ "$controller_action" = run ] || wrong_usage "arguments after -- require --controller DIR --run"
}
