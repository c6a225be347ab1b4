#!/bin/bash
# check.sh formatted|ascii|finished|snippets, from the project's root.
set -euo pipefail

cpp_files() {
  find src cli tests samples -name '*.h' -o -name '*.cpp' | sort
}
text_files() {
  cpp_files
  find src cli tests samples cmake .ci -name '*.cmake' -o -name '*.sh' \
    -o -name '*.py' -o -name CMakeLists.txt | sort
  ls CMakeLists.txt CMakePresets.json .ci/run
}

case ${1:-} in
  formatted)
    # Other versions of clang-format disagree on details.
    if ! command -v clang-format-14 >/dev/null; then
      echo "SKIPPED: clang-format-14 is not installed" >&2
      exit 77
    fi
    cpp_files | xargs clang-format-14 --dry-run --Werror
    ;;
  ascii)
    if text_files | LC_ALL=C xargs grep -nP '[^\x00-\x7F]'; then
      echo "the lines above hold characters beyond ASCII" >&2
      exit 1
    fi
    ;;
  finished)
    # The pattern is split so that this line does not match itself. Tables of
    # what was learned are letters by chance.
    if text_files | grep -vE 'warm_start_[a-z]+\.cpp$' | xargs grep -nE 'TO''DO|FIX''ME|XX''X'; then
      echo "the lines above are marked as unfinished" >&2
      exit 1
    fi
    ;;
  snippets)
    # Every line of C++ in the README is a line of the compiled example.
    sed -n '/^```cpp$/,/^```$/p' README.md | grep -v '^```' |
      sed 's/^ *//' | grep . | while IFS= read -r line; do
      if ! sed 's/^ *//' samples/compress_bitmap.cpp | grep -qxF -- "$line"
      then
        echo "README.md: not in samples/compress_bitmap.cpp: $line" >&2
        exit 1
      fi
    done
    ;;
  *)
    echo "usage: check.sh formatted|ascii|finished|snippets" >&2
    exit 2
    ;;
esac
