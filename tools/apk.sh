#!/usr/bin/env bash
# Makes the Android package and checks it as a store would.
# usage: tools/apk.sh [--release] [--targets TARGET,...] OUT.apk     TARGET: aarch64-linux-android (default), x86_64-linux-android
# Needs an NDK (ANDROID_NDK_HOME) and Rust's targets, which it asks rustup for where they are missing.
# With ANDROID_HOME set it uses that SDK's newest build-tools and platform, else Debian's packages.
# Signed with KEYSTORE (its password in KEYSTORE_PASS), else with a key for tests that it makes.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
mode=debug targets=aarch64-linux-android out=
while [ $# -gt 0 ]; do
  case $1 in
    --release) mode=release ;;
    --targets) shift; targets=${1:?--targets needs a list} ;;
    -*) usage >&2; exit 2 ;;
    *) out=$1 ;;
  esac
  shift
done
[ -n "$out" ] || { usage >&2; exit 2; }
IFS=, read -r -a targets <<< "$targets"
api=28 work=target/apk/$mode
need_rust
need 'command -v python3' python3
need 'command -v readelf' binutils
rm -rf "$work"; mkdir -p "$work/lib" "$work/assets" "$(dirname "$out")"

tools/apk/libraries.sh $mode "$work/lib" "${targets[@]}"

if [ -n "${ANDROID_HOME:-}" ]; then
  tools_at=$(ls -d "$ANDROID_HOME"/build-tools/*/ | sort -V | tail -n 1)
  framework=$(ls "$ANDROID_HOME"/platforms/*/android.jar | sort -V | tail -n 1)
else
  need 'command -v aapt2 && command -v aapt' aapt
  need 'command -v zipalign' zipalign
  need 'command -v apksigner' apksigner
  need '[ -s /usr/share/android-framework-res/framework-res.apk ]' android-framework-res
  tools_at='' framework=/usr/share/android-framework-res/framework-res.apk
fi
need 'command -v keytool' default-jre-headless

cp src/demo/demo.avatar src/demo/demo.motion "$work/assets/"
"${tools_at}aapt2" compile --dir android/res -o "$work/res.zip"
debug=(); [ $mode = release ] || debug=(--debug-mode)
"${tools_at}aapt2" link -o "$work/bare.apk" -I "$framework" --manifest android/AndroidManifest.xml -A "$work/assets" ${debug[@]+"${debug[@]}"} "$work/res.zip"
python3 tools/apk/pack.py "$work/bare.apk" "$work/lib" "$work/unsigned.apk"

key=${KEYSTORE:-target/apk/test.keystore} pass=${KEYSTORE_PASS:-android}
if [ ! -s "$key" ]; then
  keytool -genkeypair -keystore "$key" -storepass "$pass" -keypass "$pass" -alias effigy -keyalg RSA -keysize 2048 -validity 10000 \
    -dname 'CN=Effigy for tests' 2>/dev/null
fi
[ $mode = debug ] || [ -n "${KEYSTORE:-}" ] || echo "signed with a key for tests; a store wants yours: KEYSTORE and KEYSTORE_PASS"
"${tools_at}apksigner" sign --ks "$key" --ks-pass "pass:$pass" --min-sdk-version $api --v1-signing-enabled false --v2-signing-enabled true \
  --v3-signing-enabled true --v4-signing-enabled false --out "$work/signed.apk" "$work/unsigned.apk"

python3 tools/apk/check.py "$work/signed.apk" --mode $mode --tools "$tools_at" --system target/apk/system
mv "$work/signed.apk" "$out"
echo "$out: $(stat -c %s "$out") bytes; install it with: adb install -r $out"
