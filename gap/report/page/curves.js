// The curves of a report: rows of its charts, and values at a time.
"use strict";
const curvesOf = (data) => {
  const kinds = [
    { key: "goal", label: "goal", dashed: true },
    { key: "measured", label: "measured" },
    { key: "before", label: "before" },
    { key: "after", label: "after" },
  ];
  const scaled = (values, unit) => values.map((v) => (v === null ? NaN : v * unit));

  // Angles in rad, differences in mrad.
  function rowsOf(log) {
    const t = scaled(log.t, data.time_unit_s);
    const angle = {};
    for (const kind of kinds) angle[kind.key] = scaled(log[kind.key], data.angle_unit_rad);
    const position = t.map((x, i) => [x].concat(kinds.map((kind) => angle[kind.key][i])));
    const off = (key, i) => 1000 * (angle.measured[i] - angle[key][i]);
    return { position, difference: t.map((x, i) => [x, off("before", i), off("after", i)]) };
  }

  // Of the row closest to time x, rad.
  function valuesAt(log, x) {
    let best = 0;
    log.t.forEach((t, i) => {
      if (Math.abs(t * data.time_unit_s - x) < Math.abs(log.t[best] * data.time_unit_s - x)) best = i;
    });
    const of = (key) => (log[key][best] === null ? NaN : log[key][best] * data.angle_unit_rad);
    return Object.fromEntries(kinds.map(({ key }) => [key, of(key)]));
  }

  return { kinds, rowsOf, valuesAt };
};
