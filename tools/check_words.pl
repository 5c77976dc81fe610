#!/usr/bin/env perl
# Checks that no file uses a word of tools/words.txt.
#
#   tools/check_words.pl            the whole tree
#   tools/check_words.pl FILE...    these files
use strict;
use warnings;
use open qw(:std :encoding(UTF-8));
use FindBin;
chdir "$FindBin::Bin/.." unless @ARGV;

my @words;
open my $list, '<', "$FindBin::Bin/words.txt" or die "cannot read tools/words.txt: $!\n";
while (<$list>) {
  chomp;
  next if /^\s*(?:#|$)/;
  my ($exact, $pattern, $instead) = /^(=?)(.+?) -> (.+)$/ or die "tools/words.txt:$.: expected PATTERN -> REPLACEMENT\n";
  my $start = $pattern =~ /^,/ ? '' : '\b';
  my $regex = $exact ? qr/\b(?:$pattern)(?!\w)/ : qr/$start(?:$pattern)(?!\w)/i;
  push @words, {exact => $exact, pattern => $pattern, regex => $regex, instead => $instead};
}
# One expression each for a quick look at a line.
my $exact = join '|', map { $_->{pattern} } grep { $_->{exact} } @words;
my $plain = join '|', map { $_->{pattern} } grep { !$_->{exact} } @words;
$exact = qr/\b(?:$exact)(?!\w)/;
$plain = qr/(?:\b|(?=,))(?:$plain)(?!\w)/i;

# Findings of one file, as messages.
sub check {
  my ($file) = @_;
  my @found;
  my $is_code = $file =~ /\.[hc]pp$/;
  open my $text, '<', $file or die "cannot read $file: $!\n";
  while (my $line = <$text>) {
    chomp $line;
    next if $line =~ /keep-word/;
    my $split = $line;
    $split =~ s/([a-z0-9])([A-Z])/$1 $2/g;
    $split =~ s/([A-Z])([A-Z][a-z])/$1 $2/g;
    $split =~ s/_/ /g;
    my $code = $is_code ? $line =~ s/"[^"]*"|\/\/.*//gr : '';
    next unless $code =~ /$exact/ || $split =~ /$plain/;
    for my $word (@words) {
      my $where = $word->{exact} ? $code : $split;
      push @found, "$file:$.: $& -> use $word->{instead}" while $where =~ /$word->{regex}/g;
    }
  }
  return @found;
}

my @files = @ARGV;
if (!@files) {
  my @patterns = qw(*.md *.hpp *.cpp *.h *.c *.sh *.pl *.py *.cmake *CMakeLists.txt *.js *.mjs *.html *.css *.ini *.pml *.table *.tsv dev);
  my $patterns = join ' ', map { "'$_'" } @patterns;
  @files = grep { -f && !m{^(?:tests/webots/api/2013|tests/fuzz/corpus)/} }
    split /\n/, `git ls-files --cached --others --exclude-standard --deduplicate -- $patterns`;
}
my @found = map { check($_) } @files;
print STDERR "$_\n" for @found;
exit(@found ? 1 : 0);
