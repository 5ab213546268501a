# Sourced by the other tools: installs what is missing, with apt where there is one, and says what to do where there is none.

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; elif command -v sudo >/dev/null; then sudo "$@"; else echo "run as root: $*" >&2; return 1; fi; }

# need TEST PACKAGE...: installs the packages unless the test command succeeds.
need() {
  local present=$1; shift
  (set +o pipefail; eval "$present") >/dev/null 2>&1 && return 0
  command -v apt-get >/dev/null || { echo "missing: $* (Debian's names); install them with this system's package manager" >&2; return 1; }
  echo "installing $*"
  [ -n "${apt_updated:-}" ] || as_root apt-get -o DPkg::Lock::Timeout=300 update -qq
  apt_updated=1
  DEBIAN_FRONTEND=noninteractive as_root apt-get -o DPkg::Lock::Timeout=300 install -qq -y --no-install-recommends "$@" >/dev/null
}

need_rust() {
  command -v cargo >/dev/null || { [ -r "$HOME/.cargo/env" ] && . "$HOME/.cargo/env"; }
  command -v cargo >/dev/null || { echo "Rust is missing: install it from https://rustup.rs, open a new shell and run this again" >&2; return 1; }
  need 'command -v cc' gcc libc6-dev
}

# write_icd MANIFEST LIBRARY VERSION: names a Vulkan driver for VK_DRIVER_FILES.
write_icd() {
  [ -s "$2" ] || { echo "$2 is missing" >&2; return 1; }
  printf '{"file_format_version": "1.0.1", "ICD": {"api_version": "%s", "library_path": "%s"}}\n' "$3" "$2" > "$1"
}

# need_target TARGET: Rust's standard library for it, of the compiler in use (RUSTC).
need_target() {
  [ -d "$("${RUSTC:-rustc}" --print sysroot)/lib/rustlib/$1" ] && return 0
  command -v rustup >/dev/null || { echo "Rust has no standard library for $1 here: install it with this system's package manager" >&2; return 1; }
  rustup target add "$1"
}

# Prints the comment that the script begins with.
usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }

# Sets EFFIGY to the program, built where that is needed. EFFIGY=PROGRAM names one that is built already.
build_effigy() {
  [ -z "${EFFIGY:-}" ] || return 0
  local built; built=$(realpath -m "${CARGO_TARGET_DIR:-target}")/desktop/effigy
  [ -x "$built" ] || echo "building Effigy: 10 minutes of processor time, 5 on two free cores" >&2
  # In a list of commands `set -e` does not end a function: a program of an earlier build must not run in its place.
  cargo build --profile desktop --quiet -p effigy-cli || return
  export EFFIGY=$built
}

# effigy ARGS...: runs it.
effigy() { build_effigy && "$EFFIGY" "$@"; }

# effigy_lab ARGS...: runs the laboratory: the one beside the program that EFFIGY names, else built where that is needed.
effigy_lab() {
  local built; built=$(realpath -m "${CARGO_TARGET_DIR:-target}")/desktop
  if [ -z "${EFFIGY_LAB:-}" ]; then
    if [ -n "${EFFIGY:-}" ] && [ "$(dirname "$EFFIGY")" != "$built" ]; then
      EFFIGY_LAB=$(dirname "$EFFIGY")/effigy-lab
    else
      cargo build --profile desktop --quiet -p effigy-lab || return
      EFFIGY_LAB=$built/effigy-lab
    fi
  fi
  "$EFFIGY_LAB" "$@"
}
