# Sourced by scripts that run something on one of the drivers that tools/drivers.sh gathers.

# Makes a driver the only one, and loads the validation layer beside it.
use_driver() { # DRIVER[:VECTOR WIDTH], or system for what this machine has
  unset VK_DRIVER_FILES VK_ICD_FILENAMES LP_NATIVE_VECTOR_WIDTH MESA_SHADER_CACHE_DIR
  if [ "$1" != system ]; then
    local icd="$PWD/target/drivers/${1%%:*}.json"
    [ -s "$icd" ] || { echo "no driver called $1" >&2; exit 2; }
    export VK_DRIVER_FILES=$icd VK_ICD_FILENAMES=$icd
    case $1 in *:*) export LP_NATIVE_VECTOR_WIDTH=${1##*:} ;; esac
    # Mesa's cache does not tell vector widths apart: with kernels of another width, images lose squares.
    export MESA_SHADER_CACHE_DIR=$PWD/target/drivers/cache/$1
  fi
  export VK_LAYER_PATH=$PWD/target/drivers/layers VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=1
}
