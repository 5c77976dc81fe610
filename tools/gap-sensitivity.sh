#!/usr/bin/env bash
# gap-sensitivity.sh CASES KEY RESULTS: what does half and twice each constant of gap/thresholds.hpp do to a suite? Builds
# darwinop gap once, in a checkout of its own, with constants that the environment scales, and runs the suite for each of
# them. Appends to RESULTS a line a run: constant, factor, fair answers, cases, cases with another answer than without a
# factor. Lines that are there are not run again, so it can be stopped at any time. SENSITIVITY_JOBS: cases at once (1).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
[ $# = 3 ] || { sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
cases=$(readlink -f "$1") key=$(readlink -f "$2") results=$(readlink -f "$3")
tree=$PWD/build/sensitivity
header=$tree/gap/thresholds.hpp
. tools/dev/build.sh

# What sizes an array, seeds a draw or is counted as a statistic stays.
fixed='kMaxRipplesPerTurn|kResidualLevels|kBootstrapSeed|kInterval90'

scalable() {
  perl -ne 'next unless s/^inline constexpr (?:double|int|std::size_t) //; print "$1\n" while /(\w+) = /g' gap/thresholds.hpp |
    grep -vxE "$fixed"
}

make_scalable() {
  FIXED=$fixed perl -pi -e '
    s{^namespace darwinop::gap::thresholds \{}{
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <type_traits>

$&

template <typename T>
T scaled(const char* name, T value) {
  const char* wanted = std::getenv("DARWINOP_THRESHOLD");
  if (wanted == nullptr || std::strcmp(wanted, name) != 0) return value;
  const double by = std::atof(std::getenv("DARWINOP_FACTOR")) * static_cast<double>(value);
  return static_cast<T>(std::is_integral_v<T> ? std::ceil(by) : by);
}
};
    if (/^inline constexpr (double|int|std::size_t) (.*);$/) {
      my $type = $1;
      $_ = join "", map {
        my ($name, $value) = split / = /;
        $name =~ /^(?:$ENV{FIXED})$/ ? "inline constexpr $type $name = $value;\n"
                                     : "inline const $type $name = scaled<$type>(\"$name\", $value);\n"
      } split /, /, $2;
    }' "$header"
}

# run CONSTANT FACTOR: the suite with it; prints the folder's results file.
run() {
  local out=$tree/build/results-$1-$2.json
  DARWINOP_THRESHOLD=$1 DARWINOP_FACTOR=$2 "$tree/build/release/bin/darwinop-gap" benchmark run "$cases" --resume --out "$out" \
    --jobs "${SENSITIVITY_JOBS:-1}" >"$tree/build/run.log" 2>&1 || { cat "$tree/build/run.log" >&2 && exit 1; }
  echo "$out"
}

# answers FILE: a line a case: its name, verdict and effects.
answers() { jq -r '.[] | [.case, .verdict, ([.effects[]?.id] | join("+"))] | @tsv' "$1" | sort; }

touch "$results"
[ -d "$tree" ] || git worktree add --detach "$tree" HEAD >/dev/null
git -C "$tree" checkout -q -- .
git -C "$tree" checkout -q --detach HEAD
make_scalable
sed -i 's/constexpr double kLost/const double kLost/' "$tree/gap/fit/noise.cpp"  # made of one of them
(cd "$tree" && CXXFLAGS=-Wno-error=conversion build release-tests darwinop-gap)
plain=$(run none 1)
scalable | while read -r constant; do
  for factor in 0.5 2; do
    ! grep -q "^$constant	$factor	" "$results" || continue
    scaled=$(run "$constant" "$factor")
    fair=$("$tree/build/release/bin/darwinop-gap" benchmark score --json "$scaled" "$key" | jq -r '[.fair.right, .cases] | @tsv')
    changed=$(diff <(answers "$plain") <(answers "$scaled") | grep -c '^>' || :)
    printf '%s\t%s\t%s\t%s\n' "$constant" "$factor" "$fair" "$changed" | tee -a "$results"
  done
done
