#!/usr/bin/env perl
# Checks that no two headers define a type of the same name. Those of webots/include do not count: they are upstream's.
use strict;
use warnings;
use FindBin;
chdir "$FindBin::Bin/..";

# Types at the start of a line: those of a namespace, not those inside a class. Forward declarations do not count.
my %defined;
for my $file (split /\n/, `git ls-files --cached --others --exclude-standard --deduplicate -- '*.hpp'`) {
  next if !-f $file || $file =~ m{^(?:tests|benchmarks|fuzz|tools|controllers|webots/include)/};
  open my $in, '<', $file or die "cannot read $file: $!\n";
  local $/;
  my $text = <$in>;
  $defined{$1}{$file} = 1 while $text =~ /^(?:class|struct|enum class|enum)\s+([A-Z]\w*)\b(?!::)[^;{()]*\{/mg;
}

my $failed = 0;
for my $name (sort keys %defined) {
  my @files = sort keys %{$defined{$name}};
  next if @files == 1;
  $failed = 1;
  print STDERR "$name is defined in " . join(', ', @files) . ": one of them needs another name\n";
}
exit $failed;
