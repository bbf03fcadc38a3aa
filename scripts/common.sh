# shellcheck shell=bash
# What the scripts share. Source it.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# A python3 of pyenv, conda or a venv lacks the ROS modules.
export PATH=/usr/bin:$PATH

die() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# ROS's setup files read variables that nobody has set.
source_setup() {
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

# Debian's own ROS lies in /usr and needs no setup; Ubuntu 20.04's does.
source_ros() {
  if [[ -f /opt/ros/noetic/setup.bash ]]; then source_setup /opt/ros/noetic/setup.bash; fi
}

# Everything of ROS stays on this machine and inside build/: no user's master is met, no host name
# has to resolve, nothing lands in ~/.ros.
isolate_ros() {
  unset ROS_HOSTNAME ROS_MASTER_URI ROS_LOG_DIR
  export ROS_IP=127.0.0.1 ROS_HOME=$root/build/ros
}

# Without either of the two, ROS wants this host's name to resolve, and fails where it does not.
name_this_host() {
  if [[ -z ${ROS_IP-}${ROS_HOSTNAME-} ]] && ! getent hosts "$(uname -n)" >/dev/null; then
    export ROS_IP=127.0.0.1
  fi
}

free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}
