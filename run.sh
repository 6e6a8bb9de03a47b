#!/usr/bin/env bash
# Gravity Wells: installs what is missing, builds what has changed, and runs.
set -euo pipefail

root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
program=$root/build/release/gravity-wells
default_url="udpm://239.255.76.67:9171?ttl=0&recv_buf_size=2097152"

usage() {
  cat <<END
usage: ./run.sh [demo] [OPTION...]         two peers on this machine share a world for 10 s
       ./run.sh peer [OPTION...]           one peer; ./run.sh peer --help lists its options
       ./run.sh bench [OPTION...]          one scene, measured; ./run.sh bench --help
       ./run.sh bench accuracy [OPTION...] error against CPU time, as tables and plots
       ./run.sh bench stress [OPTION...]   worlds that break engines, beside other engines
       ./run.sh bench speed [OPTION...]    many scenes beside stock Bullet; where time goes
       ./run.sh bench features [OPTION...] what a feature costs that is not used
       ./run.sh bench micro [OPTION...]    kernels of a step; options of Google Benchmark
       ./run.sh set KEY=VALUE...           changes a live session; --list, --help
       ./run.sh spy --text [OPTION...]     a live table of a session, in this terminal
       ./run.sh spy [OPTION...]            lcm-spy, with our message types
       ./run.sh peers [OPTION...]          does multicast pass between machines?
       ./run.sh simulate [OPTION...]       sessions under faults, in simulated time; --help
       ./run.sh search [OPTION...]         all interleavings of the ownership rules; --help
       ./run.sh lcm-logger [OPTION...]     records a session; --help lists its options
       ./run.sh lcm-logplayer [OPTION...]  plays a record back; --help
       ./run.sh help

set, spy, peers and the lcm- tools mean the session with the default settings,
  $default_url
unless the variable LCM_DEFAULT_URL or their own option --lcm-url=URL names another.
END
}

build_program() { "$root/app/build.sh" "$@" gravity-wells gravity-wells-bullet; }

# LCM's own tools: those that come with the wheel, or the system's.
lcm_tool() {
  local tool
  for tool in "$root"/.venv/lib/python3*/site-packages/bin/"$1"; do
    if [[ -x $tool ]]; then
      echo "$tool"
      return
    fi
  done
  command -v "$1"
}

# The demonstration disturbs no network: it gets one of its own where the machine allows that.
demo() {
  build_program
  if [[ " $*" != *" --config"* ]]; then set -- --config "$root/config/template.txt" "$@"; fi
  if unshare -rn true 2>/dev/null; then
    exec unshare -rn "$root/app/with_loopback_multicast.sh" "$program" demo "$@"
  fi
  exec "$program" demo "$@"
}

spy() {
  "$root/app/build.sh" --with spy gravity_wells_types_jar
  if [[ -z ${DISPLAY-} ]]; then
    echo "run: lcm-spy opens a window, and DISPLAY names no screen" >&2
    exit 1
  fi
  export CLASSPATH=$root/build/release/lcm_types/gravity_wells_types.jar
  exec "$(lcm_tool lcm-spy)" "$@"
}

export LCM_DEFAULT_URL=${LCM_DEFAULT_URL-$default_url}
case ${1-} in
  "" | -h | --help | help)
    if (($# == 0)); then demo; fi
    usage
    ;;
  demo)
    shift
    demo "$@"
    ;;
  -*) demo "$@" ;;
  peer | bench)
    case ${2-} in
      micro)
        "$root/app/build.sh" gravity-wells-micro
        exec "$root/build/release/gravity-wells-micro" "${@:3}"
        ;;
      accuracy | curve | speed) build_program --with plots ;;
      *) build_program ;;
    esac
    exec "$program" "$@"
    ;;
  set | peers)
    build_program
    exec "$program" "$@"
    ;;
  simulate | search)
    "$root/app/build.sh" "gravity-wells-$1"
    exec "$root/build/release/gravity-wells-$1" "${@:2}"
    ;;
  spy)
    shift
    if [[ " $* " == *" --text "* ]]; then
      build_program
      exec "$program" spy "$@"
    fi
    spy "$@"
    ;;
  lcm-logger | lcm-logplayer | lcm-sink | lcm-source)
    "$root/app/install.sh"
    exec "$(lcm_tool "$1")" "${@:2}"
    ;;
  *)
    usage >&2
    echo "run: unknown command \"$1\"" >&2
    exit 2
    ;;
esac
