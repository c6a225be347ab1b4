#!/bin/bash
# Installs what is missing, builds and runs the tests. See --help.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. tests/needs.sh

usage() {
  cat <<'END'
usage: tests/run.sh [--preset NAME]... [--label REGEX] [--jobs N]
                    [--controls | --no-install]

Builds under build/ and runs the tests with ctest: under the sanitizers those
that read foreign or damaged bytes (labels golden, corrupt, fuzz), then
all but the label slow in the optimised build with assertions. The last lines are ctest's
own summary: of the last run, or of the first that failed.

  --preset NAME  only this preset of CMakePresets.json; may be repeated
  --label REGEX  only tests whose label matches; slow is run only so
  --jobs N       parallel compilations and tests (default: all cores)
  --controls     install LinuxCNC and bCNC too, which the tests of the label
                 linuxcnc skip without; several hundred MB
  --no-install   never call apt-get

Exit code: 0 all passed, 1 something failed, 2 usage.

  tests/run.sh
  tests/run.sh --preset dev --label 'unit|cli'
  tests/run.sh --preset dev --label slow
  tests/run.sh --controls --preset dev --label linuxcnc
  tests/run.sh --preset asan-ubsan --label unit
END
}

presets=()
label=
jobs=$(nproc)
install=yes
controls=no
while [ $# -gt 0 ]; do
  case $1 in
    --preset | --label | --jobs)
      if [ $# -lt 2 ]; then echo "run.sh: $1 needs a value" >&2; exit 2; fi
      case $1 in
        --preset) presets+=("$2") ;;
        --label) label=$2 ;;
        --jobs) jobs=$2 ;;
      esac
      shift 2 ;;
    --controls) controls=yes; shift ;;
    --no-install) install=no; shift ;;
    --help | -h) usage; exit 0 ;;
    *) echo "run.sh: unknown option $1" >&2; usage >&2; exit 2 ;;
  esac
done
if [ ${#presets[@]} -eq 0 ]; then presets=(asan-ubsan dev); fi

if [ $install = yes ]; then
  # Lists of words, from needs.sh.
  # shellcheck disable=SC2086,SC2154
  install_missing $needs_build $needs_tests $needs_clients $needs_firmware $needs_demo
  # One by one: a system may have the one and not the other.
  if [ $controls = yes ]; then
    # shellcheck disable=SC2154
    for package in $needs_controls; do
      install_missing "$package" ||
        echo "run.sh: $package cannot be installed; its tests are skipped" >&2
    done
  fi
fi

# The tests that run in a preset by default; all but slow in those not named.
default_label() {
  case $1 in
    asan-ubsan) echo 'golden|corrupt|fuzz' ;;
  esac
}

# What is built in a preset by default; everything in those not named.
default_target() {
  case $1 in
    asan-ubsan) echo sanitizer_tests ;;
    *) echo all ;;
  esac
}

# run_preset name: 0 if it builds and passes; the ctest output is kept.
run_preset() {
  local preset=$1 generator=() chosen=()
  local labels=${label:-$(default_label "$preset")}
  if [ ! -e "build/$preset/CMakeCache.txt" ] && command -v ninja >/dev/null
  then
    generator=(-G Ninja)
  fi
  if [ -n "$labels" ]; then chosen=(-L "$labels"); else chosen=(-LE slow); fi
  echo "== $preset: build"
  cmake --preset "$preset" "${generator[@]}" --log-level=WARNING >/dev/null ||
    return 1
  local target=all
  if [ -z "$label" ]; then target=$(default_target "$preset"); fi
  cmake --build "build/$preset" -j "$jobs" --target "$target" || return 1
  echo "== $preset: test"
  ctest --test-dir "build/$preset" -j "$jobs" --output-on-failure \
    --no-tests=error "${chosen[@]}" </dev/null 2>&1 |
    tee "build/$preset/ctest.log"
}

# The part of a ctest log from "100% tests passed" on.
summary() { sed -n '/tests passed, /,$p' "build/$1/ctest.log"; }

failed=()
started=$SECONDS
for preset in "${presets[@]}"; do
  rm -f "build/$preset/ctest.log"
  if ! run_preset "$preset"; then failed+=("$preset"); fi
done

echo
echo "== ran ${presets[*]} in $((SECONDS - started)) s"
if [ ${#failed[@]} -gt 0 ]; then
  echo "== FAILED: ${failed[*]}"
  if [ -e "build/${failed[0]}/ctest.log" ]; then
    summary "${failed[0]}"
  else
    echo "${failed[0]} does not build, see above"
  fi
  exit 1
fi
summary "${presets[-1]}"
