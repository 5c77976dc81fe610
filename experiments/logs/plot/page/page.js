// Draws the figure embedded in this page as JSON. Texts from logs are inserted as text, never as HTML.
"use strict";
(() => {
  const figure = JSON.parse(document.getElementById("figure").textContent);
  const samples = samplesOf(figure);
  const root = document.documentElement;
  const charts = []; // {graph, panel, outputs, boxes, swatches}
  const logShown = figure.sources.map(() => true);
  const several = figure.sources.length > 1;

  const dark = () => root.classList.contains("dark");
  const colour = (i) => figure.colours[i % figure.colours.length][dark() ? 1 : 0];
  const isDashed = (curve) => curve.dashed || curve.colour >= figure.colours.length;

  function element(kind, parent, text) {
    const made = document.createElement(kind);
    if (text !== undefined) made.textContent = text;
    parent.appendChild(made);
    return made;
  }

  function swatch(parent, curve) {
    const made = element("span", parent);
    made.className = isDashed(curve) ? "swatch dashed" : "swatch";
    made.style.borderColor = colour(curve.colour);
    return made;
  }

  function checkbox(parent, changed) {
    const box = element("input", parent);
    box.type = "checkbox";
    box.checked = true;
    box.addEventListener("change", changed);
    return box;
  }

  const shortNumber = (v) => (v === null || !Number.isFinite(v) ? "–" : String(Number(v.toPrecision(5))));

  const tick = (v) => String(Number(v.toPrecision(6)));

  function showValues(x, points) {
    for (const chart of charts) {
      chart.panel.curves.forEach((curve, c) => {
        let value = null;
        if (samples.isRising(curve)) value = samples.near(curve, x);
        else for (const p of points) if (chart.points === points && p.name === String(c)) value = p.yval;
        chart.outputs[c].textContent = shortNumber(value);
      });
      chart.at.textContent = figure.xLabel + " = " + shortNumber(x);
    }
  }

  function clearValues() {
    for (const chart of charts) {
      for (const output of chart.outputs) output.textContent = "";
      chart.at.textContent = "";
    }
  }

  const inkOptions = () => ({
    axisLineColor: dark() ? "#8a8f98" : "#444444",
    gridLineColor: dark() ? "#363a42" : "#dddddd",
  });

  function drawMarks(context, area, graph) {
    context.strokeStyle = "#888888";
    context.lineWidth = 1;
    context.setLineDash([2, 4]);
    for (const mark of figure.marks) {
      const x = graph.toDomXCoord(mark);
      context.beginPath();
      context.moveTo(x, area.y);
      context.lineTo(x, area.y + area.h);
      context.stroke();
    }
    context.setLineDash([]);
  }

  function addPanel(panel) {
    const section = element("section", document.getElementById("panels"));
    const heading = element("h2", section, panel.title + " ");
    element("small", heading, panel.yLabel + "  ");
    const at = element("small", heading);
    const legend = element("div", section);
    legend.className = "curves";
    const place = element("div", section);
    place.className = "chart";
    const chart = { panel, at, outputs: [], boxes: [], swatches: [], points: null };
    panel.curves.forEach((curve, c) => {
      const label = element("label", legend);
      chart.boxes.push(checkbox(label, () => show(chart, c)));
      chart.swatches.push(swatch(label, curve));
      element("span", label, curve.label + " ");
      chart.outputs.push(element("output", label));
    });
    const series = {};
    panel.curves.forEach((curve, c) => {
      series[String(c)] = {
        strokeWidth: curve.dashed ? 1.3 : 1.8,
        strokePattern: isDashed(curve) ? [7, 4] : null,
        drawPoints: curve.marks,
        pointSize: curve.marks ? 3 : 1.5,
      };
    });
    chart.graph = new Dygraph(place, samples.table(panel), {
      labels: ["x"].concat(panel.curves.map((_, c) => String(c))),
      colors: panel.curves.map((curve) => colour(curve.colour)),
      series,
      ...inkOptions(),
      connectSeparatedPoints: true,
      legend: "never",
      xRangePad: 8,
      rightGap: 10,
      axisLabelFontSize: 13,
      highlightCircleSize: 4,
      yRangePad: 6,
      underlayCallback: drawMarks,
      axes: {
        x: { pixelsPerLabel: 80, axisLabelFormatter: tick },
        y: { axisLabelWidth: 70, pixelsPerLabel: 36, axisLabelFormatter: tick },
      },
      highlightCallback: (_event, x, points) => {
        chart.points = points;
        showValues(x, points);
      },
      unhighlightCallback: clearValues,
    });
    const below = element("div", section, figure.xLabel);
    below.className = "xlabel";
    charts.push(chart);
  }

  function show(chart, c) {
    chart.graph.setVisibility(c, chart.boxes[c].checked && logShown[chart.panel.curves[c].log]);
  }

  function addSources() {
    const place = document.getElementById("sources");
    const head = element("tr", place);
    for (const name of ["log", "robot", "model", "version", "date", "file"]) element("th", head, name);
    figure.sources.forEach((source, i) => {
      const row = element("tr", place);
      const label = element("label", element("td", row));
      if (several) {
        checkbox(label, (event) => {
          logShown[i] = event.target.checked;
          for (const chart of charts) chart.panel.curves.forEach((_, c) => show(chart, c));
        });
        swatch(label, { colour: i, dashed: false }).dataset.colour = String(i);
      }
      element("span", label, source.label);
      for (const key of ["robot", "model", "version", "date", "file"]) element("td", row, source[key] || "–");
    });
  }

  function setTheme(isDark) {
    root.classList.toggle("dark", isDark);
    for (const made of document.querySelectorAll("[data-colour]"))
      made.style.borderColor = colour(Number(made.dataset.colour));
    for (const chart of charts) {
      chart.panel.curves.forEach((curve, c) => (chart.swatches[c].style.borderColor = colour(curve.colour)));
      chart.graph.updateOptions({ colors: chart.panel.curves.map((c) => colour(c.colour)), ...inkOptions() });
    }
  }

  root.classList.toggle("dark", window.matchMedia("(prefers-color-scheme: dark)").matches);
  document.getElementById("title").textContent = figure.title;
  addSources();
  for (const note of figure.notes) element("li", document.getElementById("notes"), note);
  figure.panels.forEach(addPanel);
  if (charts.length > 1)
    Dygraph.synchronize(charts.map((chart) => chart.graph), { zoom: true, selection: false, range: false });
  document.getElementById("reset").addEventListener("click", () => charts.forEach((c) => c.graph.resetZoom()));
  document.getElementById("theme").addEventListener("click", () => setTheme(!dark()));
  let darkOnScreen = false; // paper is white
  window.addEventListener("beforeprint", () => { darkOnScreen = dark(); setTheme(false); });
  window.addEventListener("afterprint", () => setTheme(darkOnScreen));
})();
