#!/usr/bin/env bash
# Installs what the tests need, and runs them on every driver, with the validation layer on. Each test has a process and a time limit of
# its own: a driver that hangs fails one test.
# usage: tools/test.sh [DRIVER...]      DRIVER: mesa25:128 mesa25:256 mesa25:512 (vector widths) mesa22 swiftshader system
#   system: whatever this machine has; mesa22: Debian 12's own; with /stages behind it only the tests of GPU stages and frames are run
# [default: mesa25:256 swiftshader mesa25:128/stages mesa25:512/stages; another width is other code in the stages and nothing else]
# What became of each test and its seconds: target/tests/all
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
need_rust
need 'command -v timeout' coreutils
drivers=("$@"); [ $# -gt 0 ] || drivers=(mesa25:256 swiftshader mesa25:128/stages mesa25:512/stages)
tools/drivers.sh
stages=' pack features nodes harmonics splats sort raster frame detail skip scene stress '
on_device="$stages present soak trace devices commands window webgpu "
limit=${EFFIGY_TEST_SECONDS:-300}

echo "building the tests"
built=$(cargo test --no-run --features webgpu 2>&1) || { echo "$built" >&2; exit 1; }
mapfile -t binaries < <(echo "$built" | sed -n 's/^ *Executable .*(\(.*\))$/\1/p')
[ ${#binaries[@]} -gt 0 ] || { echo "no test binaries in cargo's output:" >&2; echo "$built" >&2; exit 1; }

results=$PWD/target/tests; rm -rf "$results"; mkdir -p "$results"
export limit results
one() { # DRIVER BINARY TEST: a line of $results/all is: what came of it, seconds, driver, test
  local name log from=$EPOCHREALTIME end=ok; name=$(basename "$2" | sed 's/-[0-9a-f]*$//'); log=$(mktemp "$results/XXXXXX")
  timeout -k 5 "$limit" "$2" --exact "$3" --nocapture >"$log" 2>&1 </dev/null || end=FAILED
  echo "$end $(( (${EPOCHREALTIME/[.,]/} - ${from/[.,]/}) / 1000000 )) $1 $name::$3" >>"$results/all"
  if [ $end = ok ]; then grep -h '^skipped' "$log" | sed "s/^/  $1 $name::$3 /" || true
  else echo "FAILED $1 $name::$3"$'\n'"$(tail -n 30 "$log")"; fi
  rm -f "$log"
}
export -f one
# As many tests at once as there are processors, for much of each is on one. Neighbours need the same kernels: in turn, in an order that
# is the same every time, both would wait for their compilation; mixed, one finds what another left in the driver's cache.
run() { # DRIVER BINARY...
  local driver=$1 binary; shift
  for binary in "$@"; do "$binary" --list --format terse 2>/dev/null </dev/null | sed -n "s|^\(.*\): test$|$driver $binary \1|p"; done |
    shuf --random-source=Cargo.lock | xargs -r -P "$(nproc)" -L 1 bash -c 'one "$@"' _
}
passed() { grep -c "^ok [0-9]* $1 " "$results/all" || true; }

host=() device=() narrow=()
for binary in "${binaries[@]}"; do
  name=$(basename "$binary" | sed 's/-[0-9a-f]*$//')
  case "$on_device" in *" $name "*) device+=("$binary") ;; *) host+=("$binary") ;; esac
  case "$stages" in *" $name "*) narrow+=("$binary") ;; esac
done
run host "${host[@]}"
echo "without a device: $(passed host) passed ($SECONDS s)"
for asked in "${drivers[@]}"; do
  driver=${asked%/stages} binaries=("${device[@]}")
  [ "$driver" = "$asked" ] || binaries=("${narrow[@]}")
  unset VK_DRIVER_FILES VK_ICD_FILENAMES LP_NATIVE_VECTOR_WIDTH
  if [ "$driver" != system ]; then
    icd="$PWD/target/drivers/${driver%%:*}.json"
    [ -s "$icd" ] || { echo "no driver called $driver" >&2; exit 2; }
    export VK_DRIVER_FILES=$icd VK_ICD_FILENAMES=$icd
    case $driver in *:*) export LP_NATIVE_VECTOR_WIDTH=${driver##*:} ;; esac
    # Mesa keeps what it compiled without minding for which width: with another one, pictures lose squares.
    export MESA_SHADER_CACHE_DIR=$PWD/target/drivers/cache/$driver
  fi
  export EFFIGY_REQUIRE_GPU=1 EFFIGY_VALIDATION=1 VK_LAYER_PATH=$PWD/target/drivers/layers VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=1
  run "$driver" "${binaries[@]}"
  echo "$driver: $(passed "$driver") passed ($SECONDS s)"
done
echo "the slowest:"; sort -k2,2nr "$results/all" | sed -n '1,8s/^[a-zA-Z]* \([0-9]*\)/  \1 s/p'
failed=$(grep -c '^FAILED' "$results/all" || true)
[ "$failed" = 0 ] || { echo "$failed failed:"; sed -n 's/^FAILED [0-9]*/ /p' "$results/all"; exit 1; }
echo "all $(grep -c '^ok' "$results/all") passed"
