#!/usr/bin/env bash
# What to run before others see a change, in three tiers; and what to run after each change of a shader.
# usage: tools/check.sh quick|gate|full|shader TEST...
#   quick  format, lints, tests without a device but for the long ones, twelve smoke tests on one driver
#          (EFFIGY_CHECK_DRIVER, default mesa25:256): under two minutes after a change of one line
#   gate   what has to hold before a change lands (.ci/run): quick's checks, all tests on Mesa 25 at 256 bits, all that
#          draw on SwiftShader, the stages at 128 and 512 bits, commands of the README and the guides, the examples, the
#          page in Chromium, the app
#   full   before an issue is closed: gate, and all tests at every width and on Mesa 22, the packages as they are
#          released, 2,000 stress cases, a soak, the documentation's links, the compiled shaders compared with their
#          sources. docs/development.md says why each is not in gate.
#   shader TEST...   compiles what is older than its sources, and runs tests of `gpu`, such as stages::sort, with it and as
#          they were built last: seconds after a change of a shader alone (EFFIGY_CHECK_DRIVER as for quick)
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
. tools/drivers_env.sh
step() { echo "== $1 ($SECONDS s)"; }
target=${CARGO_TARGET_DIR:-target}

lints() {
  step "format"
  if command -v npx >/dev/null; then tools/format.sh --check; else cargo fmt --all --check; fi
  step "lints"
  clippy
}

clippy() { cargo clippy --workspace --all-targets --features webgpu --quiet -- -D warnings; }

quick() {
  need_rust
  tools/drivers.sh
  lints
  # Of the whole workspace each time: with fewer packages some would be built again with other features.
  local tests=(cargo test --workspace --features webgpu --quiet)
  step "build"
  "${tests[@]}" --no-run --lib --bins --test host --test gpu
  step "unit tests"
  "${tests[@]}" --lib --bins
  step "tests without a device"
  EFFIGY_TEST_ONLY=quick "${tests[@]}" --test host
  step "smoke tests on a driver"
  use_driver "${EFFIGY_CHECK_DRIVER:-mesa25:256}"
  EFFIGY_VALIDATION=1 EFFIGY_TEST_ONLY=smoke "${tests[@]}" --test gpu
}

# Commands of the README and the guides that need no window, shortened, on the program that the tests were run with.
commands() {
  export EFFIGY=$PWD/$target/debug/effigy
  [ "${target#/}" = "$target" ] || EFFIGY=$target/debug/effigy
  use_driver mesa25:256
  effigy render --size 1024x1024 --out target/demo.png
  effigy bake body --out target/body.avatar
  effigy bake motion 01_03.bvh --from 27.9 --to 29.6 --out target/walk.motion
  effigy inspect target/body.avatar
  effigy bench target/body.avatar --motion target/walk.motion --size 1024x1024 --frames 4 --check 1 \
    --spread 2 --json target/bench.json
  effigy compare target/bench.json target/bench.json
  effigy export-ply target/body.avatar --motion target/walk.motion --uniform 0.003,0.9 --out target/body.ply \
    --cameras-out target/cams.json --size 1024x1024
  effigy bench target/body.ply --cameras target/cams.json --frames 4 --check 1
  effigy_lab stress --cases "$1"
  effigy_lab bench-sort --max-keys 65536 --keys 22
  effigy_lab bench-device --size 256x256 --max-copy 8 --min-ms 2 --json target/rates.json
  effigy soak --minutes 0.2 --fps 2 --size 256x320 --late 50 --out target/soak --trace target/trace.json
  effigy compare target/soak.json target/soak.json
}

examples() {
  use_driver mesa25:256
  # Of the whole workspace, as the tests are: with fewer packages some of their dependencies would be built again with
  # other features.
  cargo test --quiet --doc --workspace --features webgpu
  local examples=$target/debug/examples
  cargo build --quiet --workspace --features webgpu --examples
  "$examples/picture" target/example-picture.png
  "$examples/measure"
  xvfb-run -a -s '-screen 0 800x600x24' timeout 120 "$examples/window" --frames 10
}

# The README's example, as a user would have it: an empty project with the lines that stand there.
embedded() {
  use_driver mesa25:256
  local project=$target/embedded
  rm -rf "$project/src"; mkdir -p "$project/src"
  block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/{/^\`\`\`/!p}" README.md; }
  { printf '[package]\nname = "embedded"\nversion = "0.1.0"\nedition = "2024"\n[workspace]\n'
    block toml | sed "s|path = \"effigy\"|path = \"$PWD\"|"; } > "$project/Cargo.toml"
  block rust > "$project/src/main.rs"
  cp Cargo.lock "$project/"
  cp target/body.avatar "$project/"
  (cd "$project" && CARGO_TARGET_DIR=build cargo run --quiet)
  [ -s "$project/body.png" ]
}

# cross NAME TARGET...: standard libraries for browsers and Android. Does nothing where rustup or an NDK has them.
# Each set has a folder: the scripts make one anew when it is asked for other targets.
cross() {
  [ -d ../shared/cross ] || return 0
  local name=$1 dest=${EFFIGY_CROSS:-$PWD/target/cross}/$1 scripts=$PWD/target/cross-scripts key; shift
  # Its linker allows the system's functions that are on its list: the app imports more.
  rm -rf "$scripts"; cp -r ../shared/cross "$scripts"; chmod -R u+w "$scripts"
  cat tools/android-host/symbols.txt >> "$scripts/android-symbols.txt"
  "$scripts/setup-targets.sh" "$dest" "$@" >target/cross.log 2>&1 ||
    { cat target/cross.log; return 1; }
  export RUSTC=$dest/bin/rustc RUSTDOC=$dest/bin/rustdoc ANDROID_NDK_HOME=$dest/ndk
  # Cargo does not notice that the standard library changed. Each version has a build folder of its own, and those of
  # other versions are deleted.
  [ -s "$dest/stamp" ] || { echo "$dest has no stamp" >&2; return 1; }
  key=$( (echo "$dest"; cat "$dest/stamp") | sha256sum | cut -c1-12)
  mkdir -p "$target/cross-$name/$key"
  find "$target/cross-$name" -mindepth 1 -maxdepth 1 ! -name "$key" -exec rm -rf {} +
  export CARGO_TARGET_DIR=$target/cross-$name/$key
}

# What gate runs: the page, and the app on this machine's processor.
cross_checked() { cross checked wasm32-unknown-unknown x86_64-linux-android; }

page() { (cross_checked && tools/web.sh "$@" target/web) && tools/test_web.sh target/web; }

# Builds what the steps after the tests need, on what the tests leave of the cores. The steps build it again, which
# takes no time then: what fails here fails there, and is shown there.
build_ahead() {
  renice -n 19 -p $BASHPID >/dev/null
  (cross_checked && tools/web.sh --quick target/web &&
    tools/apk.sh --targets x86_64-linux-android target/apk/effigy-x86_64.apk)
  clippy
  echo "built ahead ($SECONDS s)"
}

gate() {
  need_rust
  need 'command -v npx' npm
  need 'python3 -m pip --version' python3-pip
  step "drivers and build"
  tools/drivers.sh
  # What tools/test.sh builds.
  cargo test --workspace --features webgpu --quiet --no-run
  mkdir -p target
  # With a process group of its own, so that nothing of it outlives this script.
  set -m
  build_ahead >target/ahead.log 2>&1 &
  local ahead=$!
  set +m
  trap "kill -- -$ahead 2>/dev/null || true" EXIT
  step "the README's test command"
  tools/test.sh
  step "what is still being built"
  wait "$ahead" || true
  tail -n 1 target/ahead.log
  lints
  step "commands"
  (commands 51)
  step "examples"
  (examples)
  step "the README's example in an empty project"
  (embedded)
  step "the page in a browser"
  (EFFIGY=$(realpath "$target/debug/effigy") && export EFFIGY && page --quick)
  step "the Android app"
  (use_driver mesa25:256; EFFIGY=$(realpath "$target/debug/effigy") && export EFFIGY && cross_checked &&
    tools/test_apk.sh --play 3)
}

full() {
  gate
  step "every width, and Mesa 22"
  tools/test.sh mesa25:128 mesa25:512 mesa22 swiftshader
  step "the packages as they are released"
  tools/release.sh --only linux --try
  # From here on with what is shipped.
  export EFFIGY; EFFIGY=$(realpath "$target/release/effigy")
  cargo build --release --quiet -p effigy-lab
  page
  (cross released aarch64-linux-android && tools/test_apk.sh --package)
  step "every prefix and edited files, a minute for each reader"
  # With optimised readers, which are fast enough for 100,000 files; one of them may take a second then.
  EFFIGY_FUZZ_SECONDS=60 EFFIGY_TEST_SECONDS=3600 cargo --config 'profile.dev.package.effigy-formats.opt-level=2' test \
    --quiet --workspace --features webgpu --test host -- fuzz::
  step "hostile files of 48 MB"
  EFFIGY_LARGE_MB=48 EFFIGY_TEST_SECONDS=3600 cargo --config 'profile.dev.package."*".opt-level=2' \
    --config 'profile.dev.package.effigy-formats.opt-level=2' test \
    --quiet --workspace --features webgpu --test host -- large::
  step "2,000 stress cases"
  (use_driver mesa25:256; effigy_lab stress --cases 2000 --seed 7)
  step "soak"
  (use_driver mesa25:256; effigy soak --minutes 20 --fps 2 --size 256x320 --out target/soak)
  step "a GPU's verdict, rehearsed"
  tools/gpu.sh --rehearse swiftshader
  step "documentation"
  RUSTDOCFLAGS="-D warnings" cargo doc --no-deps --workspace --features webgpu --quiet
  step "compiled shaders"
  need 'command -v cmake' cmake g++
  cargo run --release --quiet -p effigy-shaders --features compile -- --check
}

shader() {
  need 'command -v cmake' cmake g++
  cargo run --release --quiet -p effigy-shaders --features compile
  use_driver "${EFFIGY_CHECK_DRIVER:-mesa25:256}"
  # Not by cargo, which would build all that includes the modules.
  local tests; tests=$(ls -t "$target"/debug/deps/gpu-* 2>/dev/null | grep -v '\.d$' | head -n 1)
  [ -n "$tests" ] || { echo "build the tests first: cargo test --workspace --features webgpu --no-run" >&2; return 1; }
  EFFIGY_SHADERS=$PWD/shaders/spv EFFIGY_VALIDATION=1 EFFIGY_TEST_ONLY=device "$tests" "$@"
}

case ${1:-} in
  quick | gate | full) "$1"; step "done" ;;
  shader) shift; shader "$@"; step "done" ;;
  *) usage >&2; exit 2 ;;
esac
