# shellcheck shell=bash disable=SC2034
# Sourced by tests/run.sh and samples/demo.sh: the Debian packages the project
# needs, and a function that installs those that are missing.

needs_build="cmake g++ ninja-build zlib1g-dev libpng-dev libtiff-dev
  libjpeg-dev libminizip-dev libopencv-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libpugixml-dev"
needs_tests="libgtest-dev libgmock-dev python3 clang-format-14 poppler-utils"
# Programs that read our vector files, for the label clients.
needs_clients="librsvg2-bin libxml2-utils hp2xx python3-ezdxf"
# The decoder of firmware on a simulated controller, for the label firmware.
needs_firmware="gcc-avr avr-libc libsimavr-dev libelf-dev"
# Control software that reads our programs, for the label linuxcnc: large.
needs_controls="linuxcnc-uspace bcnc"
needs_demo="netpbm"

# install_missing package...: does nothing if all are there. Needs root or
# sudo otherwise. On other systems it says what is needed and goes on.
install_missing() {
  if ! command -v dpkg-query >/dev/null; then
    echo "not a Debian system; these packages must be there: $*" >&2
    return 0
  fi
  local package missing=()
  for package in "$@"; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" \
         != installed ]; then
      missing+=("$package")
    fi
  done
  if [ ${#missing[@]} -eq 0 ]; then return 0; fi

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "missing packages, and neither root nor sudo: ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "installing: ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq update </dev/null
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq install -y --no-install-recommends "${missing[@]}" \
    </dev/null >/dev/null
}
