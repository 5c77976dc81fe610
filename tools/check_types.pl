#!/usr/bin/env perl
# Checks that no two headers define a type of the same name, except as tools/shared-types.txt lists.
use strict;
use warnings;
use FindBin;
chdir "$FindBin::Bin/..";

my (%listed, %owner);
open my $list, '<', 'tools/shared-types.txt' or die "cannot read tools/shared-types.txt: $!\n";
while (<$list>) {
  next if /^\s*(?:#|$)/;
  /^(\w+)\s+(\d+)\s+(.+)$/ or die "tools/shared-types.txt:$.: expected NAME COUNT OWNER\n";
  ($listed{$1}, $owner{$1}) = ($2, $3);
}

# Types at the start of a line: those of a namespace, not those inside a class. Forward declarations do not count.
my %defined;
for my $file (split /\n/, `git ls-files --cached --others --exclude-standard --deduplicate -- '*.hpp'`) {
  next if !-f $file || $file =~ m{^(?:tests|benchmarks|fuzz|tools|controllers)/};
  open my $in, '<', $file or die "cannot read $file: $!\n";
  local $/;
  my $text = <$in>;
  $defined{$1}{$file} = 1 while $text =~ /^(?:class|struct|enum class|enum)\s+([A-Z]\w*)[^;{()]*\{/mg;
}

my $failed = 0;
for my $name (sort keys %defined) {
  my @files = sort keys %{$defined{$name}};
  my $allowed = $listed{$name} // 1;
  next if @files == $allowed;
  $failed = 1;
  my $where = join ', ', @files;
  if (@files < $allowed) {
    print STDERR "tools/shared-types.txt: $name is now defined in $where only: lower its count or delete the line\n";
  } else {
    print STDERR "$name is defined in $where: " . ($owner{$name} // 'one of them needs another name') . "\n";
  }
}
for my $name (sort keys %listed) {
  next if $defined{$name};
  $failed = 1;
  print STDERR "tools/shared-types.txt: no header defines $name: delete the line\n";
}
exit $failed;
