#!/usr/bin/env perl
# Checks that no file uses a word of tools/words.txt, except in the places listed in tools/words-todo.txt.
#
#   tools/check_words.pl            the whole tree; also fails when a listed place is clean, so that the list shrinks
#   tools/check_words.pl FILE...    these files, listed or not
#   tools/check_words.pl renew      writes tools/words-todo.txt: every place that fails now; prints those that are new
#
# A line of words-todo.txt is a file, or a folder with a slash at its end: its files, not those of folders in it.
use strict;
use warnings;
use open qw(:std :encoding(UTF-8));
use FindBin;
chdir "$FindBin::Bin/.." unless @ARGV && $ARGV[0] ne 'renew';

my $todo_file = 'tools/words-todo.txt';
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

if (@ARGV && $ARGV[0] ne 'renew') {
  my @found = map { check($_) } @ARGV;
  print STDERR "$_\n" for @found;
  exit(@found ? 1 : 0);
}

my @patterns = qw(*.md *.hpp *.cpp *.h *.c *.sh *.pl *.py *.cmake *CMakeLists.txt *.js *.mjs *.html *.css *.ini *.pml dev);
my $files = join ' ', map { "'$_'" } @patterns;
my %todo;
if (open my $in, '<', $todo_file) {
  while (<$in>) {
    chomp;
    $todo{$_} = 0 unless /^\s*(?:#|$)/;
  }
}
my (@messages, %places);
for my $file (split /\n/, `git ls-files --cached --others --exclude-standard --deduplicate -- $files`) {
  next if !-f $file || $file =~ m{^(?:tests/webots/api/2013|tests/fuzz/corpus)/};
  my @found = check($file) or next;
  my $folder = $file =~ m{^(.*/)} ? $1 : '';
  my $place = $file =~ /\.md$/ || $folder eq '' ? $file : $folder;
  $places{$place}++;
  my ($listed) = grep { exists $todo{$_} } $file, $folder;
  if (defined $listed) { $todo{$listed}++ }
  else { push @messages, @found }
}

if (@ARGV) {
  open my $out, '>', $todo_file or die "cannot write $todo_file: $!\n";
  print $out "# Places that still use words of words.txt, one a line: delete the line with the last word.\n";
  for my $place (sort keys %places) {
    print $out "$place\n";
    print "added $place\n" unless exists $todo{$place};
  }
  exit 0;
}
push @messages, map { "$todo_file: $_ is clean: delete its line" } grep { !$todo{$_} } sort keys %todo;
print STDERR "$_\n" for @messages;
exit(@messages ? 1 : 0);
