// Messages of the programs: constants of their messages.hpp.
import {readFileSync} from 'node:fs';

/// The text of a constant, to the end of its first line.
export function message(name, header = 'window/messages.hpp') {
  const source = readFileSync(new URL(`../../${header}`, import.meta.url), 'utf8');
  const found = source.match(new RegExp(`\\b${name} =\\s+"([^"\\\\]+)`));
  if (!found) throw new Error(`${header} has no ${name}`);
  return found[1];
}
