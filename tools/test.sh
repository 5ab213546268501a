#!/usr/bin/env bash
# Installs what the tests need, builds them once, and runs all of them: first those that need no device, then those that do on every
# driver, with the validation layer on.
# usage: tools/test.sh [DRIVER...]      DRIVER: mesa25:128 mesa25:256 mesa25:512 (vector widths) mesa22 swiftshader system
#   system: whatever this machine has; mesa22: Debian 12's own
#   DRIVER/drawing: without what another driver hardly changes: commands, soaks, trainings, the process's memory, the sort's
#     record, the WebGPU build (the page draws with it on SwiftShader too), and more stress cases
#   DRIVER/stages: only the tests of stages, frames and packing, the only code that another width changes
# [default: mesa25:256 swiftshader/drawing mesa25:128/stages mesa25:512/stages]
# Each test's outcome and seconds: target/tests/all; what the tests print: target/tests/*.log. What the harness reads from the
# environment is listed in tests/common/harness.rs.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
. tools/drivers_env.sh
for asked in "$@"; do
  driver=${asked%/drawing}
  case ${driver%/stages} in
    mesa25:128 | mesa25:256 | mesa25:512 | mesa22 | swiftshader | system) ;;
    *) usage >&2; exit 2 ;;
  esac
done
need_rust
drivers=("$@"); [ $# -gt 0 ] || drivers=(mesa25:256 swiftshader/drawing mesa25:128/stages mesa25:512/stages)
tools/drivers.sh
tools/fetch_assets.sh >/dev/null || echo "without the body's source files its tests are skipped" >&2
tools/fetch_perceptual.sh >/dev/null || echo "without the weights of ST-LPIPS its tests are skipped" >&2

results=$PWD/target/tests; rm -rf "$results"; mkdir -p "$results"
export EFFIGY_TEST_RESULTS=$results/all
: > "$EFFIGY_TEST_RESULTS"
echo "building the tests"
build=(cargo test --workspace --features webgpu)
"${build[@]}" --no-run 2>"$results/build.log" || { cat "$results/build.log" >&2; exit 1; }
binary() { sed -n "s|^ *Executable .*tests/$1/main.rs (\(.*\))$|\1|p" "$results/build.log"; }
host=$(binary host) gpu=$(binary gpu) system=$(binary system) lab=$(binary lab)
[ -n "$host" ] && [ -n "$gpu" ] && [ -n "$system" ] && [ -n "$lab" ] || { echo "a test binary is missing:" >&2; cat "$results/build.log" >&2; exit 1; }
echo "built ($SECONDS s)"

passed=0 failed=0 skipped=0
# Runs tests and adds up what they report.
run() { # LABEL NAME COMMAND...
  local label=$1 name=$2 from=$SECONDS ended=0 p f s; shift 2
  local log; log=$results/$(echo "$label-$name" | tr ':/ ' '---').log
  EFFIGY_TEST_LABEL=$label "$@" >"$log" 2>&1 </dev/null || ended=$?
  read -r p f s < <(sed -n 's/^test result: .* \([0-9]*\) passed; \([0-9]*\) failed; \([0-9]*\) ignored.*/\1 \2 \3/p' "$log" |
    awk '{ p += $1; f += $2; s += $3 } END { print p + 0, f + 0, s + 0 }')
  # A run that ends without saying which test failed is a failure too.
  [ $ended = 0 ] || [ "$f" != 0 ] || f=1
  # Names select tests: a name that selects none is a mistake.
  [ $((p + f + s)) != 0 ] || { echo "no test ran" >>"$log"; f=1; }
  passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
  echo "$label $name: $p passed, $f failed, $s skipped ($((SECONDS - from)) s)"
  grep '^warning: ' "$log" || true
  if [ "$f" != 0 ]; then
    if grep -q '^failures:' "$log"; then sed -n '/^failures:/,$p' "$log" | sed -n '1,300p'; else tail -n 50 "$log"; fi
  fi
}

export EFFIGY_TEST_ONLY=no-device
run host units "${build[@]}" --lib --bins
run host host "$host"
run host gpu "$gpu"
run host system "$system"
run host lab "$lab"
export EFFIGY_TEST_ONLY=device EFFIGY_VALIDATION=1
for asked in "${drivers[@]}"; do
  driver=${asked%/*}
  use_driver "$driver"
  case $asked in
    */stages)
      # How the sort's tests are remembered, and more stress cases, are not for a width to change.
      run "$driver" gpu "$gpu" stages:: --skip choice::a_ --skip stress::more_
      run "$driver" system "$system" pack::
      ;;
    */drawing)
      run "$driver" gpu "$gpu" --skip memory:: --skip webgpu:: --skip choice::a_ --skip stress::more_
      run "$driver" system "$system" --skip commands:: --skip soak:: --skip train::
      ;;
    *)
      run "$driver" gpu "$gpu"
      run "$driver" system "$system"
      ;;
  esac
done

echo "the slowest:"; sort -k2,2nr "$EFFIGY_TEST_RESULTS" | sed -n '1,12s/^[a-zA-Z]* \([0-9.]*\)/  \1 s/p'
if [ $skipped != 0 ]; then
  echo "skipped:"; sed -n 's/^ignored [0-9.]* / /p' "$EFFIGY_TEST_RESULTS"
fi
if [ $failed != 0 ]; then
  echo "failed:"; sed -n 's/^FAILED [0-9.]* / /p' "$EFFIGY_TEST_RESULTS"
fi
echo "all tests took $SECONDS s"
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
