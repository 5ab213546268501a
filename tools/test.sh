#!/usr/bin/env bash
# Installs what the tests need, and runs all of them on every driver, with the validation layer on. Each test has a process and a time
# limit of its own: a driver that hangs fails one test.
# usage: tools/test.sh [DRIVER...]      DRIVER: mesa25:128 mesa25:256 mesa25:512 (vector widths) mesa22 swiftshader system
# [default: all but system, which is whatever this machine has]
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
need_rust
need 'command -v timeout' coreutils
drivers=("$@"); [ $# -gt 0 ] || drivers=(mesa25:128 mesa25:256 mesa25:512 mesa22 swiftshader)
tools/drivers.sh
on_device=' features nodes harmonics splats sort raster frame skip scene devices stress commands window webgpu '
limit=${EFFIGY_TEST_SECONDS:-300}

echo "building the tests"
built=$(cargo test --no-run --features webgpu 2>&1) || { echo "$built" >&2; exit 1; }
mapfile -t binaries < <(echo "$built" | sed -n 's/^ *Executable .*(\(.*\))$/\1/p')
[ ${#binaries[@]} -gt 0 ] || { echo "no test binaries in cargo's output:" >&2; echo "$built" >&2; exit 1; }

passed=0 failed=()
run() { # DRIVER BINARY
  local name log test; name=$(basename "$2" | sed 's/-[0-9a-f]*$//'); log=$(mktemp)
  while read -r test; do
    if timeout -k 5 "$limit" "$2" --exact "$test" --nocapture >"$log" 2>&1 </dev/null; then
      passed=$((passed + 1)); grep -h '^skipped' "$log" | sed "s/^/  $1 $name::$test /" || true
    else
      failed+=("$1 $name::$test"); echo "FAILED $1 $name::$test"; tail -n 30 "$log"
    fi
  done < <("$2" --list --format terse 2>/dev/null </dev/null | sed -n 's/: test$//p')
  rm -f "$log"
}

for binary in "${binaries[@]}"; do
  name=$(basename "$binary" | sed 's/-[0-9a-f]*$//')
  case "$on_device" in *" $name "*) ;; *) run host "$binary" ;; esac
done
echo "without a device: $passed passed"
for driver in "${drivers[@]}"; do
  before=$passed
  unset VK_DRIVER_FILES VK_ICD_FILENAMES LP_NATIVE_VECTOR_WIDTH
  if [ "$driver" != system ]; then
    icd="$PWD/target/drivers/${driver%%:*}.json"
    [ -s "$icd" ] || { echo "no driver called $driver" >&2; exit 2; }
    export VK_DRIVER_FILES=$icd VK_ICD_FILENAMES=$icd
    case $driver in *:*) export LP_NATIVE_VECTOR_WIDTH=${driver##*:} ;; esac
  fi
  export EFFIGY_REQUIRE_GPU=1 EFFIGY_VALIDATION=1 VK_LAYER_PATH=$PWD/target/drivers/layers VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=1
  for binary in "${binaries[@]}"; do
    name=$(basename "$binary" | sed 's/-[0-9a-f]*$//')
    case "$on_device" in *" $name "*) run "$driver" "$binary" ;; esac
  done
  echo "$driver: $((passed - before)) passed"
done
[ ${#failed[@]} = 0 ] || { echo "${#failed[@]} failed:"; printf '  %s\n' "${failed[@]}"; exit 1; }
echo "all $passed passed"
