# What tools/setup and tools/test share. To be sourced, in the repository's root.

fail() {
  echo "$0: $*" >&2
  exit 3
}

# install_packages KIND…: installs the packages of these kinds (second column of tools/packages) that are missing.
install_packages() {
  local kinds=" $* " name kind missing=()
  while read -r name kind _; do
    [[ $name == \#* || $kinds != *" $kind "* ]] && continue
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null) == installed ]] || missing+=("$name")
  done <tools/packages
  [[ ${#missing[@]} -eq 0 ]] && return

  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null ||
      fail "these packages are missing, and installing them takes root or sudo: ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]} (what apt-get says goes to build/packages.log)"
  mkdir -p build
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -q)
  # A list that cannot be fetched (some other repository of this machine) is not fatal: the installation will tell.
  "${apt[@]}" update </dev/null &>build/packages.log ||
    echo "Some package lists could not be fetched: trying with those at hand." >&2
  if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null &>>build/packages.log; then
    tail -n 20 build/packages.log >&2
    fail "apt-get could not install: ${missing[*]}"
  fi
}

# require_packages KIND…: the same on Debian 12; elsewhere it says what is needed and stops.
require_packages() {
  local system
  system=$(. /etc/os-release 2>/dev/null && echo "$ID $VERSION_ID") || true
  [[ $system == "debian 12" ]] || fail "this is not Debian 12 (but ${system:-an unknown system}). Install what" \
    "tools/packages lists by your system's own means, then call this again with --no-install."
  install_packages "$@"
}

# build PRESET [cmake --build's further arguments]: builds what `cmake --preset` configured.
build() {
  # Paths relative to the repository, so that a fresh clone hits what another one has cached.
  CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_DIR=${CCACHE_DIR:-${HOME:-$PWD/build}/.cache/ccache} \
    cmake --build --preset "$1" -j "$(nproc)" "${@:2}"
}

render_first_picture() {
  build/release/rtlang examples/first.rtl -o build/first.png
  echo "The program is build/release/rtlang, its first picture build/first.png."
}
