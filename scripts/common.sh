# shellcheck shell=bash
# Functions that the scripts share. To be sourced.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# A python3 of pyenv, conda or a venv lacks the ROS modules.
export PATH=/usr/bin:$PATH

die() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# ROS's setup files read variables that may be unset.
source_setup() {
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

# Debian's own ROS is in /usr and needs no setup; Ubuntu 20.04's does.
source_ros() {
  if [[ -f /opt/ros/noetic/setup.bash ]]; then source_setup /opt/ros/noetic/setup.bash; fi
}

# Keeps ROS on this machine and inside build/: does not contact the user's master, does not need this
# host's name to resolve, writes nothing to ~/.ros.
isolate_ros() {
  unset ROS_HOSTNAME ROS_MASTER_URI ROS_LOG_DIR
  export ROS_IP=127.0.0.1 ROS_HOME=$root/build/ros
}

# Without either of the two variables, ROS fails if this host's name does not resolve.
name_this_host() {
  if [[ -z ${ROS_IP-}${ROS_HOSTNAME-} ]] && ! getent hosts "$(uname -n)" >/dev/null; then
    export ROS_IP=127.0.0.1
  fi
}

free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# Shows progress, lines such as "[ 43%] Building ...": on a terminal each overwrites the one before, in a
# log one for every ten percent is kept. All other lines go to stderr.
show_progress() {
  local line percent last=-10 columns
  columns=$(tput cols 2>/dev/null || echo 80)
  while IFS= read -r line; do
    if [[ ! $line =~ ^\[\ *([0-9]+)%\]\ (.*) ]]; then
      if [[ -t 1 ]]; then printf '\r\033[K'; fi
      echo "$line" >&2
      continue
    fi
    percent=${BASH_REMATCH[1]}
    printf -v line '[%3d %%] %s' "$percent" "${BASH_REMATCH[2]}"
    if [[ -t 1 ]]; then
      printf '\r\033[K%s' "${line:0:columns-1}"
    elif ((percent >= last + 10 || percent < last)); then
      echo "$line"
      last=$percent
    fi
  done
  if [[ -t 1 ]]; then printf '\r\033[K'; fi
}

# configure FOLDER OPTION...: CMake's output is shown only if it fails.
configure() {
  mkdir -p "$1"
  if ! cmake -S "$root" -B "$1" "${@:2}" >"$1/configure.log" 2>&1; then
    cat "$1/configure.log" >&2
    die "cmake cannot configure the build"
  fi
}

# build FOLDER TARGET...
build() {
  # [ 43%] Building CXX object CMakeFiles/TARGET.dir/src/shell_origami/mesh/cuts.cpp.o
  make -C "$1" --no-print-directory -j"$(nproc)" "${@:2}" 2>&1 |
    sed -uE -e '/Built target|^Scanning dependencies|^Consolidate compiler generated/d' \
      -e '/^Generating reconfiguration files|^Wrote header file/d' \
      -e 's#(%\] )Building CXX object (.*/)?CMakeFiles/([^/]*)\.dir/(src/shell_origami/)?(.*)\.(o|gch)$#\1building \3: \5#' \
      -e 's/(%\] )Linking CXX [a-z ]* (.*\/)?/\1linking /' |
    show_progress
}
