#!/usr/bin/env perl
# Checks that every public method of an installed header has a /// comment, and that the comment names a unit or a range
# where the method takes or returns a number. Destructors and enumerators need none.
#
#   tools/check_headers.pl            all installed headers; prints the share of comment lines
#   tools/check_headers.pl FILE...    these files
use strict;
use warnings;

# A unit, a range, or a reference to the method that has them. A bare number is neither.
my $unit = qr{-?\d[\w.]*\s(?:to|or)\s-?\d|(?<!')\b(?:rad|rad/s2?|N\sm|ms|us|s|V|J|m|g|Hz|degrees?|deg/s|[Pp]ixels?|percent|bytes?|counts?|Kp)\b|\bSame\sas\b|\bno\sunit\b|\b[Aa]s\s\w+\(\)|\bNumber\sof\b|\bby\sname\b|\bWB_\w+|\bnever\b.*\bNULL\b};
my $number = qr/\b(?:int|unsigned|long|float|double|size_t)\b/;

sub check {
  my ($file) = @_;
  open my $in, '<', $file or die "cannot read $file: $!\n";
  my (@found, @comment, @depth);
  my ($statement, $start, $public, $body) = ('', 0, 0, 0);
  while (my $line = <$in>) {
    chomp $line;
    if ($line =~ m{^\s*///\s?(.*)}) {
      push @comment, $1;
      next;
    }
    $line =~ s{//.*}{};
    if ($line =~ /^\s*$/) {
      @comment = () if $statement eq '';
      next;
    }
    if ($line =~ /^\s*(public|protected|private):/) {
      $public = $1 eq 'public';
      @comment = ();
      next;
    }
    if ($statement eq '' && $line =~ /^\s*(class|struct)\s+\w+[^;]*\{\s*$/) {
      $public = $1 eq 'struct';
      @comment = ();
      next;
    }
    if ($line =~ /^\s*};/) {
      $public = 0;
      next;
    }
    next if $line =~ /^\s*(?:#|namespace|\})/ && $body == 0;
    $start = $. if $statement eq '';
    $statement .= "$line ";
    $body = () = $statement =~ /\{/g;
    $body -= () = $statement =~ /\}/g;
    next if $body > 0 || $statement !~ /[;}]\s*$/;
    my $comment = join ' ', @comment;
    my $declared = $statement;
    ($statement, $body) = ('', 0);
    @comment = ();
    (my $head = $declared) =~ s/\{.*//s;
    next unless $public && $head =~ /([~\w=]+)\s*\(/ && $head !~ /^\s*(?:enum|using|friend|typedef)\b/;
    my $name = $1;
    next if $name =~ /^~/ || $head =~ /~\w+\s*\(/;
    $name = 'operator=' if $head =~ /operator=/;
    if ($comment !~ /\w/) {
      push @found, "$file:$start: $name() has no /// comment";
    } elsif ($head =~ $number && $comment !~ $unit) {
      push @found, "$file:$start: $name(): name unit or range of its numbers";
    }
  }
  return @found;
}

my @files = @ARGV ? @ARGV : split /\n/, `git ls-files --cached --others --exclude-standard -- 'webots/include/*.hpp' 'managers/include/*.hpp'`;
my @found = map { check($_) } @files;
print STDERR "$_\n" for @found;
unless (@ARGV) {
  my ($comments, $all) = (0, 0);
  for my $file (@files) {
    open my $in, '<', $file or die "cannot read $file: $!\n";
    while (<$in>) { $all++; $comments++ if m{^\s*//} }
  }
  printf "public headers: %d of %d lines are comments, %.0f %%\n", $comments, $all, 100 * $comments / $all;
}
exit(@found ? 1 : 0);
