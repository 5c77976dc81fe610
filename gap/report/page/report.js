// Draws the curves that stand in this page as JSON. Texts from logs are only ever put in as text, never as HTML.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const root = document.documentElement;
  const byId = (id) => document.getElementById(id);
  const { kinds, rowsOf, valuesAt } = curvesOf(data);
  const visible = { goal: true, measured: true, before: true, after: true };
  let current = 0;
  let marked = null; // [from, to] that a link named, s
  let charts = [];
  let whole = [0, 1];

  const dark = () => root.classList.contains("dark");
  const inkOf = (name) => getComputedStyle(root).getPropertyValue("--" + name).trim();
  const colour = (key) => (key === "measured" ? inkOf("ink") : key === "goal" ? inkOf("floor") : inkOf(key));
  const shortNumber = (v, digits) => (Number.isFinite(v) ? v.toFixed(digits) : "–");

  function element(kind, parent, text) {
    const made = document.createElement(kind);
    if (text !== undefined) made.textContent = text;
    parent.appendChild(made);
    return made;
  }

  // The interval that a link named, and the band of noise.
  function underlay(band) {
    return (canvas, area, graph) => {
      canvas.save();
      if (band > 0) {
        const high = graph.toDomYCoord(band), low = graph.toDomYCoord(-band);
        canvas.globalAlpha = 0.25;
        canvas.fillStyle = inkOf("floor");
        canvas.fillRect(area.x, high, area.w, low - high);
      }
      if (marked !== null) {
        const left = graph.toDomXCoord(marked[0]), right = graph.toDomXCoord(marked[1]);
        canvas.globalAlpha = 0.16;
        canvas.fillStyle = inkOf("before");
        canvas.fillRect(left, area.y, right - left, area.h);
      }
      canvas.restore();
    };
  }

  function chart(place, rows, keys, band) {
    const tick = (v) => String(Number(v.toPrecision(6)));
    const options = {
      labels: ["t"].concat(keys),
      colors: keys.map(colour),
      series: { goal: { strokePattern: [6, 4], stepPlot: true, strokeWidth: 1.2 }, measured: { strokeWidth: 2.4 } },
      strokeWidth: 1.6,
      legend: "never",
      axisLineColor: inkOf("floor"),
      gridLineColor: inkOf("line"),
      axisLabelFontSize: 13,
      rightGap: 10,
      yRangePad: 6,
      visibility: keys.map((key) => visible[key]),
      underlayCallback: underlay(band),
      zoomCallback: (from, to) => follow(from, to),
      highlightCallback: (_event, x) => showValues(x),
      unhighlightCallback: () => (byId("at").textContent = ""),
      axes: {
        x: { pixelsPerLabel: 50, axisLabelFormatter: tick },
        y: { axisLabelWidth: 58, pixelsPerLabel: 34, axisLabelFormatter: tick },
      },
      drawCallback: (graph, first) => {
        if (!first) follow(...graph.xAxisRange());
      },
    };
    return new Dygraph(place, rows, options);
  }

  function showValues(x) {
    const values = valuesAt(data.logs[current], x);
    const value = (key) => shortNumber(values[key], 4);
    byId("at").textContent = " at " + shortNumber(x, 3) + " s: measured " + value("measured") + ", before " +
      value("before") + ", after " + value("after");
  }

  // Both charts show the same time.
  let following = false;
  function follow(from, to) {
    if (following || charts.length < 2) return;
    following = true;
    const low = Math.max(whole[0], Math.min(from, whole[1] - 0.01)), high = Math.min(whole[1], Math.max(to, low + 0.01));
    for (const graph of charts) graph.updateOptions({ dateWindow: [low, high] });
    byId("range").textContent = shortNumber(low, 2) + " to " + shortNumber(high, 2) + " s";
    following = false;
  }

  const range = () => charts[0].xAxisRange();
  function zoom(factor) {
    const [from, to] = range(), middle = (from + to) / 2, half = ((to - from) / 2) * factor;
    follow(middle - half, middle + half);
  }
  function move(share) {
    const [from, to] = range();
    const step = Math.max(whole[0] - from, Math.min(whole[1] - to, (to - from) * share));
    follow(from + step, to + step);
  }
  function showWhole() {
    marked = null;
    for (const graph of charts) graph.updateOptions({ valueRange: null });
    follow(...whole);
  }

  function draw() {
    const log = data.logs[current];
    const rows = rowsOf(log);
    for (const graph of charts) graph.destroy();
    charts = [];
    const made = [
      chart(byId("position"), rows.position, kinds.map((kind) => kind.key), 0),
      chart(byId("difference"), rows.difference, ["before", "after"], log.floor_mrad),
    ];
    whole = [rows.position[0][0], rows.position[rows.position.length - 1][0]];
    charts = made;
    byId("log").value = String(current);
    byId("role").textContent = log.held_out ? "held out: not used by any fit" : "fitted";
    byId("role").className = log.held_out ? "held-out" : "fitted";
    for (const swatch of document.querySelectorAll(".swatch")) swatch.style.borderColor = colour(swatch.dataset.key);
    follow(...whole);
  }

  function choose(index, interval) {
    current = (index + data.logs.length) % data.logs.length;
    marked = interval || null;
    draw();
    if (marked === null) return;
    const around = Math.max(0.4, marked[1] - marked[0]);
    follow(marked[0] - around, marked[1] + around);
  }

  function build() {
    byId("viewer").hidden = false;
    data.logs.forEach((log, i) => {
      element("option", byId("log"), log.file + " · " + log.kind + (log.held_out ? " · held out" : " · fitted")).value = String(i);
    });
    for (const kind of kinds) {
      const label = element("label", byId("shown"));
      const box = element("input", label);
      box.type = "checkbox";
      box.checked = true;
      box.addEventListener("change", () => {
        visible[kind.key] = box.checked;
        const now = range();
        draw();
        follow(...now);
      });
      const swatch = element("span", label);
      swatch.className = kind.dashed ? "swatch dashed" : "swatch";
      swatch.dataset.key = kind.key;
      element("span", label, kind.label);
    }
    byId("log").addEventListener("change", (event) => choose(Number(event.target.value)));
    const press = { previous: () => choose(current - 1), next: () => choose(current + 1), closer: () => zoom(0.5),
      wider: () => zoom(2), earlier: () => move(-0.3), later: () => move(0.3), whole: showWhole };
    for (const [id, action] of Object.entries(press)) byId(id).addEventListener("click", action);
    const keys = { ArrowLeft: press.earlier, ArrowRight: press.later, "+": press.closer, "=": press.closer,
      "-": press.wider, 0: press.whole, n: press.next, p: press.previous };
    for (const place of [byId("position"), byId("difference")]) {
      place.addEventListener("keydown", (event) => {
        const action = keys[event.key] || keys[event.key.toLowerCase()];
        if (action === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        action();
      });
      place.addEventListener("dblclick", showWhole);
    }
    for (const link of document.querySelectorAll("a[data-log]"))
      link.addEventListener("click", () => {
        const { log, from, to } = link.dataset;
        choose(Number(log), from === undefined ? null : [Number(from), Number(to)]);
        // After the browser has gone to the curves, which takes the focus away.
        setTimeout(() => byId("position").focus({ preventScroll: true }), 0);
      });
    const worst = data.logs.reduce((best, log, i) => {
      const better = log.held_out === data.logs[best].held_out ? log.gap_mrad > data.logs[best].gap_mrad : log.held_out;
      return better ? i : best;
    }, 0);
    choose(worst); // the held-out log with the largest gap
  }

  function setTheme(isDark) {
    root.classList.toggle("dark", isDark);
    if (charts.length === 0) return;
    const now = range();
    draw();
    follow(...now);
  }

  root.classList.toggle("dark", window.matchMedia("(prefers-color-scheme: dark)").matches);
  if (data.logs.length > 0) build();
  byId("theme").addEventListener("click", () => setTheme(!dark()));
  let darkOnScreen = false; // paper is white
  window.addEventListener("beforeprint", () => { darkOnScreen = dark(); setTheme(false); });
  window.addEventListener("afterprint", () => setTheme(darkOnScreen));
})();
