#!/usr/bin/env bash
# Every C++ file is as .clang-format says.
#   tests/architecture/format_test.sh SOURCE_DIR
set -euo pipefail
find "$1"/engine "$1"/app "$1"/tests -name '*.h' -o -name '*.cpp' | sort | xargs clang-format --dry-run -Werror
