# Compares two recordings (docs/logs.md) column by column and row by row: -v tolerance=T -v what=NAME FIRST SECOND.
# Empty means "not known" and equals only empty.
BEGIN { FS = "," }

function wrong(text) {
  if (++failures <= 5) print what ": " text
}

function difference(a, b) {
  return a > b ? a - b : b - a
}

/^#/ { next }  # the head names program, commit and date

FNR == NR {
  first[++first_rows] = $0
  next
}

++second_rows > first_rows { next }

second_rows == 1 {
  columns = split($0, name, ",")
  if ($0 != first[1]) wrong("the columns are not the same")
  next
}

{
  fields = split(first[second_rows], expected, ",")
  if (fields != columns || NF != columns) wrong("row " second_rows " has " fields " and " NF " fields, not " columns)
  for (i = 1; i <= columns; i++) {
    if (expected[i] == $i) continue
    if (expected[i] == "" || $i == "") {
      wrong("cycle " $2 ", " name[i] ": '" expected[i] "' and '" $i "'")
      continue
    }
    off = difference(expected[i] + 0, $i + 0)
    if (off > greatest) {
      greatest = off
      where = " (" name[i] ", cycle " $2 ")"
    }
    if (!(off <= tolerance)) wrong("cycle " $2 ", " name[i] ": " expected[i] " and " $i " differ by " off)
  }
}

END {
  if (first_rows < 100) wrong("only " first_rows + 0 " rows: nothing was compared")
  if (first_rows != second_rows) wrong(first_rows " and " second_rows " rows")
  if (failures) {
    print what ": " failures " differences"
    exit 1
  }
  printf "%s: %d rows of %d columns are equal within %g; greatest difference %g%s\n", what, first_rows - 1, columns,
         tolerance, greatest, where
}
