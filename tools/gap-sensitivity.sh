#!/usr/bin/env bash
# gap-sensitivity.sh CASES [CONSTANT...]: what do half and twice each constant of gap/thresholds.hpp do to the answers of
# darwinop gap? Builds it once, in a checkout of its own, with constants that count what half and twice would have
# decided otherwise (tools/gap-sensitivity.hpp). Where nothing would, the answer of a case is the same; else the case is
# run again. Prints a line a constant: cases with another answer, and cases examined, at half and at twice; uses
# in the suite (-: not counted).
#
# What has been run is kept in build/sensitivity/build/runs, for each state of gap/, so it can be stopped at any time.
# SENSITIVITY_SECONDS: cases that took longer at first are not run again (1e9). 0: nothing is.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
[ $# -ge 1 ] || { sed -n '2,10s/^# \?//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
cases=$(readlink -f "$1")
shift
tree=$PWD/build/sensitivity
runs=$tree/build/runs/$(git rev-parse --short HEAD:gap)
program=$tree/build/release/bin/darwinop-gap
. tools/dev/build.sh

# What sizes an array, seeds a draw, is counted as a statistic or chooses words of a report stays.
fixed='kMaxRipplesPerTurn|kResidualLevels|kBootstrapSeed|kInterval90|kBelowFloorShare|kUnchangedGapShare'
# What the code hands to Eigen and the like; the other constants are tracked.
numbers='kFinestInterval|kCorrelatedSamples|k\w*RobustSigmas|kDiscrepancyTime|kAbsorbedSigmas|kNuisanceStepSigmas'
numbers+='|kNoise\w*HalfWindow|kFewRunsFactor|kImpossibleSigmas|kRepeatsHalfWindow|kSpreadOf\w+|kIndependentShare'
numbers+='|kScreenRippleTorque|kRippleTorque|kRippleWindow|kRipplePeriod|kRefinePriorSigmas|kFarthestPriorSigmas'
numbers+='|kLeastPriorShare|kFirst\w*Step\w*|kSmallestScale|kLongestStep|kShortestStep|kLeastStepRoom|kSolver\w+'
numbers+='|kInvalidSteps|kJumpGain\w*|kSpeedLawWindow|k\w+Iterations|kStateHalfWindow|kLongestFold|kFoldedLoadJump'
numbers+='|kSpeedLag|kSpeedScale'

constants() {
  perl -ne 'next unless s/^inline constexpr (?:double|int|std::size_t) //; print "$1\n" while /(\w+) = /g' gap/thresholds.hpp |
    grep -vxE "$fixed"
}

# Constants of the checkout become tracked; what is computed from them stays so up to the comparison.
track() {
  (
    cd "$tree"
    FIXED=$fixed NUMBERS=$numbers perl -pi -e '
      next unless /^inline constexpr (double|int|std::size_t) (.*);$/;
      my $type = $1;
      $_ = join "", map {
        my ($name, $value) = split / = /;
        my $set = "setting<$type>(\"$name\", $value)";
        $name =~ /^(?:$ENV{FIXED})$/     ? "inline constexpr $type $name = $value;\n"
        : $name =~ /^(?:$ENV{NUMBERS})$/ ? "inline const $type $name = $set;\n"
        : "inline Margin ${name}_margin{\"$name\"};\ninline const Tracked ${name}{${name}_margin, $set};\n"
      } split /, /, $2;' gap/thresholds.hpp
    cat "$OLDPWD/tools/gap-sensitivity.hpp" gap/thresholds.hpp >thresholds.tracked
    mv thresholds.tracked gap/thresholds.hpp
    perl -0pi -e '
      s/constexpr( double \w+ =\s+[^;]*thresholds::)/const$1/g;
      s/\bconst (?:double|int) (\w+ =[^;,]*thresholds::)/const auto $1/g;
      s/(\bconst double \w+ = [^;,]*), (\w+ = thresholds::)/$1; const auto $2/g;
      s/(\? thresholds::\w+) : (1|threshold)\b/$1 : thresholds::Tracked{static_cast<double>($2)}/g;
      s/\? 1 : ([\d.]+ \* thresholds::\w+)/? thresholds::Tracked{1.0} : $1/g;
      s/\bdouble ((?:Selection::)?(?:leastGain|leastGainOf|neededFor)\()/thresholds::Tracked $1/g;
      s/\bdouble needed\b/const thresholds::Tracked& needed/g;
      s/(gain = 0), needed = 0;/$1; thresholds::Tracked needed{0};/;
      s/, needed = neededFor/; const auto needed = neededFor/;
      s/\badd\(best, gain, threshold_,/add(best, gain, thresholds::Tracked{threshold_},/;
      s/gain, needed\);(\s+if \(!passes)/gain, +needed);$1/;
      s/std::size_t (most = thresholds::)/thresholds::Tracked $1/;
      s/keepFirst\(std::size_t most/keepFirst(const thresholds::Tracked& most/;
    ' gap/{fit,identify,localize}/*.[ch]pp
    perl -pi -e 's/thresholds::k\w+/(+$&)/g' gap/report/*.cpp
    perl -pi -e 's/constexpr( auto \w+ = [^;]*thresholds::)/const$1/g' gap/plant/body/*.cpp
    perl -pi -e 's/static constexpr( std::array kEffects)/static const$1/' gap/identify/body/sensor_effect.cpp
  )
}

# Localization changes no verdict and no effect: constants that only it uses need no identification.
only_locates() { ! grep -rlw "$1" gap --include=*.cpp --include=*.hpp | grep -qvE '^gap/(localize/|thresholds.hpp)'; }

# run CASE KIND [CONSTANT FACTOR]: KIND is identify or locate. Prints the name of its files, without .json and .margins.
run() {
  local out=$runs/$2/$1${3:+/$3-$4} alone
  if [ ! -e "$out.json" ]; then
    mkdir -p "$(dirname "$out")"
    rm -f "$out.margins"
    alone=$(mktemp -d)
    ln -s "$cases/$1" "$alone/$1"
    export DARWINOP_MARGINS=$out.margins DARWINOP_THRESHOLD=${3:-} DARWINOP_FACTOR=${4:-1}
    if [ "$2" = locate ]; then
      "$program" locate "$cases/$1" --json >"$out.new" || exit 1
    else
      "$program" benchmark run "$alone" --out "$out.new" >"$runs/log" 2>&1 || { cat "$runs/log" >&2 && exit 1; }
    fi
    mv "$out.new" "$out.json"
    rm -r "$alone"
  fi
  echo "$out"
}

# answer FILES: verdict and effects; of a localization the blocks of the loop.
answer() {
  jq -r 'if type == "array" then .[0] | .verdict, (.effects[]?.id)
    else .first_block, (.blocks[] | .block, .verdict) end' "$1.json"
}

# may_differ CASE CONSTANT FACTOR: with it a comparison is decided otherwise, or the constant is used as a number.
may_differ() {
  awk -v name="$2" -v factor="$3" '$1 == name { found = 1; differs = (factor < 1 ? $3 : $4) || $5 }
    END { exit !(differs || !found) }' "$runs/identify/$1.margins"
}

# examine CONSTANT FACTOR: how many cases have another answer, and how many were examined.
examine() {
  local case examined=0 other=0 kind=identify
  if only_locates "$1"; then kind=locate; fi
  for case in "${names[@]}"; do
    if may_differ "$case" "$1" "$2"; then
      [ "$kind" = locate ] || may_take_as_long_as "$case" || continue
      [ "$(answer "$(run "$case" "$kind")")" = "$(answer "$(run "$case" "$kind" "$1" "$2")")" ] || other=$((other + 1))
    fi
    examined=$((examined + 1))
  done
  printf '%s\t%s' "$other" "$examined"
}
may_take_as_long_as() {
  jq -e --argjson most "${SENSITIVITY_SECONDS:-1e9}" '.[0].runtime_s <= $most' "$runs/identify/$1.json" >/dev/null
}

if [ ! -d "$tree" ]; then git worktree add --detach "$tree" HEAD >/dev/null; fi
git -C "$tree" checkout -q -- .
git -C "$tree" checkout -q --detach HEAD
track
(cd "$tree" && CXXFLAGS="-Wno-error=conversion -Wno-error=float-conversion" build release darwinop-gap) >&2
mapfile -t names < <(cd "$cases" && printf '%s\n' */case.json | sed 's|/.*||')
mkdir -p "$runs"
for name in "${names[@]}"; do run "$name" identify >/dev/null; done
[ $# -gt 0 ] || mapfile -t all < <(constants)
printf 'constant\thalf: other\tof\ttwice: other\tof\tuses\n'
for constant in "${@:-${all[@]}}"; do
  half=$(examine "$constant" 0.5) twice=$(examine "$constant" 2)
  compared=$(cat "$runs"/identify/*.margins |
    awk -v name="$constant" '$1 == name { found = 1; n += $2 + $5 } END { print found ? n + 0 : "-" }')
  printf '%s\t%s\t%s\t%s\n' "$constant" "$half" "$twice" "$compared"
done
